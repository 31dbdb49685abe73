#!/usr/bin/env python3
"""Prints the table of goals (goals.csv) as Markdown, from the JSON files of Google Benchmark: goals.py CHART FILE...

A goal is a ratio of two times, or of sums of times, of solvers per evaluation: the ratio of the least of the
repetitions, as others on the machine only add time, with its bootstrap interval. It is met or NOT MET if the whole
interval says so. CHART is the SVG file to draw the solvers' times in.
"""
import csv
import json
import sys
from pathlib import Path
from random import Random

ENOUGH = 7  # repetitions
NANOSECONDS = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}
SOLVERS = {"ik_bat": "IK-BA", "bat": "BA", "particle_swarm": "PSO", "differential_evolution": "DE",
           "k_artificial_bee_colony": "K-ABC", "multi_objective_swarm": "MO-PSO"}
NAMES = {"floor": "what it needs at least", "ours": "ours"}
COLOURS = {"floor": "#999999", "ours": "#0072b2"}


def read(files):
    """The context, the costs of every benchmark in ns, one a repetition, and why others have none."""
    context, costs, errors = {}, {}, {}
    for file in files:
        document = json.loads(Path(file).read_text())
        context |= document["context"]
        for entry in document["benchmarks"]:
            if entry["run_type"] != "iteration":  # a mean or the like
                continue
            # Google Benchmark appends how it was run.
            name = entry["run_name"].split("/iterations:")[0].split("/min_time:")[0].split("/repeats:")[0]
            if entry.get("error_occurred"):
                errors[name] = entry["error_message"]
                continue
            time = entry["real_time" if entry["run_name"].endswith("/real_time") else "cpu_time"]
            cost = time * NANOSECONDS[entry["time_unit"]] / entry.get("evaluations", 1)
            costs.setdefault(name, []).append(cost)
    return context, costs, errors


def ratio(over, under):
    """The ratio of the sums of least times, and its interval over resamples, the same in every call."""
    random = Random(1)
    least = lambda side: sum(min(costs) for costs in side)
    resample = lambda side: sum(min(random.choices(costs, k=len(costs))) for costs in side)
    drawn = sorted(resample(over) / resample(under) for _ in range(1999))
    return least(over) / least(under), drawn[49], drawn[-50]


def row(goal, context, costs, errors):
    """The cells of a goal: what is held against what, the bound, what was measured, the verdict."""
    bound = goal.get(context["instruction_set"])
    cells = [goal["goal"], f"{goal['bound']} {bound}" if bound else ""]
    sides = [[f"solvers/{solver}/{end}" for solver in SOLVERS] if name == f"six/{end}" else [name]
             for name in (goal["over"], goal["under"]) for end in [name.split("/")[-1]]]
    for name in sides[0] + sides[1]:
        if name not in costs:
            return cells + ["", "not measured: " + errors.get(name, f"no run of {name}")]
    value, low, high = ratio(*([costs[name] for name in side] for side in sides))
    cells.append(f"{value:.3g} ({low:.3g} to {high:.3g})")
    if not bound:
        return cells + [""]
    if min(len(costs[name]) for name in sides[0] + sides[1]) < ENOUGH:
        return cells + ["too few repetitions"]
    meets = [end >= float(bound) if goal["bound"] == ">=" else end <= float(bound) for end in (low, high)]
    is_loaded = context["load_avg"][0] > context["num_cpus"] - 0.5  # by others too
    if is_loaded and ("threads" in goal["over"] or not all(meets)):
        return cells + ["cannot be judged: others load this machine"]
    return cells + ["met" if all(meets) else "not decided" if any(meets) else "NOT MET"]


def time_text(nanoseconds):
    unit = max((unit for unit in NANOSECONDS if NANOSECONDS[unit] <= nanoseconds), key=NANOSECONDS.get, default="ns")
    return f"{nanoseconds / NANOSECONDS[unit]:.3g} {unit}"


def chart(costs):
    """Bars of the solvers' times of an evaluation, as SVG."""
    bars = [(SOLVERS[solver], end, min(costs[f"solvers/{solver}/{end}"]))
            for solver in SOLVERS for end in COLOURS if f"solvers/{solver}/{end}" in costs]
    scale = 420 / max((time for _, _, time in bars), default=1)
    height = 17 * len(bars) + 40
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="640" height="{height}" viewBox="0 0 640 {height}" '
             'font-family="sans-serif" font-size="12">', "<title>Time of an evaluation</title>",
             f'<rect width="640" height="{height}" fill="#ffffff"/>']
    for k, (end, colour) in enumerate(COLOURS.items()):
        lines.append(f'<rect x="{80 + 190 * k}" y="8" width="10" height="10" fill="{colour}"/>'
                     f'<text x="{95 + 190 * k}" y="17">{NAMES[end]}</text>')
    for k, (solver, end, time) in enumerate(bars):
        y = 30 + 17 * k
        if k == 0 or bars[k - 1][0] != solver:
            lines.append(f'<text x="72" y="{y + 10}" text-anchor="end">{solver}</text>')
        lines.append(f'<rect x="80" y="{y}" width="{scale * time:.1f}" height="12" fill="{COLOURS[end]}"/>'
                     f'<text x="{84 + scale * time:.1f}" y="{y + 10}">{time_text(time)}</text>')
    return "\n".join(lines + ["</svg>", ""])


def main():
    context, costs, errors = read(sys.argv[2:])
    Path(sys.argv[1]).write_text(chart(costs))
    load = ", ".join(f"{each:.1f}" for each in context["load_avg"])
    print(f"{context['cpu']}, {context['num_cpus']} processors, load {load}; {context['instruction_set']}; "
          f"{context['compiler']}, {context['flags']}; commit {context['commit']}.\n")
    with open(Path(__file__).with_name("goals.csv"), newline="") as file:
        print("| goal | required | measured |  |\n|---|---|---|---|")
        for goal in csv.DictReader(file):
            print(f"| {' | '.join(row(goal, context, costs, errors))} |")
    print("\n| benchmark | least |\n|---|---|")
    for name, each in costs.items():
        per = " an evaluation" if name.startswith(("solvers/", "textbook/")) else ""
        print(f"| {name} | {time_text(min(each))}{per} |")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Prints the table of goals (goals.csv) as Markdown, from the JSON files of Google Benchmark: goals.py FILE...

A goal is a ratio of two times, of solvers per evaluation: the ratio of the medians over the repetitions, with its 95 %
bootstrap interval. It is met or NOT MET if the whole interval says so.
"""
import csv
import json
import sys
from pathlib import Path
from random import Random
from statistics import median

ENOUGH = 7  # repetitions
NANOSECONDS = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}


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
    """The ratio of the medians, and its interval over resamples, the same in every call."""
    random = Random(1)
    resample = lambda costs: median(random.choices(costs, k=len(costs)))
    drawn = sorted(resample(over) / resample(under) for _ in range(1999))
    return median(over) / median(under), drawn[49], drawn[-50]


def row(goal, context, costs, errors):
    """The cells of a goal: what is held against what, the bound, what was measured, the verdict."""
    bound = goal.get(context["instruction_set"])
    cells = [goal["goal"], f"{goal['bound']} {bound}" if bound else ""]
    sides = [goal["over"], goal["under"]]
    for name in sides:
        if name not in costs:
            return cells + ["", "not measured: " + errors.get(name, f"no run of {name}")]
    value, low, high = ratio(*(costs[name] for name in sides))
    cells.append(f"{value:.3g} ({low:.3g} to {high:.3g})")
    if not bound:
        return cells + [""]
    if min(len(costs[name]) for name in sides) < ENOUGH:
        return cells + ["too few repetitions"]
    meets = [end >= float(bound) if goal["bound"] == ">=" else end <= float(bound) for end in (low, high)]
    return cells + ["met" if all(meets) else "not decided" if any(meets) else "NOT MET"]


def time_text(nanoseconds):
    unit = max((unit for unit in NANOSECONDS if NANOSECONDS[unit] <= nanoseconds), key=NANOSECONDS.get, default="ns")
    return f"{nanoseconds / NANOSECONDS[unit]:.3g} {unit}"


def main():
    context, costs, errors = read(sys.argv[1:])
    load = ", ".join(f"{each:.1f}" for each in context["load_avg"])
    print(f"{context['cpu']}, {context['num_cpus']} processors, load {load}; {context['instruction_set']}; "
          f"{context['compiler']}, {context['flags']}; commit {context['commit']}.\n")
    with open(Path(__file__).with_name("goals.csv"), newline="") as file:
        print("| goal | required | measured |  |\n|---|---|---|---|")
        for goal in csv.DictReader(file):
            print(f"| {' | '.join(row(goal, context, costs, errors))} |")
    print("\n| benchmark | median |\n|---|---|")
    for name, each in costs.items():
        per = " an evaluation" if name.startswith("solvers/") else ""
        print(f"| {name} | {time_text(median(each))}{per} |")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Prints the table of goals (goals.csv) from the JSON files of one run of the benchmark programs.

A row of goals.csv is a goal. `measure` says what is held against its bound:
  ratio      the time of `over` / that of `under`
  counter    the counter `under` of `over`
  largest    the largest of the counters `under` of all benchmarks `over`
  different  how many values the text `under` has in all benchmarks `over`
  growth     the time of `over` by its counter `under`: the largest / the smallest of all these benchmarks
Times and counters are medians over the repetitions, ratios and growth those of the medians. What is timed has the 95 %
bootstrap interval beside it. It gets a verdict only if there are enough repetitions and the processors that a benchmark
needs (its counter `needed_cores`) were free (`free_cores`): met if the whole interval meets the bound, NOT MET if the
whole interval misses it.
"""
import argparse
import csv
import json
import sys
from fnmatch import fnmatchcase
from pathlib import Path
from random import Random
from statistics import median

NANOSECONDS = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}
ENOUGH = 7  # repetitions
MANNERS = ("/min_time:", "/iterations:", "/repeats:", "/process_time", "/real_time", "/manual_time")


class Measurements:
    """What benchmark programs have written, by the name of the benchmark."""

    def __init__(self):
        self.context, self.errors, self._repetitions = {}, {}, {}

    def add(self, document):
        if not isinstance(document, dict) or not isinstance(document.get("benchmarks"), list):
            raise ValueError("expected an object with a list `benchmarks`, as --benchmark_out writes it")
        self.context.update(document.get("context", {}))
        for entry in document["benchmarks"]:
            if entry.get("run_type", "iteration") != "iteration":  # means and the like
                continue
            name = entry.get("run_name", entry["name"])
            for manner in MANNERS:  # Google Benchmark appends how it was run
                name = name.split(manner)[0]
            if entry.get("error_occurred"):
                self.errors[name] = entry.get("error_message", "")
                continue
            repetitions = self._repetitions.setdefault(name, [])
            repetitions.append(entry)
            repetitions.sort(key=lambda each: each.get("repetition_index", 0))

    def names(self, pattern="*"):
        return [name for name in self._repetitions if fnmatchcase(name, pattern)]

    def nanoseconds(self, name):
        """CPU time, or the clock's where a benchmark asks for it: as Google Benchmark does for its rates."""
        times = []
        for entry in self._repetitions.get(name, []):
            by_clock = entry.get("run_name", "").endswith(("/real_time", "/manual_time"))
            time = entry.get("real_time" if by_clock else "cpu_time")
            if time is not None:
                times.append(time * NANOSECONDS[entry.get("time_unit", "ns")])
        return times

    def repetitions(self, name):
        return len(self._repetitions.get(name, []))

    def values(self, name, key):
        return [entry[key] for entry in self._repetitions.get(name, []) if key in entry]


def estimate(statistic, *samples):
    """A statistic of the medians of samples, and its 95 % interval over resamples, the same in every call; None if a
    sample is empty."""
    if not all(samples):
        return None
    random = Random(1)
    drawn = sorted(statistic(*(median(random.choices(each, k=len(each))) for each in samples)) for _ in range(1999))
    return statistic(*map(median, samples)), drawn[49], drawn[-50]


def quotient(a, b):
    return a / b


def growth(*costs):
    return max(costs) / min(costs)


def measured(goal, runs):
    """A number and its interval; None where it was not measured."""
    over, under = goal["over"], goal["under"]
    names = runs.names(over)
    match goal["measure"]:
        case "ratio":
            return estimate(quotient, runs.nanoseconds(over), runs.nanoseconds(under))
        case "counter":
            return estimate(float, runs.values(over, under))
        case "largest":
            values = [value for name in names for key in under.split() for value in runs.values(name, key)]
            return (max(values),) * 3 if values else None
        case "different":
            return (len({runs.values(name, under)[0] for name in names}),) * 3 if len(names) > 1 else None
        case "growth":
            costs = [[time / runs.values(name, under)[0] for time in runs.nanoseconds(name)] for name in names]
            return estimate(growth, *costs) if len(costs) > 1 else None
    raise ValueError(f"goals.csv: unknown measure {goal['measure']}")


def why_not(goal, runs):
    needs = [goal["over"]] + [goal["under"]] * (goal["measure"] == "ratio")
    for name in needs:
        if name in runs.errors:
            return runs.errors[name]
    if goal["peer"] and "instruction_set" in runs.context and goal["peer"] not in runs.context.get("peers", ""):
        return goal["peer"] + " is not installed"
    return next((f"no run of {name}" for name in needs if not runs.nanoseconds(name)), "no run of it")


def verdict(goal, low, high, bound, runs):
    """Whether the goal is met, or why the measured times do not say it."""
    meets = [value >= bound if goal["bound"] == ">=" else value <= bound for value in (low, high)]
    if goal["measure"] in ("ratio", "growth") and min(map(runs.repetitions, runs.names(goal["over"]))) < ENOUGH:
        return "too few repetitions"
    for name in (goal["over"], goal["under"]):
        for needed, free in zip(runs.values(name, "needed_cores"), runs.values(name, "free_cores")):
            if not free >= 0.97 * needed:  # also if it is not known
                return f"not measurable now: processors needed {number_text(needed)}, free {number_text(free)}"
    return "met" if all(meets) else "not measurable now" if any(meets) else "NOT MET"


def number_text(value):
    size = abs(value)
    if size < 1e9 and value == int(value):
        return f"{value:.0f}"
    if size < 0.01:
        return f"{value:.1e}"
    return f"{value:.2f}" if size < 10 else f"{value:.1f}"


def time_text(nanoseconds):
    for unit in ("ns", "us", "ms"):
        if nanoseconds < 1e3 * NANOSECONDS[unit]:
            return f"{nanoseconds / NANOSECONDS[unit]:.3g} {unit}"
    return f"{nanoseconds / 1e9:.3g} s"


def row(goal, runs):
    """The cells of a goal: name, goal, required, measured, verdict."""
    unit = f" {goal['unit']}" if goal["unit"] else ""
    bound = goal.get(runs.context.get("instruction_set"), goal["x86-64"])
    required = f"{goal['bound']} {number_text(float(bound))}{unit}" if bound else "no goal"
    found = measured(goal, runs)
    if found is None:
        return [goal["name"], goal["goal"], required, "", "not measured: " + why_not(goal, runs)]
    value, low, high = found
    text = number_text(value) + unit
    if low < high:
        text += f" ({number_text(low)} to {number_text(high)})"
    return [goal["name"], goal["goal"], required, text, verdict(goal, low, high, float(bound), runs) if bound else ""]


def machine(runs):
    noted = lambda key: runs.context.get(key, "unknown")
    load = ",".join(str(each) for each in runs.context.get("load_avg", ["unknown"]))
    return (f"{noted('cpu')}, {noted('num_cpus')} processors, load {load}; instruction set {noted('instruction_set')}; "
            f"{noted('compiler')}, {noted('flags')}; commit {noted('commit')}; {noted('date')}; "
            f"peers: {runs.context.get('peers') or 'none'}.")


HEADER = ["#", "goal", "required", "measured", ""]


def as_text(rows):
    widths = [max(map(len, column)) for column in zip(HEADER, *rows)]
    lines = ["  ".join(f"{cell:<{width}}" for cell, width in zip(row, widths)).rstrip() for row in [HEADER, *rows]]
    return "\n".join(lines) + "\n"


def as_markdown(rows):
    lines = [f"| {' | '.join(row)} |\n" for row in [HEADER, *rows]]
    return lines[0] + "|---|---|---|---|---|\n" + "".join(lines[1:])


def times_as_markdown(runs):
    text = "| benchmark | median | per candidate |\n|---|---|---|\n"
    for name in runs.names():
        times = runs.nanoseconds(name)
        if not times or name.startswith("accuracy/"):
            continue
        each = runs.values(name, "per_candidate")
        text += f"| {name} | {time_text(median(times))} | {time_text(1e9 * median(each)) if each else ''} |\n"
    return text


def rows_of(runs):
    with open(Path(__file__).with_name("goals.csv"), newline="") as file:
        return [row(goal, runs) for goal in csv.DictReader(file)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="*", type=Path, metavar="FILE", help="JSON files of one run")
    parser.add_argument("--markdown", action="store_true", help="print Markdown, with the median times")
    arguments = parser.parse_args()
    runs = Measurements()
    for file in arguments.files:
        try:
            runs.add(json.loads(file.read_text()))
        except (OSError, ValueError) as fault:
            sys.exit(f"goals: {file}: {fault}")
    rows = rows_of(runs)
    tables = f"{machine(runs)}\n\n{as_markdown(rows)}\n{times_as_markdown(runs)}"
    print(tables if arguments.markdown else f"{machine(runs)}\n\n{as_text(rows)}", end="")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Measures what a report costs by the number of its labels, whose pairs grow with the square: labels.py PROGRAM"""
import os
import pathlib
import subprocess
import sys
import tempfile

GOALS = 5, 400  # of 400 labels: seconds, MB
RATIO = 5  # at most, of the seconds of 400 labels to those of 200: pairs are 4 times as many
STUDY = """robot = "ur5e"
search = "pose"
path = { kind = "random", points = 40 }
stop = { iterations = 20, tolerance_cm = 0.01, tolerance_deg = 0.1 }
"""
SOLVER = '[[solvers]]\nlabel = "L{0}"\nsolver = "levenberg_marquardt"\noptions = {{ damping = {1} }}\n'


def taken(words):
    """Seconds of the processor and MB of a command."""
    child = subprocess.Popen(words, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    assert status == 0, words
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1000


program = pathlib.Path(sys.argv[1]).resolve()
print("| labels x 40 solves | values | pairs of a metric | run | report --figures none | peak memory |\n|--:|---|--:|--:|--:|--:|")
missed = []
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    for values, step in ("different", 1 / 50), ("alike", 0):
        before = seconds = memory = 0
        for labels in 50, 100, 200, 400:
            entries = "".join(SOLVER.format(i, 0.001 * (1 + i * step)) for i in range(labels))
            pathlib.Path("labels.toml").write_text(STUDY + entries)
            out = f"{values}-{labels}"
            run, _ = taken([program, "run", "labels.toml", "--set", "runs=1", "--no-report", "--out", out])
            before = seconds
            seconds, memory = taken([program, "report", f"{out}/store.sqlite", "--figures", "none", "--out", out])
            pairs = labels * (labels - 1) // 2
            print(f"| {labels} | {values} | {pairs} | {run:.2g} s | {seconds:.2g} s | {memory:.0f} MB |", flush=True)
        if seconds > GOALS[0] or memory > GOALS[1]: missed.append(f"{values}: {seconds:.2g} s, {memory:.0f} MB")
        if seconds > RATIO * before: missed.append(f"{values}: 400 labels take {seconds / before:.2g} times as long as 200")
print(f"\nGoal, of 400 labels: at most {GOALS[0]} s, {GOALS[1]} MB and {RATIO} times as long as of 200")
if missed: print("MISSED: " + "; ".join(missed))

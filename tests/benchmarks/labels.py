#!/usr/bin/env python3
"""Measures what a report costs by the number of its labels, whose pairs grow with the square: labels.py PROGRAM"""
import os
import pathlib
import subprocess
import sys
import tempfile
import time

GOALS = 5, 400  # of 400 labels: seconds, MB
STUDY = """robot = "ur5e"
search = "pose"
path = { kind = "random", points = 40 }
stop = { iterations = 20, tolerance_cm = 0.01, tolerance_deg = 0.1 }
"""
SOLVER = '[[solvers]]\nlabel = "L{0}"\nsolver = "levenberg_marquardt"\noptions = {{ damping = {1} }}\n'


def taken(words):
    """Seconds and MB of a command."""
    began = time.monotonic()
    child = subprocess.Popen(words, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    assert status == 0, words
    return time.monotonic() - began, usage.ru_maxrss / 1000


program = pathlib.Path(sys.argv[1]).resolve()
print("| labels x 40 solves | pairs of a metric | run | report --figures none | peak memory |\n|--:|--:|--:|--:|--:|")
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    for labels in 50, 100, 200, 400:
        entries = "".join(SOLVER.format(i, 0.001 * (1 + i / 50)) for i in range(labels))
        pathlib.Path("labels.toml").write_text(STUDY + entries)
        run, _ = taken([program, "run", "labels.toml", "--set", "runs=1", "--no-report", "--out", f"of-{labels}"])
        seconds, memory = taken([program, "report", f"of-{labels}/store.sqlite", "--figures", "none", "--out", f"of-{labels}"])
        print(f"| {labels} | {labels * (labels - 1) // 2} | {run:.2g} s | {seconds:.2g} s | {memory:.0f} MB |", flush=True)
print(f"\nGoal, of 400 labels: at most {GOALS[0]} s and {GOALS[1]} MB"
      + ("" if seconds <= GOALS[0] and memory <= GOALS[1] else ": MISSED"))

#!/usr/bin/env python3
"""A particle swarm for ikbench, with Python's standard library alone: ikbench evaluates the candidates."""
import json
import random
import sys


def say(**message):
    print(json.dumps(message), flush=True)


def evaluate(candidates):
    """The errors of the candidates, or None where the solve is over."""
    say(message="evaluate", candidates=candidates)
    told = json.loads(sys.stdin.readline())
    return None if told["over"] else told["errors"]


def solve(problem, w, c):
    draw, lower, upper = random.Random(problem["seed"]), problem["lower"], problem["upper"]
    size, joints = problem["population"], range(len(lower))
    swarm = [problem["start"]]
    while len(swarm) < size:
        swarm.append([draw.uniform(low, high) for low, high in zip(lower, upper)])
    speeds = [[0.0] * len(joints) for _ in swarm]
    own, own_errors = list(swarm), [float("inf")] * size
    while errors := evaluate(swarm):
        for i, error in enumerate(errors):
            if error is not None and error < own_errors[i]:
                own[i], own_errors[i] = swarm[i], error
        best = own[min(range(size), key=own_errors.__getitem__)]
        for i in range(size):
            speeds[i] = [w * speeds[i][j] + c * draw.random() * (own[i][j] - swarm[i][j])
                         + c * draw.random() * (best[j] - swarm[i][j]) for j in joints]
            swarm[i] = [min(max(swarm[i][j] + speeds[i][j], lower[j]), upper[j]) for j in joints]
    say(message="solved")  # without q: the best candidate


say(message="hello", ikbench=2, name="python_pso", version="2.0", options=[
    {"name": "w", "type": "number", "default": 0.7, "low": 0, "high": 2, "meaning": "inertia"},
    {"name": "c", "type": "number", "default": 1.5, "low": 0, "high": 4, "meaning": "pull of both bests"}])
for line in sys.stdin:
    told = json.loads(line)
    if told["message"] == "robot":
        options = told["options"]
    elif told["message"] == "solve":
        solve(told, **options)

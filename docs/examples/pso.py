#!/usr/bin/env python3
"""A particle swarm for ikbench, with Python's standard library alone: ikbench evaluates the candidates."""
import json
import random
import sys


def say(**message):
    print(json.dumps(message), flush=True)


def ask(id, candidates):
    """The errors of the candidates, or None where the solve is over."""
    say(message="ask", id=id, candidates=candidates)
    told = json.loads(sys.stdin.readline())
    return None if told["over"] else told["errors"]


def clamped(q, problem):
    return [min(max(x, low), high) for x, low, high in zip(q, problem["lower"], problem["upper"])]


def solve(problem, w, c):
    draw = random.Random(problem["seed"])
    size, joints = problem["population"], range(len(problem["start"]))
    swarm = [problem["start"]]
    while len(swarm) < size:
        swarm.append([draw.uniform(low, high) for low, high in zip(problem["lower"], problem["upper"])])
    speeds = [[0.0] * len(joints) for _ in swarm]
    own, own_errors = list(swarm), [float("inf")] * size
    while True:
        errors = ask(problem["id"], swarm)
        if errors is None:
            break
        for i, error in enumerate(errors):
            if error is not None and error < own_errors[i]:
                own[i], own_errors[i] = swarm[i], error
        best = own[min(range(size), key=own_errors.__getitem__)]
        for i in range(size):
            speeds[i] = [w * speeds[i][j] + c * draw.random() * (own[i][j] - swarm[i][j])
                         + c * draw.random() * (best[j] - swarm[i][j]) for j in joints]
            swarm[i] = clamped([x + v for x, v in zip(swarm[i], speeds[i])], problem)
    say(message="solved", id=problem["id"])


say(ikbench=1, message="hello", name="python_pso", version="1.0", modes=["ask"], options=[
    {"name": "w", "type": "number", "default": 0.7, "low": 0, "high": 2, "meaning": "inertia"},
    {"name": "c", "type": "number", "default": 1.5, "low": 0, "high": 4, "meaning": "pull of both bests"}])
for line in sys.stdin:
    told = json.loads(line)
    if told["message"] == "robot":
        options = told["options"]
        say(message="ready")
    elif told["message"] == "start":
        solve(told, **options)
    elif told["message"] == "bye":
        break

#!/usr/bin/env python3
"""Cyclic coordinate descent for ikbench, with kinematics of its own; positions of arms whose joints turn."""
import json, math, sys, time

square = lambda m: [m[0:4], m[4:8], m[8:12], m[12:16]]

def say(**message):
    print(json.dumps(message), flush=True)

def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]

def frames(q):
    """The frames before each joint, and that of the tool."""
    all = [square(arm["base"])]
    for joint, value in zip(arm["joints"], q):
        t, al, a, d = joint["theta"] + value, joint["alpha"], joint["a"], joint["d"]
        c, s, ca, sa = math.cos(t), math.sin(t), math.cos(al), math.sin(al)
        all.append(times(all[-1], [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]))
    return all[:-1] + [times(all[-1], square(arm["tool"]))]

def solve(problem):
    target, q, began, count = problem["target"]["position"], list(problem["start"]), time.monotonic(), 0
    budget, wanted = problem["budget"], problem["tolerance"]["position"]
    off = lambda frame: [target[k] - frame[k][3] for k in range(3)]
    dot = lambda a, b: sum(x * y for x, y in zip(a, b))
    for iteration in range(budget["iterations"] + 1):
        error, count = math.hypot(*off(frames(q)[-1])), count + 1
        late = 0 < budget["seconds"] <= time.monotonic() - began or 0 < budget["evaluations"] < count + len(q)
        if error <= wanted or late or iteration == budget["iterations"]:
            return say(message="solved", q=q, error=error, iterations=iteration, evaluations=count)
        for j in reversed(range(len(q))):  # the turn about each axis that brings the tool nearest
            all, count = frames(q), count + 1
            axis, to = [row[2] for row in all[j][:3]], off(all[j])
            tool = [all[-1][k][3] - all[j][k][3] for k in range(3)]
            cross = [tool[k - 2] * to[k - 1] - tool[k - 1] * to[k - 2] for k in range(3)]
            turn = math.atan2(dot(axis, cross), dot(tool, to) - dot(axis, tool) * dot(axis, to))
            q[j] = min(max(q[j] + turn, problem["lower"][j]), problem["upper"][j])

say(message="hello", ikbench=2, name="python_descent", version="1.0", goals=["position"])
for line in sys.stdin:
    told = json.loads(line)
    if told["message"] == "robot":
        arm, can = told, all(joint["type"] == "revolute" for joint in told["joints"])
    elif told["message"] == "solve":
        solve(told) if can else say(message="declined", why="joints that turn, alone")

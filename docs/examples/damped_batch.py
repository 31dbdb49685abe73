#!/usr/bin/env python3
"""Damped least squares for ikbench in NumPy, up to 500 problems at once; positions of revolute joints alone."""
import json, sys, time
import numpy as np


def say(**message):
    print(json.dumps(message), flush=True)


def forward(q):  # q: problems x joints; returns tools and Jacobians
    pose = np.broadcast_to(np.reshape(arm["base"], (4, 4)), (len(q), 4, 4))
    axes, origins = [], []
    for j, joint in enumerate(arm["joints"]):
        axes.append(pose[:, :3, 2])
        origins.append(pose[:, :3, 3])
        c, s = np.cos(joint["theta"] + q[:, j]), np.sin(joint["theta"] + q[:, j])
        ca, sa, link = np.cos(joint["alpha"]), np.sin(joint["alpha"]), np.zeros((len(q), 4, 4))
        link[:, 0] = np.stack([c, -s * ca, s * sa, joint["a"] * c], 1)
        link[:, 1] = np.stack([s, c * ca, -c * sa, joint["a"] * s], 1)
        link[:, 2], link[:, 3] = [0, sa, ca, joint["d"]], [0, 0, 0, 1]
        pose = pose @ link
    tool = (pose @ np.reshape(arm["tool"], (4, 4)))[:, :3, 3]
    return tool, np.stack([np.cross(axis, tool - origin) for axis, origin in zip(axes, origins)], 2)


def solve(problems):  # all of a study have the same limits and budget
    q = np.array([problem["start"] for problem in problems], float)
    target = np.array([problem["target"]["position"] for problem in problems])
    lower, upper, budget = problems[0]["lower"], problems[0]["upper"], problems[0]["budget"]
    until = time.monotonic() + (budget["seconds"] * len(problems) or float("inf"))
    for i in range(budget["iterations"] + 1):
        tool, jacobian = forward(q)
        off = target - tool
        open_ones = np.flatnonzero(np.linalg.norm(off, axis=1) > problems[0]["tolerance"]["position"])
        if i == budget["iterations"] or not len(open_ones) or time.monotonic() >= until:
            return q, np.linalg.norm(off, axis=1)
        J, J_T = jacobian[open_ones], jacobian[open_ones].transpose(0, 2, 1)
        move = (J_T @ np.linalg.solve(J @ J_T + 1e-4 * np.eye(3), off[open_ones, :, None]))[:, :, 0]
        move *= np.minimum(1, 0.2 / np.abs(move).max(axis=1, keepdims=True))
        q[open_ones] = np.clip(q[open_ones] + move, lower, upper)


say(ikbench=1, message="hello", name="numpy_damped", version="1.0", modes=["solve"], batch=500, deterministic=True)
for line in sys.stdin:
    told = json.loads(line)
    if told["message"] == "robot":
        arm = told
        can = arm["goal"] == "position" and {joint["type"] for joint in arm["joints"]} == {"revolute"}
        say(message="ready" if can else "declined", why="positions of revolute joints alone")
    elif told["message"] == "ping":
        say(message="pong", id=told["id"])
    elif told["message"] in ("solve", "solve_batch"):
        problems = told.get("problems", [told])
        answers = [{"q": list(q), "error": error} for q, error in zip(*solve(problems))]
        if "problems" in told: say(message="solved_batch", id=told["id"], solutions=answers)
        else: say(message="solved", id=told["id"], **answers[0])
    elif told["message"] == "bye":
        break

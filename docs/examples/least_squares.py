#!/usr/bin/env python3
"""SciPy's least_squares for ikbench, with kinematics of its own, from the Denavit-Hartenberg table that it is told."""
import json
import sys

import numpy as np
import scipy
from scipy.optimize import least_squares


def say(**message):
    print(json.dumps(message), flush=True)


def forward(q):
    pose = np.reshape(arm["base"], (4, 4))
    for joint, value in zip(arm["joints"], q):
        slides = joint["type"] == "prismatic"
        theta, d = joint["theta"] + (0 if slides else value), joint["d"] + (value if slides else 0)
        c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(joint["alpha"]), np.sin(joint["alpha"])
        pose = pose @ np.array([[c, -s * ca, s * sa, joint["a"] * c], [s, c * ca, -c * sa, joint["a"] * s],
                                [0, sa, ca, d], [0, 0, 0, 1]])
    return pose @ np.reshape(arm["tool"], (4, 4))


def solve(problem):
    target = problem["target"]

    def residual(q):
        pose = forward(q)
        off = pose[:3, 3] - target["position"]
        if arm["goal"] == "position":
            return off
        turned = pose[:3, :3] - np.reshape(target["rotation"], (3, 3))
        return np.concatenate([off, arm["rotation_weight"] * turned.ravel()])

    lower, upper = np.array(problem["lower"]), np.array(problem["upper"])
    start = np.clip(problem["start"], lower + 1e-9, upper - 1e-9)
    found = least_squares(residual, start, bounds=(lower, upper), xtol=1e-12, ftol=1e-12, gtol=1e-12,
                          max_nfev=max(1, problem["budget"]["iterations"]))
    error = float(np.linalg.norm(forward(found.x)[:3, 3] - target["position"]))
    say(message="solved", id=problem["id"], q=list(found.x), error=error, iterations=int(found.njev), reason="finished")


say(ikbench=1, message="hello", name="scipy_least_squares", version=scipy.__version__, modes=["solve"],
    deterministic=True)
for line in sys.stdin:
    told = json.loads(line)
    if told["message"] == "robot":
        arm = told
        coupled = any(joint["type"] == "coupled" for joint in arm["joints"])
        say(message="declined", why="no coupled joints") if coupled else say(message="ready")
    elif told["message"] == "ping":
        say(message="pong", id=told["id"])
    elif told["message"] == "solve":
        solve(told)
    elif told["message"] == "bye":
        break

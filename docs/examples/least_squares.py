#!/usr/bin/env python3
"""SciPy's least_squares for ikbench, with kinematics of its own, from the Denavit-Hartenberg table that it is told."""
import contextlib, json, math, sys, time

import numpy as np
import scipy
from scipy.optimize import least_squares


def say(**message):
    print(json.dumps(message), flush=True)


def forward(q):
    pose = np.reshape(arm["base"], (4, 4))
    for joint, value in zip(arm["joints"], q):
        turn, slide = (0, value) if joint["type"] == "prismatic" else (value, 0)
        theta, d = joint["theta"] + turn, joint["d"] + slide
        (c, ca), (s, sa) = np.cos([theta, joint["alpha"]]), np.sin([theta, joint["alpha"]])
        pose = pose @ np.array([[c, -s * ca, s * sa, joint["a"] * c], [s, c * ca, -c * sa, joint["a"] * s],
                                [0, sa, ca, d], [0, 0, 0, 1]])
    return pose @ np.reshape(arm["tool"], (4, 4))


def solve(problem):
    target, seconds, began = problem["target"], problem["budget"]["seconds"], time.monotonic()
    best = [float("inf"), problem["start"]]

    def residual(q):
        if 0 < seconds < time.monotonic() - began:
            raise TimeoutError
        pose = forward(q)
        off = pose[:3, 3] - target["position"]
        if arm["goal"] == "pose":
            turned = pose[:3, :3] - np.reshape(target["rotation"], (3, 3))
            off = np.concatenate([off, arm["rotation_weight"] * turned.ravel()])
        best[:] = min(best, [off @ off, list(q)])
        return off

    limits = problem["lower"], problem["upper"]
    with contextlib.suppress(TimeoutError):
        least_squares(residual, np.clip(problem["start"], *limits), bounds=limits, xtol=1e-12, ftol=1e-12, gtol=1e-12,
                      max_nfev=max(1, problem["budget"]["iterations"]))
    say(message="solved", id=problem["id"], q=best[1], error=math.dist(forward(best[1])[:3, 3], target["position"]))


say(ikbench=1, message="hello", name="scipy_least_squares", version=scipy.__version__, modes=["solve"],
    deterministic=True)
for line in sys.stdin:
    told = json.loads(line)
    if told["message"] == "robot":
        arm = told
        say(message="declined" if "coupled" in (j["type"] for j in arm["joints"]) else "ready", why="coupled joints")
    elif told["message"] == "solve":
        solve(told)
    elif told["message"] == "bye":
        break

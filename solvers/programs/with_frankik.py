# /// script
# requires-python = "==3.12.*"
# dependencies = ["frankik==1.0.1"]
# ///
"""frankik: the closed form of He and Liu for Franka's arms, all its answers, with the last joint locked at its start, then at
random values until there are answers."""
from importlib.metadata import version

import frankik

import ikbench
import numpy as np
from product_of_exponentials import tool_beyond


# From the hand that its forward kinematics ends at to the flange that its inverse expects.
flange = np.array([[0.5**0.5, -(0.5**0.5), 0, 0], [0.5**0.5, 0.5**0.5, 0, 0], [0, 0, 1, -0.1034], [0, 0, 0, 1]])


def prepare(robot):
    robot.require(turning=True)
    tool = tool_beyond(robot, lambda q: frankik.fk(q) @ flange) if len(robot.joints) == 7 else None
    if tool is None:
        raise ikbench.Declined("no arm of Franka's")
    return np.linalg.inv(tool), bool(np.allclose(robot.upper, frankik.q_max_fr3, atol=1e-3))


def solve(prepared, problem):
    tool, is_fr3 = prepared
    target = np.array(problem.matrix) @ tool
    for start in problem.starts():
        found = frankik.ik_full(target, np.array(start), start[6], is_fr3)
        if answers := [q for q in found if np.all(np.isfinite(q))]:
            return answers


ikbench.run("frankik", prepare, solve, version=version("frankik"), goals=["pose"])

# /// script
# requires-python = "==3.11.*"
# dependencies = ["ur-analytic-ik==0.1.0.post3"]
# ///
"""ur-analytic-ik: the closed form of Universal Robots' arms, all its answers. Its base may be turned by half a turn."""
from importlib.metadata import version

import ur_analytic_ik

import ikbench
import numpy as np
from product_of_exponentials import tool_beyond


def prepare(robot):
    robot.require(turning=True)
    for name in dir(ur_analytic_ik) if len(robot.joints) == 6 else []:
        for base in np.eye(4), np.diag([-1, -1, 1, 1]):
            arm = getattr(ur_analytic_ik, name)
            tool = tool_beyond(robot, lambda q: base @ arm.forward_kinematics(*q)) if name.startswith("ur") else None
            if tool is not None:
                return arm, base, np.linalg.inv(tool)
    raise ikbench.Declined("no arm of Universal Robots'")


def solve(prepared, problem):
    arm, base, tool = prepared
    return arm.inverse_kinematics(base @ np.array(problem.matrix) @ tool) or None


ikbench.run("ur_analytic_ik", prepare, solve, version=version("ur-analytic-ik"), goals=["pose"])

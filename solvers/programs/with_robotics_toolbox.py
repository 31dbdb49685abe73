# /// script
# dependencies = ["roboticstoolbox-python==1.5.0"]
# ///
"""Robotics Toolbox: ik_LM, its Levenberg-Marquardt in C++ by Chan, 100 searches of 30 iterations, as it comes; again
while time is left. Its tolerance is of half the squared norm of the twist."""
from importlib.metadata import version

import roboticstoolbox

import ikbench
import numpy as np


def prepare(robot):
    robot.require()
    return roboticstoolbox.Robot.URDF(robot.file).ets(start=robot.base_link, end=robot.tip_link), robot.options


def solve(prepared, problem):
    arm, options = prepared
    tolerance = 0.5 * min(problem.tolerance.position, problem.tolerance.rotation) ** 2
    for start in problem.starts():
        found = arm.ik_LM(np.array(problem.matrix), q0=np.array(start), tol=tolerance, **options)
        if found.success:
            return found.q


ikbench.run("robotics_toolbox", prepare, solve, version=version("roboticstoolbox-python"), goals=["pose"],
            options={"k": (1.0, 0, 1e3, "factor of the damping"), "method": ["chan", "wampler", "sugihara"]})

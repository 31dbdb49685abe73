# /// script
# dependencies = ["pytracik==0.0.3"]
# ///
"""TRAC-IK (pytracik): solve type Speed, in its two threads, until the time is up.

Its epsilon bounds each component of the twist, so it is the tolerance by the square root of 3."""
import functools
from importlib.metadata import version

import pytracik

import ikbench
import numpy as np
from quaternion import quaternion


def prepare(robot):
    robot.require()
    @functools.cache
    def solver(seconds, tolerance):  # both belong to its construction
        return pytracik.TRAC_IK(robot.base_link, robot.tip_link, robot.urdf, seconds, tolerance / 3**0.5,
                                pytracik.SolveType.Speed)
    return solver


def solve(solver, problem):
    tolerance = min(problem.tolerance.position, problem.tolerance.rotation)
    found = pytracik.ik(solver(problem.budget.seconds or 0.1, tolerance), np.array(problem.start), *problem.position,
                        *quaternion(problem.rotation))
    return found[1:] if found[0] >= 0 else None


ikbench.run("trac_ik", prepare, solve, version="pytracik " + version("pytracik"), goals=["pose"])

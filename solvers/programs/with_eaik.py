# /// script
# dependencies = ["eaik==1.2.2"]
# ///
"""EAIK: closed forms by subproblems, all its answers. Of seven joints one is locked, as its documentation does: the last
with which it answers a pose, at its start, then at random values until an answer is inside the limits."""
import eaik.pybindings.EAIK as eaik

import ikbench
import numpy as np
from product_of_exponentials import axes_of, frames


def robot_of(arm, lock, value):
    axes, ways, tool = arm
    return eaik.Robot(axes.T, ways.T, tool, [] if lock is None else [(lock, value)], True)


def exact(derived, target, lock, value):  # which may be left out
    found = derived.calculate_IK(target)
    answers = [q for q, is_least in zip(found.Q, found.is_LS) if not is_least]
    return answers if lock is None else [q if len(q) == 7 else [*q[:lock], value, *q[lock:]] for q in answers]


def prepare(robot):
    robot.require(turning=True)
    arm, n = axes_of(robot), len(robot.joints)
    target = frames(robot, [0.3] * n)[-1]
    for lock in [None] if n <= 6 else reversed(range(n if n == 7 else 0)):
        derived = robot_of(arm, lock, 0.3)
        if derived.has_known_decomposition() and exact(derived, target, lock, 0.3):
            return arm, lock, derived
    raise ikbench.Declined("no kinematic family that EAIK knows")


def solve(prepared, problem):
    arm, lock, derived = prepared
    target = np.array(problem.matrix)
    for start in problem.starts():
        if lock is not None:
            derived = robot_of(arm, lock, start[lock])
        found = exact(derived, target, lock, lock is not None and start[lock])
        if lock is None or any(map(problem.inside, found)):
            return found or None


ikbench.run("eaik", prepare, solve, version="1.2.2", goals=["pose"])

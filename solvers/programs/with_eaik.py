# /// script
# dependencies = ["eaik==1.2.2"]
# ///
"""EAIK: closed forms by subproblems, all its answers. Of seven joints one is locked, as its documentation does: the first
with which the family is known, at its start, then at random values until an answer is inside the limits."""
import eaik.pybindings.EAIK as eaik

import ikbench
import numpy as np
from product_of_exponentials import axes_of, turned


def robot_of(arm, fixed):
    axes, ways, turn = arm
    return eaik.Robot(axes.T, ways.T, turn, fixed, True)


def prepare(robot):
    robot.require(turning=True, bounded=True)
    arm, n = axes_of(robot), len(robot.joints)
    for lock in [None] if n <= 6 else range(n):
        derived = robot_of(arm, [] if lock is None else [(lock, 0.3)])
        if n <= 7 and derived.has_known_decomposition():
            return robot, arm, lock, derived
    raise ikbench.Declined("no kinematic family that EAIK knows")


def solve(prepared, problem):
    robot, arm, lock, derived = prepared
    target = np.array(problem.matrix)
    for start in problem.starts():
        if lock is not None:
            derived = robot_of(arm, [(lock, start[lock])])
        found = derived.calculate_IK(target)
        exact = [np.array(q) for q, is_least in zip(found.Q, found.is_LS) if not is_least]
        if lock is not None:  # the value of the locked joint may be left out
            exact = [q if len(q) == 7 else np.insert(q, lock, start[lock]) for q in exact]
        answers = turned(exact, robot, problem)
        if lock is None or any(np.all(problem.lower <= q) and np.all(q <= problem.upper) for q in answers):
            return answers or None


ikbench.run("eaik", prepare, solve, version="1.2.2", goals=["pose"])

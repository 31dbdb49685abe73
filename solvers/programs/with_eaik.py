# /// script
# dependencies = ["eaik==1.2.2"]
# ///
"""EAIK: closed forms by subproblems, all its answers. Of seven joints one is locked, as its documentation does: the last
with which it answers a pose, at one of 64 values inside its limits, each an arm derived once: that nearest to its start, then
random ones until an answer is inside the limits."""
from importlib.metadata import version

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
            values = [None] if lock is None else values_of(robot, lock)
            return lock, values, [robot_of(arm, lock, value) for value in values]
    raise ikbench.Declined("no kinematic family that EAIK knows")


def values_of(robot, lock):
    is_endless = robot.lower[lock] is None
    low, high = (-np.pi, np.pi) if is_endless else (robot.lower[lock], robot.upper[lock])
    return np.linspace(low, high, 129)[1::2].tolist()


def nearest(values, value):
    return min(max(round((value - values[0]) / (values[1] - values[0])), 0), len(values) - 1)


def solve(prepared, problem):
    lock, values, arms = prepared
    target = np.array(problem.matrix)
    for start in problem.starts():
        i = 0 if lock is None else nearest(values, start[lock])
        found = exact(arms[i], target, lock, values[i])
        if lock is None or any(map(problem.inside, found)):
            return found or None


ikbench.run("eaik", prepare, solve, version=version("eaik"), goals=["pose"])

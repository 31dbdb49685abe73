#!/usr/bin/env python3
"""A solver with its own kinematics: cyclic coordinate descent. It solves for positions, on arms with revolute joints."""
import math

import ikbench

square = lambda m: [m[0:4], m[4:8], m[8:12], m[12:16]]
dot = lambda a, b: sum(x * y for x, y in zip(a, b))


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def frames(arm, q):
    """Returns the frame before each joint, and the frame of the tool."""
    all = [square(arm.base)]
    for joint, value in zip(arm.joints, q):
        t, al, a, d = joint["theta"] + value, joint["alpha"], joint["a"], joint["d"]
        c, s, ca, sa = math.cos(t), math.sin(t), math.cos(al), math.sin(al)
        cb, sb = math.cos(joint["beta"]), math.sin(joint["beta"])
        link = times([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]],
                     [[cb, 0, sb, 0], [0, 1, 0, 0], [-sb, 0, cb, 0], [0, 0, 0, 1]])
        all.append(times(all[-1], link))
    return all[:-1] + [times(all[-1], square(arm.tool))]


def prepare(robot):
    robot.require(turning=True)
    return robot


def solve(arm, problem):
    target, q = problem.position, list(problem.start)
    off = lambda frame: [target[k] - frame[k][3] for k in range(3)]
    for _ in range(problem.budget.iterations):
        if math.hypot(*off(frames(arm, q)[-1])) <= problem.tolerance.position or problem.left() <= 0:
            break
        for j in reversed(range(len(q))):  # the turn about each axis that brings the tool nearest
            all = frames(arm, q)
            axis, to = [row[2] for row in all[j][:3]], off(all[j])
            tool = [all[-1][k][3] - all[j][k][3] for k in range(3)]
            cross = [tool[k - 2] * to[k - 1] - tool[k - 1] * to[k - 2] for k in range(3)]
            turn = math.atan2(dot(axis, cross), dot(tool, to) - dot(axis, tool) * dot(axis, to))
            q[j] = min(max(q[j] + turn, problem.lower[j]), problem.upper[j])
    return q


ikbench.run("python_descent", prepare, solve, version="2.0", goals=["position"])

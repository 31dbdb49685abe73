"""A study's [check] that gives the manipulability of each answer: how freely the tool's point can move on from there,
sqrt(det(J J^T)) in m^3 (T. Yoshikawa, International Journal of Robotics Research 4 (1985) 3). With an argument, it
refuses answers whose manipulability is less, with the reason "near a singularity"."""
import math, sys

import ikbench


def product(a, b):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]


def manipulability(robot, answer):
    frame, axes = [robot.base[i:i + 4] for i in (0, 4, 8, 12)], []
    for joint, q in zip(robot.joints, answer.q):
        slides = joint["type"] == "prismatic"
        axes.append((slides, *([row[i] for row in frame[:3]] for i in (2, 3))))
        turn, along = joint["theta"] + (0 if slides else q), joint["d"] + (q if slides else 0)
        c, s, ca, sa = math.cos(turn), math.sin(turn), math.cos(joint["alpha"]), math.sin(joint["alpha"])
        frame = product(frame, [[c, -s * ca, s * sa, joint["a"] * c], [s, c * ca, -c * sa, joint["a"] * s],
                                [0, sa, ca, along], [0, 0, 0, 1]])
        cb, sb = math.cos(joint["beta"]), math.sin(joint["beta"])
        frame = product(frame, [[cb, 0, sb, 0], [0, 1, 0, 0], [-sb, 0, cb, 0], [0, 0, 0, 1]])
    tool = [row[3] for row in product(frame, [robot.tool[i:i + 4] for i in (0, 4, 8, 12)])[:3]]
    columns = [z if slides else [z[i - 2] * (tool[i - 1] - p[i - 1]) - z[i - 1] * (tool[i - 2] - p[i - 2]) for i in range(3)]
               for slides, z, p in axes]
    (a, b, c), (_, d, e), (_, _, f) = product(zip(*columns), columns)
    measure = math.sqrt(max(0, a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d)))
    return measure >= float((sys.argv + [0])[1]) or "near a singularity", {"manipulability": measure}


ikbench.check(manipulability, lambda robot: robot.require() or robot, version="1")

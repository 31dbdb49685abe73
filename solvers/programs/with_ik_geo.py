# /// script
# dependencies = ["ik-geo==1.0.3", "numpy"]
# ///
"""ik-geo: closed forms by subproblems, of six joints. Its user says of which family the arm is: here that which answers
most of ten poses rightly. All its answers."""
from importlib.metadata import version

import ik_geo

import ikbench
import numpy as np
from product_of_exponentials import axes_of, frames

closed_forms = ["spherical_two_parallel", "spherical_two_intersecting", "spherical", "three_parallel_two_intersecting",
                "three_parallel"]


def answers(arm, rotation, place):  # it takes a rotation column by column
    return [q for q, is_least_squares in arm.get_ik(rotation.T, place) if not is_least_squares]


def rightly(arm, robot, tool):
    count = 0
    for q in np.random.default_rng(1).uniform(-2, 2, (10, 6)):
        target = frames(robot, q)[-1]
        reached = [frames(robot, answer)[-1] for answer in answers(arm, target[:3, :3] @ tool.T, target[:3, 3])]
        count += any(np.abs(each - target).max() < 1e-8 for each in reached)
    return count


def crossing(axes, ways):
    """Ways by which the first two and the last three axes have one point where they cross, as the closed forms want."""
    points = np.cumsum(ways, axis=0)
    for some in slice(0, 2), slice(3, 6):
        across = [np.eye(3) - np.outer(h, h) for h in axes[some]]
        point = np.linalg.lstsq(sum(across), sum(a @ p for a, p in zip(across, points[some])), rcond=None)[0]
        if max(np.linalg.norm(a @ (point - p)) for a, p in zip(across, points[some])) < 1e-9:
            points[some] = point
    return np.diff(points, axis=0, prepend=[[0, 0, 0]])


def prepare(robot):
    robot.require(turning=True)
    axes, ways, tool = axes_of(robot)
    if len(axes) != 6:
        raise ikbench.Declined("arms of six joints, alone; of seven the user would lock one")
    ways = crossing(axes, ways)
    arms = [getattr(ik_geo.Robot, family)(axes, ways) for family in closed_forms]
    arm = max(arms, key=lambda its: rightly(its, robot, tool))
    if rightly(arm, robot, tool) < 5:
        raise ikbench.Declined("no kinematic family of closed form")
    return arm, tool


def solve(prepared, problem):
    arm, tool = prepared
    return answers(arm, np.array(problem.rotation) @ tool.T, problem.position) or None


ikbench.run("ik_geo", prepare, solve, version=version("ik-geo"), goals=["pose"])

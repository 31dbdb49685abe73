# /// script
# dependencies = ["klampt==0.10.1.post1", "numpy"]
# ///
"""Klampt: its Newton-Raphson solver for a fixed objective, from random starts. Its tolerance is of the largest
component of place and rotation, so it is the tolerance by the square root of 3."""
from importlib.metadata import version

from klampt import WorldModel
from klampt.math import so3
from klampt.model import ik

import ikbench


def prepare(robot):
    robot.require()
    world = WorldModel()
    if not world.loadElement(robot.file) >= 0:
        raise ikbench.Declined("it cannot read the arm")
    arm = world.robot(0)
    joints = [arm.driver(i).getAffectedLink() for i in range(arm.numDrivers())]
    return world, arm, arm.link(robot.tip_link), joints, robot.options["steps"]


def solve(prepared, problem):
    world, arm, tip, joints, steps = prepared
    goal = ik.objective(tip, R=so3.from_matrix(problem.rotation), t=problem.position)
    tolerance = min(problem.tolerance.position, problem.tolerance.rotation) / 3**0.5
    solver = ik.solver(goal, iters=steps, tol=tolerance)
    solver.setActiveDofs(joints)
    q = arm.getConfig()
    for start in problem.starts():
        for joint, value in zip(joints, start):
            q[joint] = value
        arm.setConfig(q)
        if solver.solve():
            found = arm.getConfig()
            return [found[joint] for joint in joints]


ikbench.run("klampt", prepare, solve, version=version("klampt"), goals=["pose"], steps=30)

# /// script
# dependencies = ["placo==0.10.2"]
# ///
"""PlaCo: a frame task and the limits of joints, solved step by step; from random starts."""
from importlib.metadata import version

import placo

import ikbench
import numpy as np


def reader(arm, names):
    """Returns a function that gives the joints' values: from the arm's state, or one by one if a joint without end has two
    numbers there."""
    if any(arm.get_joint_size(name) != 1 for name in names):
        return lambda: [arm.get_joint(name) for name in names]
    places = [arm.get_joint_offset(name) for name in names]
    return lambda: arm.state.q[places]


def prepare(robot):
    robot.require()
    arm = placo.RobotWrapper(robot.file, placo.Flags.ignore_collisions)
    solver = placo.KinematicsSolver(arm)
    solver.mask_fbase(True)
    task = solver.add_frame_task(robot.tip_link, np.eye(4))
    task.configure(robot.tip_link, "soft", 1.0, 1.0)
    solver.add_regularization_task(1e-8)
    arm.update_kinematics()
    return robot, arm, solver, task, reader(arm, robot.names), arm.get_T_world_frame(robot.base_link)


def solve(prepared, problem):
    robot, arm, solver, task, joints, base = prepared
    target = base @ problem.matrix
    task.T_world_frame = target

    def iterates(start):
        for name, value in zip(robot.names, start):
            arm.set_joint(name, value)
        while True:
            arm.update_kinematics()
            off = arm.get_T_world_frame(robot.tip_link) - target
            yield off[:3, 3], off[:3, :3].ravel() / 2**0.5, joints()
            solver.solve(True)
    return problem.descend(iterates, robot.options["steps"], RuntimeError)  # no solution of its quadratic program


ikbench.run("placo", prepare, solve, version=version("placo"), goals=["pose"], steps=15)

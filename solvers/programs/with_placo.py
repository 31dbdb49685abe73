# /// script
# dependencies = ["placo==0.10.2"]
# ///
"""PlaCo: a frame task and the limits of joints, solved step by step; from random starts."""
import placo

import ikbench
import numpy as np


def prepare(robot):
    robot.require()
    arm = placo.RobotWrapper(robot.file, placo.Flags.ignore_collisions)
    solver = placo.KinematicsSolver(arm)
    solver.mask_fbase(True)
    task = solver.add_frame_task(robot.tip_link, np.eye(4))
    task.configure(robot.tip_link, "soft", 1.0, 1.0)
    solver.add_regularization_task(1e-8)
    return robot, arm, solver, task


def solve(prepared, problem):
    robot, arm, solver, task = prepared
    target = np.array(problem.matrix)
    arm.reset()
    arm.update_kinematics()
    target = arm.get_T_world_frame(robot.base_link) @ target
    task.T_world_frame = target
    for start in problem.starts():
        for name, value in zip(robot.names, start):
            arm.set_joint(name, value)
        arm.update_kinematics()
        for _ in range(robot.options["steps"]):
            off = arm.get_T_world_frame(robot.tip_link) - target
            if np.linalg.norm(off[:3, 3]) < problem.tolerance.position and \
                    np.linalg.norm(off[:3, :3]) < 2**0.5 * problem.tolerance.rotation:
                return [arm.get_joint(name) for name in robot.names]
            if problem.left() <= 0:
                return None
            try:
                solver.solve(True)
            except RuntimeError:  # no solution of its quadratic program
                break
            arm.update_kinematics()


ikbench.run("placo", prepare, solve, version="0.10.2", goals=["pose"],
            options={"steps": (15, 1, 100000, "steps before the next start")})

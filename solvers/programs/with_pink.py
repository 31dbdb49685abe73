# /// script
# dependencies = ["pin-pink==4.4.0", "daqp==0.11.0"]
# ///
"""Pink: solve_ik with a frame task and the limits of joints, by the solver daqp, in whole steps; from random starts."""
import warnings

import pinocchio as pin
import pink

import ikbench
import numpy as np


def prepare(robot):
    robot.require(bounded=True)
    model = pin.buildModelFromXML(robot.urdf)
    task = pink.tasks.FrameTask(robot.tip_link, position_cost=1.0, orientation_cost=1.0, lm_damping=0.01)
    return robot, model, model.createData(), task


def solve(prepared, problem):
    robot, model, data, task = prepared
    dt = 1.0  # whole steps of Gauss and Newton
    for start in problem.starts():
        arm = pink.Configuration(model, data, np.array(start))
        base = arm.get_transform_frame_to_world(robot.base_link)
        task.set_target(base * pin.SE3(np.array(problem.matrix)))
        for _ in range(robot.options["steps"]):
            error = task.compute_error(arm)
            if np.linalg.norm(error[:3]) < problem.tolerance.position and np.linalg.norm(error[3:]) < problem.tolerance.rotation:
                return arm.q
            if problem.left() <= 0:
                return None
            try:
                speed = pink.solve_ik(arm, [task], dt, solver="daqp", damping=1e-8, safety_break=False)
            except pink.exceptions.PinkError:
                break
            arm.integrate_inplace(speed, dt)


warnings.simplefilter("ignore")
ikbench.run("pink_qp", prepare, solve, version="4.4.0", goals=["pose"],
            options={"steps": (10, 1, 100000, "steps before the next start")})

# /// script
# dependencies = ["pin-pink==4.4.0", "daqp==0.11.0"]
# ///
"""Pink: solve_ik with a frame task and the limits of joints, by the solver daqp, in whole steps; from random starts."""
import warnings
from importlib.metadata import version

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

    def iterates(start):
        arm = pink.Configuration(model, data, np.array(start))
        task.set_target(arm.get_transform_frame_to_world(robot.base_link) * pin.SE3(np.array(problem.matrix)))
        while True:
            error = task.compute_error(arm)
            yield error[:3], error[3:], arm.q
            speed = pink.solve_ik(arm, [task], 1.0, solver="daqp", damping=1e-8, safety_break=False)
            arm.integrate_inplace(speed, 1.0)
    return problem.descend(iterates, robot.options["steps"], pink.exceptions.PinkError)


warnings.simplefilter("ignore")
ikbench.run("pink_qp", prepare, solve, version=version("pin-pink"), goals=["pose"], steps=10)

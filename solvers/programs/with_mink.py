# /// script
# dependencies = ["mink==1.3.0", "mujoco==4.0.0", "daqp==0.11.0"]
# ///
"""mink (MuJoCo's kinematics): solve_ik with a frame task and the limits of joints, by the solver daqp, in whole steps;
from random starts."""
import mink
import mujoco

import ikbench
import numpy as np

# MuJoCo wants masses, which an arm for kinematics has none of, and merges links that are fixed to each other.
compiler = "<mujoco><compiler fusestatic='false' boundmass='1' boundinertia='1' discardvisual='true'/></mujoco></robot>"


def prepare(robot):
    robot.require()
    model = mujoco.MjModel.from_xml_string(robot.urdf.replace("</robot>", compiler))
    task = mink.FrameTask(robot.tip_link, "body", position_cost=1.0, orientation_cost=1.0, lm_damping=0.01)
    return model, task, [mink.ConfigurationLimit(model)], robot.options["steps"]


def solve(prepared, problem):
    model, task, limits, steps = prepared
    task.set_target(mink.SE3.from_matrix(np.array(problem.matrix)))
    arm = mink.Configuration(model)
    for start in problem.starts():
        arm.update(np.array(start))
        for _ in range(steps):
            error = task.compute_error(arm)
            if np.linalg.norm(error[:3]) < problem.tolerance.position and np.linalg.norm(error[3:]) < problem.tolerance.rotation:
                return arm.q
            if problem.left() <= 0:
                return None
            try:
                speed = mink.solve_ik(arm, [task], 1.0, solver="daqp", damping=1e-6, limits=limits)
            except mink.MinkError:
                break
            arm.integrate_inplace(speed, 1.0)


ikbench.run("mink_qp", prepare, solve, version="1.3.0", goals=["pose"],
            options={"steps": (15, 1, 100000, "steps before the next start")})

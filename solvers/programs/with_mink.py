# /// script
# dependencies = ["mink==1.3.0", "mujoco==4.0.0", "daqp==0.11.0"]
# ///
"""mink (MuJoCo's kinematics): solve_ik with a frame task and the limits of joints, by the solver daqp, in whole steps;
from random starts."""
from importlib.metadata import version

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

    def iterates(start):
        arm.update(np.array(start))
        while True:
            error = task.compute_error(arm)
            yield error[:3], error[3:], arm.q
            arm.integrate_inplace(mink.solve_ik(arm, [task], 1.0, solver="daqp", damping=1e-6, limits=limits), 1.0)
    return problem.descend(iterates, steps, mink.MinkError)


ikbench.run("mink_qp", prepare, solve, version=version("mink"), goals=["pose"], steps=15)

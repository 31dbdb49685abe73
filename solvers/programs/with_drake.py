# /// script
# requires-python = "==3.12.*"
# dependencies = ["drake==1.58.0"]
# ///
"""Drake: InverseKinematics with constraints of the positions of three points of the tool, by the solver that it
chooses, SNOPT, whose major iterations have a limit; from random starts. An orientation constraint bounds a cosine,
which cannot tell 1e-5 rad. Bounds are of components, so they are the tolerance by the square root of 3."""
from importlib.metadata import version

from pydrake.multibody.inverse_kinematics import InverseKinematics
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import MultibodyPlant
from pydrake.solvers import SnoptSolver, Solve, SolverOptions

import ikbench
import numpy as np


def prepare(robot):
    robot.require()
    plant = MultibodyPlant(0.0)
    Parser(plant).AddModelsFromString(robot.urdf, "urdf")
    plant.WeldFrames(plant.world_frame(), plant.GetFrameByName(robot.base_link))
    plant.Finalize()
    order = [plant.GetJointByName(name).position_start() for name in robot.names]
    how = SolverOptions()
    how.SetOption(SnoptSolver.id(), "Major iterations limit", robot.options["steps"])
    return plant, plant.GetFrameByName(robot.tip_link), order, how


def solve(prepared, problem):
    plant, tip, order, how = prepared
    asked = InverseKinematics(plant)
    target, near = np.array(problem.matrix), min(problem.tolerance.position, problem.tolerance.rotation) / 3 / 3**0.5
    for point in ([0, 0, 0], [1, 0, 0], [0, 1, 0]):  # [m]
        place = target[:3, :3] @ point + target[:3, 3]
        asked.AddPositionConstraint(tip, point, plant.world_frame(), place - near, place + near)
    for start in problem.starts():
        places = np.zeros(len(order))
        places[order] = start
        found = Solve(asked.prog(), places, how)
        if found.is_success():
            return found.GetSolution(asked.q())[order]


ikbench.run("drake", prepare, solve, version=version("drake"), goals=["pose"], steps=30)

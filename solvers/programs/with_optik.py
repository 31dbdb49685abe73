# /// script
# dependencies = ["optik-py==0.5.0", "numpy"]
# ///
"""OptIK: mode "speed" with one thread, which repeats itself, until the time is up. Its objective is half the squared
norm of the twist."""
from importlib.metadata import version

import optik

import ikbench


def prepare(robot):
    robot.require(turning=True, bounded=True)
    arm = optik.Robot.from_urdf_file(robot.file, robot.base_link, robot.tip_link)
    arm.set_parallelism(1)
    return arm


def solve(arm, problem):
    tolerance = min(problem.tolerance.position, problem.tolerance.rotation)
    config = optik.SolverConfig(solution_mode="speed", max_time=problem.budget.seconds or 0.1,
                                tol_f=0.5 * tolerance**2)
    found = arm.ik(config, problem.matrix, problem.start)
    return found[0] if found else None


ikbench.run("optik", prepare, solve, version=version("optik-py"), goals=["pose"])

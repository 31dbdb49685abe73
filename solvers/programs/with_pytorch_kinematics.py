# /// script
# dependencies = ["pytorch-kinematics==0.10.0", "torch==2.15.0"]
# ///
"""pytorch-kinematics: PseudoInverseIK in double precision on one thread of the processor, from the start and nine random
ones at once; of a batch all poses at once."""
from importlib.metadata import version

import pytorch_kinematics as pk
import torch

import ikbench


def prepare(robot):
    robot.require(turning=True, bounded=True)
    torch.set_num_threads(1)
    torch.set_default_dtype(torch.float64)
    return robot, pk.build_serial_chain_from_urdf(robot.urdf.encode(), robot.tip_link, robot.base_link).to(dtype=torch.float64)


def solve_batch(prepared, problems):
    robot, chain = prepared
    others, tolerance = range(robot.options["starts"] - 1), problems[0].tolerance
    drawn = lambda problem: [problem.random.uniform(*ends) for ends in zip(robot.lower, robot.upper)]
    starts = torch.tensor([[problem.start] + [drawn(problem) for _ in others] for problem in problems])
    ik = pk.PseudoInverseIK(chain, pos_tolerance=tolerance.position, rot_tolerance=tolerance.rotation, retry_configs=starts[0],
                            max_iterations=robot.options["iterations"], early_stopping_any_converged=True,
                            early_stopping_no_improvement=None)
    ik.initial_config = starts
    found = ik.solve(pk.Transform3d(matrix=torch.tensor([problem.matrix for problem in problems])))
    best = (found.err_pos / tolerance.position).maximum(found.err_rot / tolerance.rotation).argmin(dim=1)
    return found.solutions[torch.arange(len(problems)), best].tolist()


ikbench.run("pytorch_kinematics", prepare, solve_batch=solve_batch, version=version("pytorch-kinematics"), goals=["pose"],
            options={"starts": (10, 1, 1000, "starts at once"), "iterations": (30, 1, 10000, "iterations")})

# /// script
# dependencies = ["ikpy==4.2.1"]
# ///
"""ikpy: inverse_kinematics_frame for the whole orientation, by SciPy's least squares. `tol` is of the change of the cost
and of the joints, so it is a hundredth of the tolerance; from random starts until the answer is near enough."""
from importlib.metadata import version

import numpy as np
from ikpy.chain import Chain

import ikbench


def prepare(robot):
    robot.require()
    chain = Chain.from_urdf_file(robot.file, base_elements=[robot.base_link])
    moving = [link.name in robot.names for link in chain.links]
    chain.active_links_mask = np.array(moving)
    return chain, moving


def solve(prepared, problem):
    chain, moving = prepared
    target = np.array(problem.matrix)
    tolerance = min(problem.tolerance.position, problem.tolerance.rotation)
    for start in problem.starts():
        places = np.zeros(len(moving))
        places[moving] = start
        found = chain.inverse_kinematics_frame(target, places, orientation_mode="all", tol=tolerance / 100)
        off = chain.forward_kinematics(found) - target
        if problem.is_near(off[:3, 3], off[:3, :3].ravel() / 2**0.5):
            return found[moving]
    return found[moving]


ikbench.run("ikpy", prepare, solve, version=version("ikpy"), goals=["pose"])

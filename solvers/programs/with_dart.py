# /// script
# requires-python = "==3.12.*"
# dependencies = ["dartpy==6.20.3"]
# ///
"""DART: the inverse kinematics of a body, with its gradient descent by the Jacobian's damped pseudo-inverse; from random
starts. Its bounds are of components, so they are the tolerance by the square root of 3."""
from importlib.metadata import version

import dartpy as dart

import ikbench
import numpy as np


def prepare(robot):
    robot.require()
    loader = dart.utils.DartLoader()
    loader.setOptions(dart.utils.DartLoaderOptions(defaultRootJointType=dart.utils.DartLoaderRootJointType.FIXED))
    arm = loader.parseSkeleton(robot.file)
    tip = arm.getBodyNode(robot.tip_link)
    target = dart.dynamics.SimpleFrame(dart.dynamics.Frame.World(), "target", dart.math.Isometry3())
    module = tip.getOrCreateIK()
    module.setTarget(target)
    module.getSolver().setNumMaxIterations(robot.options["steps"])
    return arm, [arm.getDof(name) for name in robot.names], target, module


def solve(prepared, problem):
    arm, joints, target, module = prepared
    target.setTransform(dart.math.Isometry3(np.array(problem.rotation), np.array(problem.position)))
    bounds = np.array([problem.tolerance.rotation] * 3 + [problem.tolerance.position] * 3) / 3**0.5
    module.getErrorMethod().setBounds(-bounds, bounds)
    for start in problem.starts():
        for joint, value in zip(joints, start):
            joint.setPosition(value)
        if module.solveAndApply(True):
            return [joint.getPosition() for joint in joints]


ikbench.run("dart", prepare, solve, version=version("dartpy"), goals=["pose"], steps=400)

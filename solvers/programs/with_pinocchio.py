# /// script
# dependencies = ["pin==4.1.0"]
# ///
"""Pinocchio: the closed-loop inverse kinematics of its own example (damping 1e-12), in whole steps, not tenths of one;
it knows no limits; from random starts until an answer, turned by whole turns, is inside them."""
import pinocchio as pin

import ikbench
import numpy as np
from numpy.linalg import norm, solve as solved


def prepare(robot):
    robot.require(bounded=True)
    model = pin.buildModelFromXML(robot.urdf)
    return robot, model, model.createData(), model.getFrameId(robot.tip_link), model.getFrameId(robot.base_link)


def descend(model, data, tip, target, q, problem, steps):
    for _ in range(steps):
        pin.forwardKinematics(model, data, q)
        off = pin.updateFramePlacement(model, data, tip).actInv(target)
        if norm(off.translation) < problem.tolerance.position and norm(pin.log3(off.rotation)) < problem.tolerance.rotation:
            return q
        if problem.left() <= 0:
            return None
        error = pin.log6(off).vector
        jacobian = -pin.Jlog6(off.inverse()) @ pin.computeFrameJacobian(model, data, q, tip)
        speed = -jacobian.T @ solved(jacobian @ jacobian.T + 1e-12 * np.eye(6), error)
        q = pin.integrate(model, q, speed)


def solve(prepared, problem):
    robot, model, data, tip, base = prepared
    pin.framesForwardKinematics(model, data, pin.neutral(model))
    target = data.oMf[base] * pin.SE3(np.array(problem.matrix))
    for start in problem.starts():
        q = descend(model, data, tip, target, np.array(start), problem, robot.options["steps"])
        if q is None:
            continue
        q = ikbench.inside(q, robot.turns, problem.lower, problem.upper)
        if np.all(np.clip(q, problem.lower, problem.upper) == q):
            return q


ikbench.run("pinocchio_clik", prepare, solve, version="4.1.0", goals=["pose"],
            options={"steps": (10, 1, 100000, "steps before the next start")})

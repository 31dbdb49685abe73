# /// script
# requires-python = "==3.11.*"
# dependencies = ["pybullet==3.2.7", "numpy==1.26.4"]
# ///
"""PyBullet: calculateInverseKinematics, by damped least squares, with jointDamping 1e-4 (its default is 0.5); from
random starts until the answer, turned by whole turns, is near enough and inside the limits, which it does not know."""
import math
from importlib.metadata import version

import pybullet as bullet

import ikbench
from quaternion import quaternion

bullet.connect(bullet.DIRECT)


def prepare(robot):
    robot.require()
    arm = bullet.loadURDF(robot.file, useFixedBase=True)
    infos = [bullet.getJointInfo(arm, i) for i in range(bullet.getNumJoints(arm))]
    at = {info[1].decode(): info[0] for info in infos}
    tip = {info[12].decode(): info[0] for info in infos}[robot.tip_link]
    return robot, arm, [at[name] for name in robot.names], tip


def solve(prepared, problem):
    robot, arm, joints, tip = prepared
    aim = quaternion(problem.rotation)
    near = min(problem.tolerance.position, problem.tolerance.rotation) / 2
    for start in problem.starts():
        for joint, value in zip(joints, start):
            bullet.resetJointState(arm, joint, value)
        q = bullet.calculateInverseKinematics(arm, tip, problem.position, aim, maxNumIterations=robot.options["steps"],
                                              residualThreshold=near, jointDamping=[1e-4] * len(joints))
        found = problem.inside(q)
        for joint, value in zip(joints, q):
            bullet.resetJointState(arm, joint, value)
        place, turn = bullet.getLinkState(arm, tip, computeForwardKinematics=True)[4:6]
        off = [x - aimed for x, aimed in zip(place, problem.position)]
        angle = 2 * min(math.dist(aim, turn), math.dist(aim, [-x for x in turn]))
        if found and problem.is_near(off, [angle]):
            return found
    return q


ikbench.run("pybullet", prepare, solve, version=version("pybullet"), goals=["pose"], steps=60)

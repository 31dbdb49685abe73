# /// script
# requires-python = "==3.11.*"
# dependencies = ["pybullet==3.2.7", "numpy==1.26.4"]
# ///
"""PyBullet: calculateInverseKinematics, by damped least squares, with jointDamping 1e-4 (its default is 0.5); from
random starts until the answer, turned by whole turns, is near enough and inside the limits, which it does not know."""
import pybullet as bullet

import ikbench
import numpy as np

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
    aim = quaternion(np.array(problem.rotation))
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
        angle = 2 * min(np.linalg.norm(aim - turn), np.linalg.norm(aim + turn))
        if found and problem.is_near(np.subtract(place, problem.position), [angle]):
            return found
    return q


def quaternion(R):  # x, y, z, w: Bar-Itzhack's eigenvector
    K, trace = np.zeros((4, 4)), np.trace(R)
    K[:3, :3], K[3, 3] = R + R.T - trace * np.eye(3), trace
    K[3, :3] = K[:3, 3] = (R - R.T)[[2, 0, 1], [1, 2, 0]]
    return np.linalg.eigh(K)[1][:, 3]


ikbench.run("pybullet", prepare, solve, version="3.2.7", goals=["pose"], steps=15)

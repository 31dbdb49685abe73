# /// script
# requires-python = "==3.11.*"
# dependencies = ["pybullet==3.2.7", "numpy==1.26.4"]
# ///
"""PyBullet: calculateInverseKinematics, by damped least squares, at most 1000 iterations; from random starts until the
answer, turned by whole turns, is near enough and inside the limits, which it does not know."""
import pybullet as bullet

import ikbench

bullet.connect(bullet.DIRECT)


def prepare(robot):
    robot.require(turning=True, bounded=True)
    arm = bullet.loadURDF(robot.file, useFixedBase=True)
    infos = [bullet.getJointInfo(arm, i) for i in range(bullet.getNumJoints(arm))]
    at = {info[1].decode(): info[0] for info in infos}
    tip = {info[12].decode(): info[0] for info in infos}[robot.tip_link]
    return robot, arm, [at[name] for name in robot.names], tip


def solve(prepared, problem):
    robot, arm, joints, tip = prepared
    w, x, y, z = quaternion(problem.rotation)
    near = min(problem.tolerance.position, problem.tolerance.rotation) / 2
    for start in problem.starts():
        for joint, value in zip(joints, start):
            bullet.resetJointState(arm, joint, value)
        q = bullet.calculateInverseKinematics(arm, tip, problem.position, [x, y, z, w], maxNumIterations=1000,
                                              residualThreshold=near)
        q = ikbench.inside(q, robot.turns, problem.lower, problem.upper)
        for joint, value in zip(joints, q):
            bullet.resetJointState(arm, joint, value)
        place, turn = bullet.getLinkState(arm, tip, computeForwardKinematics=True)[4:6]
        off = sum((a - b)**2 for a, b in zip(place, problem.position))**0.5
        angle = 2 * max(0, 1 - abs(turn[0] * x + turn[1] * y + turn[2] * z + turn[3] * w))
        if off <= problem.tolerance.position and angle**0.5 * 2**0.5 <= problem.tolerance.rotation and \
                all(low <= value <= high for low, value, high in zip(problem.lower, q, problem.upper)):
            return q
    return q


def quaternion(R):
    trace = R[0][0] + R[1][1] + R[2][2]
    if trace > 0:
        s = 2 * (1 + trace)**0.5
        return s / 4, (R[2][1] - R[1][2]) / s, (R[0][2] - R[2][0]) / s, (R[1][0] - R[0][1]) / s
    i = max(range(3), key=lambda k: R[k][k])
    j, k = (i + 1) % 3, (i + 2) % 3
    s = 2 * (1 + R[i][i] - R[j][j] - R[k][k])**0.5
    q = [0, 0, 0]
    q[i], q[j], q[k] = s / 4, (R[j][i] + R[i][j]) / s, (R[k][i] + R[i][k]) / s
    return (R[k][j] - R[j][k]) / s, *q


ikbench.run("pybullet", prepare, solve, version="3.2.7", goals=["pose"])

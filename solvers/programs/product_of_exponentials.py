"""The frames of an arm, and its axes H and the ways P between them at zero, as EAIK and ik-geo want them."""
import numpy as np


def frames(robot, q):
    """Those before each joint, then the tool's, 4 rows of 4."""
    found = [np.array(robot.base).reshape(4, 4)]
    for joint, angle in zip(robot.joints, q):
        t, al = joint["theta"] + angle, joint["alpha"]
        c, s, ca, sa = np.cos(t), np.sin(t), np.cos(al), np.sin(al)
        cb, sb = np.cos(joint["beta"]), np.sin(joint["beta"])
        found.append(found[-1] @ [[c, -s * ca, s * sa, joint["a"] * c], [s, c * ca, -c * sa, joint["a"] * s],
                                  [0, sa, ca, joint["d"]], [0, 0, 0, 1]]
                               @ np.array([[cb, 0, sb, 0], [0, 1, 0, 0], [-sb, 0, cb, 0], [0, 0, 0, 1]]))
    return found[:-1] + [found[-1] @ np.array(robot.tool).reshape(4, 4)]


def axes_of(robot):
    """Axes (n, 3), ways (n + 1, 3), and the tool's rotation."""
    at = np.array(frames(robot, [0] * len(robot.joints)))
    return at[:-1, :3, 2], np.diff(at[:, :3, 3], axis=0, prepend=[[0, 0, 0]]), at[-1, :3, :3]


def tool_beyond(robot, its_forward):
    """What is between the tool of a library's own arm, by its kinematics, and the robot's; None if that is not one frame.
    Lengths may be rounded to 1e-6 m, which is a tenth of the tolerance of a study."""
    tried = np.random.default_rng(1).uniform(-1, 1, (3, len(robot.joints)))
    tools = [np.linalg.inv(its_forward(q)) @ frames(robot, q)[-1] for q in tried]
    return tools[0] if max(np.abs(each - tools[0]).max() for each in tools) < 1e-6 else None

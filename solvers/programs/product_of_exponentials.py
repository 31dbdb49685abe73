"""The axes H and the ways P between them of an arm at zero, in the frame of its base, as EAIK and ik-geo want them."""
import numpy as np


def axes_of(robot):
    """Axes (n, 3), ways (n + 1, 3), and the tool's rotation."""
    frame, points, axes = np.array(robot.base).reshape(4, 4), [np.zeros(3)], []
    for joint in robot.joints:
        axes.append(frame[:3, 2])
        points.append(frame[:3, 3])
        t, al = joint["theta"], joint["alpha"]
        c, s, ca, sa = np.cos(t), np.sin(t), np.cos(al), np.sin(al)
        frame = frame @ [[c, -s * ca, s * sa, joint["a"] * c], [s, c * ca, -c * sa, joint["a"] * s],
                         [0, sa, ca, joint["d"]], [0, 0, 0, 1]]
    tool = frame @ np.array(robot.tool).reshape(4, 4)
    points.append(tool[:3, 3])
    return np.array(axes), np.diff(np.array(points), axis=0), tool[:3, :3]


def forward(axes, ways, q):
    """The rotation, without the tool's own, and the place of the tool."""
    rotation, place = np.eye(3), ways[0]
    for (x, y, z), way, angle in zip(axes, ways[1:], q):
        cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        rotation = rotation @ (np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross)
        place = place + rotation @ way
    return rotation, place


def tool_beyond(robot, its_forward):
    """What is between the tool of a library's own arm, by its kinematics, and the robot's; None if that is not one frame."""
    axes, ways, tool = axes_of(robot)
    tools = []
    for q in np.random.default_rng(1).uniform(-1, 1, (3, len(axes))):
        whole = np.eye(4)
        rotation, whole[:3, 3] = forward(axes, ways, q)
        whole[:3, :3] = rotation @ tool
        tools.append(np.linalg.inv(its_forward(q)) @ whole)
    return tools[0] if max(np.abs(each - tools[0]).max() for each in tools) < 1e-9 else None

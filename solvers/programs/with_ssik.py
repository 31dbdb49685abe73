# /// script
# dependencies = ["ssik[urdf]==8.2.0"]
# ///
"""ssik: closed forms and eliminations, with its compiled backend: its prebuilt arm where one has, up to the tool, the same
kinematics, preferably one with the same limits, else one derived from the URDF file. The answer that is nearest to the start;
where the prebuilt arm has other limits, the nearest inside those of the study of all that it finds."""
import ssik

import ikbench
import numpy as np
from product_of_exponentials import axes_of, forward


def prepare(robot):
    robot.require(turning=True)
    axes, ways, tool = axes_of(robot)

    def tool_of(arm, q):  # in the frame of its tool
        rotation, place = forward(axes, ways, q)
        whole = np.eye(4)
        whole[:3, :3], whole[:3, 3] = rotation @ tool, place
        return np.linalg.inv(arm.fk(q)) @ whole

    limits, some = [*zip(robot.lower, robot.upper)], np.random.default_rng(1).uniform(-1, 1, (3, len(axes)))
    alike = None
    for its in ssik.list_arms():
        if its.dof == len(axes):
            arm = ssik.Manipulator.from_prebuilt(its.name)
            its_limits, tools = [of or (None, None) for of in arm.joint_limits], [tool_of(arm, q) for q in some]
            if max(np.abs(each - tools[0]).max() for each in tools) < 1e-9:
                has_limits = np.allclose(np.array(its_limits, float), np.array(limits, float), atol=1e-3, equal_nan=True)
                if alike is None or has_limits:
                    alike = arm, np.linalg.inv(tools[0]), has_limits
                if has_limits:
                    break
    if alike:
        return alike
    try:
        arm = ssik.Manipulator.from_urdf(robot.file, base=robot.base_link, ee=robot.tip_link)
        arm.prepare()
    except (ValueError, NotImplementedError) as error:
        raise ikbench.Declined(str(error)[:100])
    return arm, np.eye(4), True


def solve(prepared, problem):
    arm, tool, has_limits = prepared
    how = {"max_solutions": 1} if has_limits else {"respect_limits": False}
    found = arm.solve(np.array(problem.matrix) @ tool, q_seed=problem.start, **how)
    is_inside = lambda q: has_limits or all(low <= x <= high for x, low, high in zip(q, problem.lower, problem.upper))
    return next((each.q for each in found if is_inside(each.q)), None)


ikbench.run("ssik", prepare, solve, version="8.2.0", goals=["pose"])

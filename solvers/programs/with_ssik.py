# /// script
# dependencies = ["ssik[urdf]==8.2.0"]
# ///
"""ssik: closed forms and eliminations, with its compiled backend: its prebuilt arm where one has, up to the tool, the same
kinematics, preferably one with the same limits, else one derived from the URDF file. Of six joints it gives all answers. Of
seven, which have infinitely many, it gives the one nearest to the start; if the prebuilt arm has other limits, the nearest
inside those of the study of all that ssik finds."""
import ssik

import ikbench
import numpy as np
from product_of_exponentials import tool_beyond


def prepare(robot):
    robot.require(turning=True)
    limits, alike = [*zip(robot.lower, robot.upper)], None
    for its in ssik.list_arms():
        if its.dof == len(limits):
            arm = ssik.Manipulator.from_prebuilt(its.name)
            tool = tool_beyond(robot, arm.fk)
            if tool is not None:
                its_limits = [of or (None, None) for of in arm.joint_limits]
                has_limits = np.allclose(np.array(its_limits, float), np.array(limits, float), atol=1e-3, equal_nan=True)
                if alike is None or has_limits:
                    alike = arm, np.linalg.inv(tool), has_limits
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
    if len(problem.start) == 6:
        return [each.q for each in arm.solve(np.array(problem.matrix) @ tool, respect_limits=False)] or None
    how = {"max_solutions": 1} if has_limits else {"respect_limits": False}
    found = arm.solve(np.array(problem.matrix) @ tool, q_seed=problem.start, **how)
    return next((each.q for each in found if has_limits or problem.inside(each.q)), None)


ikbench.run("ssik", prepare, solve, version="8.2.0", goals=["pose"])

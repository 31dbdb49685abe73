# /// script
# dependencies = ["ssik[urdf]==8.2.0"]
# ///
"""ssik: closed forms and eliminations, with its compiled backend: its prebuilt arm where one has, up to the tool, the same
kinematics, preferably one with the same limits, else one derived from the URDF file. It gives its first answer inside the
limits; by the option the one nearest to the start, for paths, or all. If the prebuilt arm has other limits, it finds all and
gives the first or nearest inside those of the study."""
from importlib.metadata import version

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
                    alike = arm, np.linalg.inv(tool), has_limits, robot.options["answers"]
                if has_limits:
                    break
    if alike:
        return alike
    try:
        arm = ssik.Manipulator.from_urdf(robot.file, base=robot.base_link, ee=robot.tip_link)
        arm.prepare()
    except (ValueError, NotImplementedError) as error:
        raise ikbench.Declined(str(error)[:100])
    return arm, np.eye(4), True, robot.options["answers"]


def solve(prepared, problem):
    arm, tool, has_limits, answers = prepared
    how = {"max_solutions": 1} if has_limits and answers != "all" else {"respect_limits": False}
    if answers == "nearest":
        how["q_seed"] = problem.start
    found = arm.solve(np.array(problem.matrix) @ tool, **how)
    if answers == "all":
        return [each.q for each in found] or None
    return next((each.q for each in found if has_limits or problem.inside(each.q)), None)


ikbench.run("ssik", prepare, solve, version=version("ssik"), goals=["pose"],
            options={"answers": ["first", "nearest", "all"]})

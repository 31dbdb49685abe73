#!/usr/bin/env python3
"""A library of one's own that reads URDF and solves poses: KDL's Levenberg-Marquardt (Debian's python3-pykdl), from random
starts until an answer, turned by whole turns, is inside the limits, which it does not know. Its Newton, clipped at the limits,
is the option `method`."""
import xml.etree.ElementTree as xml

import ikbench, PyKDL as kdl

three = lambda element, key: map(float, ("0 0 0" if element is None else element.get(key, "0 0 0")).split())


def prepare(robot):  # KDL's own reader is for C++ alone
    chain, joints = kdl.Chain(), xml.fromstring(robot.urdf).findall("joint")
    before = {joint.find("child").get("link"): joint for joint in joints}

    def add(link):  # what leads to it
        if link == robot.base_link: return
        joint, origin, kind = before[link], before[link].find("origin"), before[link].get("type")
        add(joint.find("parent").get("link"))
        frame = kdl.Frame(kdl.Rotation.RPY(*three(origin, "rpy")), kdl.Vector(*three(origin, "xyz")))
        axis = frame.M * kdl.Vector(*three(joint.find("axis"), "xyz"))
        moves = (frame.p, axis, kdl.Joint.TransAxis if kind == "prismatic" else kdl.Joint.RotAxis)
        chain.addSegment(kdl.Segment(kdl.Joint(link, *([kdl.Joint.Fixed] if kind == "fixed" else moves)), frame))
    add(robot.tip_link)
    return robot, chain, kdl.ChainFkSolverPos_recursive(chain), kdl.ChainIkSolverVel_pinv(chain)


def array(values):
    q = kdl.JntArray(len(values))
    for j, value in enumerate(values): q[j] = value
    return q


def solve(prepared, problem):
    robot, chain, forward, velocity = prepared
    answer, steps = array(problem.start), min(robot.options["steps"], problem.budget.iterations)
    target = kdl.Frame(kdl.Rotation(*sum(problem.rotation, [])), kdl.Vector(*problem.position))
    place, turn = problem.tolerance.position, problem.tolerance.rotation
    if robot.options["method"] == "lma":  # a radian weighs 0.01 m in it
        library = kdl.ChainIkSolverPos_LMA(chain, eps=min(place, 0.01 * turn) or 1e-5, maxiter=steps)
    else:
        library = kdl.ChainIkSolverPos_NR_JL(chain, array(problem.lower), array(problem.upper), forward, velocity, steps,
                                             min(place, turn) / 3**0.5 or 1e-5)
    for start in problem.starts():
        is_near = library.CartToJnt(array(start), target, answer) >= 0
        q = problem.inside(list(answer))
        if is_near and q: return q
    return answer


ikbench.run("pykdl", prepare, solve, version=kdl.__version__, goals=["pose"], steps=60, options={"method": ["lma", "newton"]})

#!/usr/bin/env python3
"""A library of one's own that reads URDF and solves poses: KDL's Levenberg-Marquardt (Debian's python3-pykdl)."""
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
    return chain


def solve(chain, problem):
    q, answer = kdl.JntArray(len(problem.start)), kdl.JntArray(len(problem.start))
    for j, value in enumerate(problem.start): q[j] = value
    near = min(problem.tolerance.position, 0.01 * problem.tolerance.rotation) or 1e-5  # a radian weighs 0.01 m in KDL
    library = kdl.ChainIkSolverPos_LMA(chain, eps=near, maxiter=problem.budget.iterations)
    library.CartToJnt(q, kdl.Frame(kdl.Rotation(*sum(problem.rotation, [])), kdl.Vector(*problem.position)), answer)
    return answer


ikbench.run("pykdl_lma", prepare, solve, version="1.5", goals=["pose"])

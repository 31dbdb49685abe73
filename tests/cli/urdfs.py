"""Eight arms, each with every feature that URDF files of the public have: the program must find the same chain as forty
lines of other kinematics, or ask. Each is run, with a report, as are further files. Arguments: the program, files."""
import math, random, re, subprocess, sys, xml.etree.ElementTree as ET
from concurrent.futures import ThreadPoolExecutor

# ---- the other kinematics: 4x4 matrices ------------------------------------------------------------------------------


def product(*matrices):
    result = [[float(i == j) for j in range(4)] for i in range(4)]
    for m in matrices:
        result = [[sum(row[k] * m[k][j] for k in range(4)) for j in range(4)] for row in result]
    return result


def moved(x, y, z):
    return [[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]]


def turned(axis, angle):
    length = math.hypot(*axis)
    x, y, z = (each / length for each in axis)
    c, s, v = math.cos(angle), math.sin(angle), 1 - math.cos(angle)
    return [[x * x * v + c, x * y * v - z * s, x * z * v + y * s, 0], [y * x * v + z * s, y * y * v + c, y * z * v - x * s, 0],
            [z * x * v - y * s, z * y * v + x * s, z * z * v + c, 0], [0, 0, 0, 1]]


def turned_by_rpy(roll, pitch, yaw):
    return product(turned((0, 0, 1), yaw), turned((0, 1, 0), pitch), turned((1, 0, 0), roll))


def numbers(element, name, otherwise):
    return [float(each) for each in (otherwise if element is None else element.get(name, otherwise)).split()]


def way(text, base, tip):
    """The joints from base to tip."""
    before = {joint.find("child").get("link"): joint for joint in ET.fromstring(text).findall("joint")}
    joints = []
    while tip != base:
        joints.insert(0, before[tip])
        tip = before[tip].find("parent").get("link")
    return joints


def pose_of(joints, q):
    q, pose = list(q), product()
    for joint in joints:
        origin, axis = joint.find("origin"), numbers(joint.find("axis"), "xyz", "1 0 0")
        pose = product(pose, moved(*numbers(origin, "xyz", "0 0 0")))
        if origin is not None and origin.get("quat_xyzw"):
            *vector, w = numbers(origin, "quat_xyzw", "")
            if any(vector):
                pose = product(pose, turned(vector, 2 * math.atan2(math.hypot(*vector), w)))
        else:
            pose = product(pose, turned_by_rpy(*numbers(origin, "rpy", "0 0 0")))
        if joint.get("type") == "prismatic":
            distance = q.pop(0)
            pose = product(pose, moved(*(distance * each / math.hypot(*axis) for each in axis)))
        elif joint.get("type") != "fixed":
            pose = product(pose, turned(axis, q.pop(0)))
    return pose


# ---- the files -------------------------------------------------------------------------------------------------------

X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)
quarter = math.pi / 2
turn, slide = "revolute", "prismatic"
arms = {  # joints of each: type, xyz, rpy, axis
    "planar": [(turn, (0, 0, 0.1), (0, 0, 0), Z), (turn, (0.4, 0, 0), (0, 0, 0), Z), (turn, (0.3, 0, 0), (0, 0, 0), Z)],
    "scara": [(turn, (0, 0, 0.4), (0, 0, 0), Z), (turn, (0.3, 0, 0), (0, 0, 0), Z), (slide, (0.2, 0, 0), (math.pi, 0, 0), Z)],
    "elbow": [(turn, (0, 0, 0.3), (0, 0, 0), Z), (turn, (0.1, 0, 0.2), (0, 0, 0), Y), (turn, (0, 0, 0.5), (0, 0, 0), Y),
              (turn, (0.4, 0, 0), (0, 0, 0), X), (turn, (0, 0, 0), (0, 0, 0), Y), (turn, (0, 0, 0), (0, 0, 0), X)],
    "offset": [(turn, (0, 0, 0.16), (0, 0, math.pi), Z), (turn, (0, 0, 0), (quarter, 0, 0), Z), (turn, (-0.4, 0, 0), (0, 0, 0), Z),
               (turn, (-0.4, 0, 0.13), (0, 0, 0), Z), (turn, (0, -0.1, 0), (quarter, 0, 0), Z),
               (turn, (0, 0.1, 0), (quarter, math.pi, math.pi), Z)],
    "seven": [(turn, (0, 0, 0.2), (-quarter if i % 2 else quarter, 0, 0), Z) for i in range(7)],
    "tilted": [(turn, (0.1, 0.2, 0.05), (0.3, -0.7, 1.1), (1, 2, -2)) for _ in range(5)],
    "gantry": [(slide, (0, 0, 1), (0, 0, 0), X), (slide, (0, 0, 0), (0, 0, 0), Y), (slide, (0, 0, 0), (0, 0, 0), (0, 0, -1))],
    "polar": [(turn, (0, 0, 0.3), (0, 0, 0), Z), (turn, (0, 0, 0.1), (0, 0, 0), Y), (slide, (0.2, 0, 0), (0, quarter, 0), Z)],
}


class File:
    def __init__(self, name, joints):
        self.name, self.joints, self.extra, self.links = name, [], "", ["base"]
        self.base, self.tip, self.options, self.asks, self.ending = "base", "tool", [], "", "urdf"
        self.write = repr
        for i, each in enumerate(joints, 1):
            self.add("base" if i == 1 else f"link{i - 1}", f"link{i}", *each)
        self.last = f"link{len(joints)}"
        self.add(self.last, "tool", "fixed", (0.05, 0, 0.1), (0, 0, 0), Z)

    def add(self, parent, child, type, xyz=(0, 0, 0), rpy=(0, 0, 0), axis=Z, inside="", limit=True):
        self.links.append(child)
        self.joints.append([parent, child, type, xyz, rpy, axis, inside + ("<limit lower='-1.5' upper='2' effort='9'/>" if limit else "")])

    def origin(self, xyz, rpy):
        return "xyz='%s' rpy='%s'" % (" ".join(map(self.write, xyz)), " ".join(map(self.write, rpy)))

    def text(self):
        joints = ["<joint name='%s_joint' type='%s'><parent link='%s'/><child link='%s'/><origin %s/><axis xyz='%s'/>%s</joint>\n" %
                  (child, type, parent, child, self.origin(xyz, rpy), " ".join(map(self.write, axis)), inside)
                  for parent, child, type, xyz, rpy, axis, inside in self.joints]
        random.Random(len(joints)).shuffle(joints)
        links = ["<link name='%s'/>\n" % link for link in self.links]
        return "<?xml version='1.0'?>\n<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>%s\n</robot>\n" % "".join(links + joints + [self.extra])


def plain(f): pass
def scientific(f): f.write = lambda value: "%.17E" % value
def long_axes(f):
    for joint in f.joints: joint[5] = tuple(-2.5 * each for each in joint[5])
def comments(f):
    f.extra = "<!-- <joint name='ghost'> --><gazebo><a/></gazebo><transmission name='t'/><material name='m'><color rgba='0 0 ${x} 1'/></material>"
    for joint in f.joints: joint[6] = "<!-- no --><dynamics damping='1'/>" + joint[6]
def quaternions(f):
    def origin(xyz, rpy):
        m = turned_by_rpy(*rpy)
        w = math.sqrt(max(0, 1 + m[0][0] + m[1][1] + m[2][2])) / 2
        x, y, z = (math.copysign(math.sqrt(max(0, 1 + sum((1 if i == k else -1) * m[k][k] for k in range(3)))) / 2, d)
                   for i, d in enumerate((m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1])))
        return "xyz='%s' quat_xyzw='%s'" % (" ".join(map(repr, xyz)), " ".join(repr(3 * each) for each in (x, y, z, w)))
    f.origin = origin
def continuous_wrist(f):
    f.joints[-2][2], f.joints[-2][6] = "continuous", "<limit effort='1' velocity='1'/>"
def gripper(f):
    f.add("tool", "left", slide)
    f.add("tool", "right", slide, inside="<mimic joint='left_joint' multiplier='-1'/>")
def free_fingers(f):
    f.add("tool", "left", slide)
    f.add("tool", "right", slide)
def sensors(f):
    parent = "base"
    for i in range(12):
        f.add(parent, f"camera{i}", "fixed")
        parent = f"camera{i}"
    f.add("link1", "lidar", "fixed")
def two_tools(f):
    f.add(f.last, "camera", "fixed", (0, 0, 0.02))
def dual_arm(f):
    for parent, child, *rest in f.joints[:-1]:
        f.add("r_" + parent if parent != "base" else parent, "r_" + child, *rest[:4])
    f.asks = "r_" + f.last
def humanoid(f):
    f.add("world", "base", "floating")
    f.links[0] = "world"
    for side in ("left", "right"):
        f.add("base", f"{side}_hip", turn)
        f.add(f"{side}_hip", f"{side}_foot", turn)
def rail(f):
    f.add("world", "base", slide, (1, 0, 0), (0, 0, 0.1), Y)
    f.links[0], f.base = "world", "world"
def leftovers(f):
    f.extra = "<xacro:property name='w' value='${2*3}'/><xacro:macro name='m' params='p'><link name='${p}x'/></xacro:macro>"
def included(f):
    f.extra = "<xacro:include filename='more.xacro'/>"
    f.asks = "expand it first"
def computed(f):
    f.joints[0][6] = f.joints[0][6].replace("'2'", "'${2}'")
    f.asks, f.tip = "expand it first", None
def capitals(f):
    f.ending = "URDF"
    f.links = [link.upper() for link in f.links]
    for joint in f.joints: joint[0], joint[1] = joint[0].upper(), joint[1].upper()
    f.base, f.tip = "BASE", "TOOL"
def rounded(f):
    f.write = lambda value: "%.5g" % value
def calibrated(f):
    for joint in f.joints[:-1]: joint[4] = (joint[4][0] + 1.5e-5, joint[4][1] - 2.5e-5, joint[4][2])
def placeholder(f):
    f.joints[0][6] = "<limit lower='-inf' upper='1e16'/>"
    f.asks, f.tip = "a prismatic joint needs" if f.joints[0][2] == slide else "its type is continuous", None
def mimic_on_the_way(f):
    f.joints[0][6] += "<mimic joint='x'/>"
    f.asks, f.tip = "mimics another", None


features = [plain, scientific, long_axes, comments, quaternions, continuous_wrist, gripper, free_fingers, sensors, two_tools, dual_arm,
            humanoid, rail, leftovers, included, computed, capitals, rounded, calibrated, placeholder, mimic_on_the_way]

# ---- the comparison --------------------------------------------------------------------------------------------------


def said(f, *options):
    run = subprocess.run([sys.argv[1], "robot", f"{f.name}.{f.ending}", *options], capture_output=True, text=True, timeout=600)
    assert run.returncode in (0, 1), f"{f.name}: exit code {run.returncode}: {run.stderr}"
    return run.stdout, " ".join(run.stderr.split())


with open("study.toml", "w") as out:
    out.write("search = 'all_joints'\nrobot = 'ur5e'\nruns = 1\n[path]\nkind = 'random'\npoints = 1\n"
              "[stop]\niterations = 3\n[[solvers]]\nsolver = 'damped_least_squares'\n")


def runs(file, **urdf):
    settings = [f"--set=robot={file}", *(f"--set=urdf.{key}={link}" for key, link in urdf.items())]
    run = subprocess.run([sys.argv[1], "run", "study.toml", *settings, "--figures=none", f"--out={file}.out"],
                         capture_output=True, text=True, timeout=600)
    assert run.returncode == 0, f"{file} does not run: {run.stderr}"


def check(arm, feature):
    f = File(f"{arm}_{feature.__name__}", [list(each) for each in arms[arm]])
    feature(f)
    text = f.text()
    with open(f"{f.name}.{f.ending}", "w") as out:
        out.write(text)
    if f.asks:
        _, error = said(f)
        assert f.asks in error, f"{f.name}: expected {f.asks}: {error}"
        if f.tip is None:
            return
    chain = way(text, f.base, f.tip)
    moving = [joint for joint in chain if joint.get("type") != "fixed"]
    dice = random.Random(f.name)
    q = [dice.uniform(-1.5, 2) for _ in moving]
    links = ["--base", f.base, "--tip", f.tip] if f.asks else []
    at = [repr(a if joint.get("type") == "prismatic" else math.degrees(a)) for a, joint in zip(q, moving)]
    out, error = said(f, "--at=" + ",".join(at), *links)
    assert out, f"{f.name}: {error}"
    out = out.replace("\n  ", " ")
    names = [line.split()[-1] for line in out.splitlines() if line[:1].isdigit()]
    assert names == [joint.get("name") for joint in moving], f"{f.name}: another chain: {out}"
    assert f" from {f.base} to {f.tip}\n" in out, f"{f.name}: other links: {out}"
    place, turn = ([float(each) for each in group.split(",")] for group in
                   re.search(r"the tool is at \((.*?)\) m, roll pitch yaw \((.*?)\) deg", out).groups())
    ours, theirs = product(moved(*place), turned_by_rpy(*map(math.radians, turn))), pose_of(chain, q)
    far = max(abs(a - b) for row, other in zip(ours, theirs) for a, b in zip(row, other))
    assert far < 1e-9, f"{f.name}: the tool is {far} off"
    lengths = sum(math.hypot(*numbers(joint.find("origin"), "xyz", "0 0 0")) for joint in chain)
    if reach := re.search(r"reach: at most (\S+) m", out):
        assert float(reach[1]) <= 1.005 * lengths + 1e-5, f"{f.name}: reach {reach[1]} of {lengths}"
    assert f.base in said(f, "--links")[0]
    runs(f"{f.name}.{f.ending}", **({"base": f.base, "tip": f.tip} if f.asks else {}))


both = [(arm, feature) for arm in arms for feature in features]
with ThreadPoolExecutor(4) as pool:  # the program mostly waits for the disk
    for done in [pool.submit(runs, file) for file in sys.argv[2:]] + [pool.submit(check, *each) for each in both]:
        done.result()
assert len(both) >= 100
print(f"{len(both)} files")

# /// script
# requires-python = "==3.11.*"
# dependencies = ["eaik==1.2.2", "ssik[urdf]==8.2.0"]
# ///
"""ssik2026.py [OUT [CHECKOUT]]: counts the answers of ssik and EAIK to the poses of ssik's README, into OUT
(out/ssik2026), where `ikbench reproduce ssik2026` reads ssik.csv and EAIK.csv in place of what is shipped: a row per
pose, a column per arm, empty where the solver refuses the arm. The poses are those of the joints in
results/published/ssik2026/joints-6.csv and -7.csv, by ssik's own kinematics of each arm.

With CHECKOUT, a clone of github.com/personalrobotics/ssik, it also makes EAIK-file.csv, where EAIK reads the URDF files
that ssik's scripts/regen_bench.py gives it, and ssik-older.csv by the sources with which rows of the table were measured.
`uv run --script ssik2026.py joints` makes the joints again."""
import csv
import importlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

here = pathlib.Path(__file__).resolve().parent
shipped = here / "../../results/published/ssik2026"
# The README's name of each arm, and ssik's module.
arms = {"UR5": "ur5", "UR3e": "ur3e", "UR5e": "ur5e", "UR10e": "ur10e", "Puma 560": "puma560", "JACO 2": "jaco2",
        "iiwa14": "iiwa14", "iiwa7": "iiwa7", "Franka Panda": "franka_panda", "FR3": "fr3", "xArm6": "xarm6", "Z1": "z1",
        "Gen3": "gen3", "PiPER": "piper", "xArm7": "xarm7", "Rizon 4": "rizon4"}
readme = "65139cc8efcf67f73aa39ee15928c7eb047d2a65"
# The arms whose counts 8.2.0 changed, by the commit that measured them for the README.
older = {"a649db1": ["PiPER", "Gen3"], "0564d8b": ["xArm7"]}


def make_joints():
    """The README's sampling, of which the first ten poses are a warm-up."""
    for n in 6, 7:
        random = np.random.default_rng(0)
        rows = []
        while len(rows) < 210:
            row = random.uniform(-0.5, 0.5, n)
            if n == 7:
                row[3] = random.uniform(0.3, 0.7)
            rows.append(row)
        with (shipped / f"joints-{n}.csv").open("w", newline="") as file:
            table = csv.writer(file, lineterminator="\n")
            table.writerow(["pose", *(f"q{i + 1}" for i in range(n))])
            table.writerows([i + 1, *map(repr, map(float, row))] for i, row in enumerate(rows[10:]))


def poses_of(arm):
    with (shipped / f"joints-{arm.DOF}.csv").open() as file:
        return [np.array(arm.fk(np.array(row[1:], float))) for row in list(csv.reader(file))[1:]]


def axes_of(forward):
    """Axes H, ways P between them and the tool's rotation at zero, from how the tool turns about each joint."""
    base, axes, points = np.array(forward(np.zeros(6))), [], []
    for i in range(6):
        turn = np.array(forward(np.eye(6)[i])) @ np.linalg.inv(base)
        axis = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
        axes.append(axis / np.linalg.norm(axis))
        points.append(np.linalg.lstsq(np.eye(3) - turn[:3, :3], turn[:3, 3], rcond=None)[0])
    ways = np.diff(np.vstack([np.zeros(3), points, base[:3, 3]]), axis=0)
    return np.round(np.array(axes), 12), ways, base[:3, :3]


def module_of(name):
    return importlib.import_module(f"ssik.prebuilt.{arms[name]}_ik")


def by_ssik(name):
    arm = module_of(name)
    return [len(arm.solve(pose, respect_limits=False)) for pose in poses_of(arm)]


def exact(found):
    return sum(not is_least for is_least in found.is_LS)


def by_axes(name):
    from eaik.pybindings import EAIK

    arm = module_of(name)
    axes, ways, tool = axes_of(arm.fk)
    robot = EAIK.Robot(axes.T, ways.T, tool, [], True)
    return robot.has_known_decomposition() and [exact(robot.calculate_IK(pose)) for pose in poses_of(arm)]


def by_file(name, file):
    from eaik.IK_URDF import UrdfRobot

    try:
        robot = UrdfRobot(str(file))
    except RuntimeError as refusal:
        print(name, refusal)
        return None
    return robot.hasKnownDecomposition() and [exact(robot.IK(pose)) for pose in poses_of(module_of(name))]


def archive(checkout, commit, part, folder):
    packed = subprocess.run(["git", "-C", checkout, "archive", commit, part], check=True, capture_output=True)
    subprocess.run(["tar", "-x", "-C", folder], input=packed.stdout, check=True)
    return pathlib.Path(folder) / part


def by_files(checkout, names):
    with tempfile.TemporaryDirectory() as folder:
        files = archive(checkout, readme, "tests/fixtures", folder)
        return {name: by_file(name, files / f"{arms[name]}.urdf") for name in names}


def by_older(checkout):
    counts = {}
    for commit, names in older.items():
        with tempfile.TemporaryDirectory() as folder:
            source = archive(checkout, commit, "src", folder)
            (source / "ssik/_version.py").write_text(f'__version__ = "{commit}"\n')
            way = os.pathsep.join([str(source), os.environ.get("PYTHONPATH", "")])
            told = subprocess.run([sys.executable, __file__, "count", *names], env={**os.environ, "PYTHONPATH": way},
                                  check=True, capture_output=True)
            counts |= json.loads(told.stdout)
    return counts


def write(file, counts):
    with file.open("w", newline="") as opened:
        table = csv.writer(opened, lineterminator="\n")
        table.writerow(["pose", *counts])
        table.writerows([i + 1, *(column[i] if column else "" for column in counts.values())] for i in range(200))


def main(out="out/ssik2026", checkout=""):
    folder = pathlib.Path(out)
    folder.mkdir(parents=True, exist_ok=True)
    six = [name for name in arms if module_of(name).DOF == 6]
    write(folder / "EAIK.csv", {name: by_axes(name) for name in six})
    if checkout:
        with_file = [name for name in six if name != "JACO 2"]
        write(folder / "EAIK-file.csv", by_files(checkout, with_file))
        write(folder / "ssik-older.csv", by_older(checkout))
    write(folder / "ssik.csv", {name: by_ssik(name) for name in arms})


if sys.argv[1:] == ["joints"]:
    make_joints()
elif sys.argv[1:2] == ["count"]:  # by the ssik of PYTHONPATH
    print(json.dumps({name: by_ssik(name) for name in sys.argv[2:]}))
else:
    main(*sys.argv[1:])

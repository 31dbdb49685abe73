"""What the helper ikbench.py tells of solves that spend their time elsewhere, and of what JSON does not take:
helper.py FOLDER_OF_HELPER."""
import json, math, os, subprocess, sys
sys.path.insert(0, sys.argv[1])
import ikbench


def prepare(robot):
    if robot.name == "not this":
        raise ikbench.Declined("not\nthis\u009d arm")
    print(os.path.dirname(robot.file), file=sys.stderr)


def solve(_, problem):
    if problem.seed == 1: subprocess.run([sys.executable, "-c", "import time\nwhile time.process_time() < 0.05: pass"])
    if problem.seed == 2: raise ikbench.Declined("\n" * 500)
    if problem.seed == 3: return [0.1, 0.2, 0.3]
    if problem.seed == 4: return [math.nan, math.inf]
    if problem.seed == 5: return [7.0, 1.0000004]
    if problem.seed == 6: problem.evaluate([[math.nan, 1]])
    if problem.seed == 7:
        problem.extras["restarts"] = 3
        return [[7.0, 0.0], (0.5, math.inf)]
    if problem.seed == 8: return {"q": [0.1, 0.2]}
    if problem.seed == 9: return [0.1, "x"]


if sys.argv[2:]:
    ikbench.run("elsewhere", prepare, solve)
    sys.exit()
joints = [{"name": name, "type": "revolute", "lower": -most, "upper": most} for name, most in (("a", 3), ("b", 1))]
told = lambda name: {"message": "robot", "name": name, "joints": joints, "urdf": "", "options": {}}
asked = lambda seed: {"message": "solve", "target": {"position": [0, 0, 0]}, "start": [0, 0], "lower": [-3, -1],
                      "upper": [3, 1], "tolerance": {}, "budget": {"seconds": 0}, "seed": seed}
messages = [told("this"), *map(asked, (1, 2, 3, 4, 5)), told("not this"), asked(1), told("this"), *map(asked, (0, 7, 6))]
ran = subprocess.run([sys.executable, __file__, sys.argv[1], "solve"], capture_output=True, text=True,
                     input="".join(json.dumps(each) + "\n" for each in messages))
of = [json.loads(line) for line in ran.stdout.splitlines()][1:]  # behind its hello
assert of[0]["seconds"] >= 0.05
assert all(each["message"] == "declined" and len(each["why"].encode()) <= 200 for each in (of[1], of[5]))
assert [of[i]["q"] for i in (2, 3)] == [[0.1, 0.2, 0.3], [None, None]]
assert abs(of[4]["q"][0] - 0.716814692820414) < 1e-12 and of[4]["q"][1] == 1
assert of[5]["why"] == "not this  arm" and of[6]["q"] == [0, 0] and of[8]["candidates"] == [[None, 1]]
assert of[7]["extras"].pop("setup_s") >= 0 and of[7]["extras"] == {"restarts": 3}
assert of[7]["answers"][1] == [0.5, None] and "q" not in of[7]
folders = ran.stderr.split()
assert folders and not any(map(os.path.exists, folders)), folders
# What is 7e-7 rad outside the limits, as single precision costs, comes inside.
inside = ikbench.inside([2.0000006, 2.0000008, 5, 9], [1, 1, 1, 0], [-2] * 4, [2] * 4)
assert [round(x, 9) for x in inside] == [2, 2.0000008, -1.283185307, 9]
# What is no answer is told with the joint and the value.
for seed, words in ((8, "a dict with 'q'"), (9, "'x' for joint b")):
    ran = subprocess.run([sys.executable, __file__, sys.argv[1], "solve"], capture_output=True, text=True,
                         input="".join(json.dumps(each) + "\n" for each in (told("this"), asked(seed))))
    assert ran.returncode and words in ran.stderr.splitlines()[-1], ran.stderr

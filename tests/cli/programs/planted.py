"""A solver with one planted fault."""
import json, math, os, random, signal, sys, time

FAULT = os.environ["FAULT"]

def say(**message):
    print(json.dumps(message), flush=True)

def position(q):  # from the tip to the base
    x, y, z = robot["tool"][3:12:4] if "frame" != FAULT else (0.1, 0, 0)
    for (theta, c_alpha, s_alpha, a, d), turned in zip(reversed(links), reversed(q)):
        c, s = math.cos(theta + turned), math.sin(theta + turned)
        y, z = c_alpha * y - s_alpha * z, s_alpha * y + c_alpha * z + d
        x, y = c * (x + a) - s * y, s * (x + a) + c * y
    return x, y, z

def answer(problem):
    global solves, last
    solves += 1
    target, draw, began = problem["target"]["position"], random.Random(problem["seed"]), time.monotonic()
    timed = problem["budget"]["seconds"] > 0
    if "hangs" == FAULT and target[0] > 5: time.sleep(1000)
    if "late" == FAULT and timed: time.sleep(0.1)
    best = list(problem["start"])
    if "dies-again" == FAULT and solves > 5 and target == last: os._exit(3)  # behind the warm-ups
    last = target
    if "remembers" == FAULT: best[0] += 1e-6 * solves
    if "of-process" == FAULT: best[0] += 1e-9 * os.getpid()
    error, steps, most = math.dist(position(best), target), 0, problem["budget"]["iterations"]
    for steps in range(1, 1 + (60 if "iterations" == FAULT else most)):
        if error < problem["tolerance"]["position"] or problem["budget"]["evaluations"] and "evaluations" != FAULT and steps * 8 > problem["budget"]["evaluations"]: break
        if timed and time.monotonic() - began > problem["budget"]["seconds"] / 5: break  # a busy machine takes the rest
        slopes = [(math.dist(position(best[:j] + [best[j] + 1e-6] + best[j + 1:]), target) - error) / 1e-6 for j in range(len(best))]
        reach = draw.random() * error / (sum(slope * slope for slope in slopes) or 1)
        q = [min(max(x - reach * slope, -3), 3) for x, slope in zip(best, slopes)]
        if math.dist(position(q), target) < error: best, error = q, math.dist(position(q), target)
    if "outside" == FAULT: best = [4.0] + best[1:]
    if "nan" == FAULT: best = [math.nan] + best[1:]
    claim = math.dist(position(best), target) if "nan" != FAULT else None
    if "lies" == FAULT: claim += 0.001
    if "frame" == FAULT: claim = None
    if "null" == FAULT: return {"q": None, "error": claim}
    return {"q": [None if x != x else x for x in best], "error": claim, "iterations": steps, "evaluations": 8 * steps}

solves, last = 0, None
if "silent" == FAULT: sys.exit(3)
say(message="hello", ikbench=2, name="planted", version="1", options=[
    {"name": "w", "type": "number", "default": 3 if "option" == FAULT else 0.5, "low": 0, "high": 1, "meaning": "nothing"}])
for line in sys.stdin:
    told = json.loads(line)
    if told["message"] == "robot":
        robot = told
        links = [(j["theta"], math.cos(j["alpha"]), math.sin(j["alpha"]), j["a"], j["d"]) for j in told["joints"]]
    elif any(joint["type"] != "revolute" for joint in robot["joints"]) and "slides" != FAULT: say(message="declined", why="it slides")
    elif robot["goal"] == "pose" and "pose" == FAULT: os._exit(1)
    elif robot["goal"] == ("position" if "whole" == FAULT else "pose") or robot["goal"] == "axis": say(message="declined", why="it turns")
    elif "nothing" == FAULT: say(message="declined", why="it is tired")
    elif "endless" == FAULT and None in [joint["upper"] for joint in robot["joints"]]: os._exit(1)
    else:
        say(message="solved", **answer(told))
        if "again" == FAULT: time.sleep(0.02), say(message="solved", q=[0] * 7)
if "twice" == FAULT: say(message="solved", q=[0] * 7)
if "stays" == FAULT and solves > 24:  # only the one whose end is looked at: each is waited for
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    time.sleep(1000)

"""A solver with own kinematics: of one joint after the other. Its fault and the number of the solve decide what it does."""
import json, math, os, signal, sys, time

FAULT = sys.argv[1] if len(sys.argv) > 1 else ""
held = None  # the answers of a batch

def say(**message):
    if held is not None: held.append(message)
    else: print(json.dumps(message), flush=True)

def once(fault):
    if FAULT != fault or os.path.exists(fault + " once"): return False  # its own name would be a file of it
    open(fault + " once", "w").close()
    return True

def falls_again(seed):
    """Whether this problem is one of the first two, or has been asked before."""
    with open("seeds", "a+") as file:
        file.seek(0)
        seen = file.read().split()
        print(seed, file=file)
    return len(seen) < 2 or str(seed) in seen

def stop_parent(*, answers):
    os.kill(os.getppid(), signal.SIGSTOP)
    if not answers: time.sleep(1000)

def batch(problems):
    global held, batches
    held = []
    for problem in problems: solve(problem)
    answers, held, told = held, None, {"seconds": 0.005 * len(problems)}
    time.sleep(told["seconds"])  # longer than its processor needs, also on a busy machine
    batches += len({problem["seed"] for problem in problems}) == len(problems)  # else it is a warm-up
    if batches == 2:
        if once("one too few"): answers.pop()
        if once("one too many"): answers.append(answers[-1])
        if once("another order"): answers.reverse()
        if once("a null"): answers[1]["q"][0] = None
        if once("no list"): answers = "none"
        if once("three wrong"):
            for wrong in answers[:3]: wrong["q"].pop()
        if once("seconds of a year"): told["seconds"] = 3e7
        if once("a question"): answers[1] = {"message": "evaluate", "candidates": [[0] * 7]}
        if once("declines one"): answers[1] = {"message": "declined", "why": "not this", "seed": problems[1]["seed"]}
        if once("falls"): os._exit(3)
        if once("never"): time.sleep(1000)
        if once("stops its parent"): stop_parent(answers=False)
    if FAULT == "always falls" and batches: os._exit(3)
    if FAULT == "sleeps" and batches: time.sleep(0.5)
    say(message="solved_batch", answers=answers, **told)

def ask(candidates):
    say(message="evaluate", candidates=candidates)
    return json.loads(sys.stdin.readline())

def tool(q):  # from the tip to the base: one point is cheaper than products of matrices
    x, y, z = (robot["tool"][i] for i in (3, 7, 11))
    for joint, turned in zip(reversed(robot["joints"]), reversed(q)):
        ca, sa, c, s = *joint["turn"], math.cos(joint["theta"] + turned), math.sin(joint["theta"] + turned)
        x, y, z = x + joint["a"], ca * y - sa * z, sa * y + ca * z + joint["d"]
        x, y = c * x - s * y, s * x + c * y
    return [sum(m * v for m, v in zip(robot["base"][i:i + 4], (x, y, z, 1))) for i in (0, 4, 8)]

def solve(problem):
    q, target = list(problem["start"]), problem["target"]["position"]
    error, step = math.dist(tool(q), target), 0.3
    for i in range(problem["budget"]["iterations"]):
        for j in range(len(q)):
            for way in (step, -step):
                other = list(q)
                other[j] += way
                found = math.dist(tool(other), target)
                if found < error: q, error = other, found
        step *= 0.8
    if FAULT == "warms badly" and problem["seed"] < 3: sys.exit(3)  # as solves that are not recorded have
    if FAULT == "late": time.sleep(2 * problem["budget"]["seconds"])
    counted = {"boasts": {"evaluations": 1}, "spends": {"evaluations": 1000}, "takes years": {"seconds": 1e8}, "no extras": {"extras": None},
               "new names": {"extras": {f"{solves}.{i}": i for i in range(10)}}}.get(FAULT, {})
    if FAULT == "eats" and solves == 11: bytearray(10**9)
    if FAULT == "asks once": ask([q])
    if FAULT == "asks at first": ask([problem["start"]])
    if FAULT == "asks on":
        while not ask([[0.1 * i for i in range(len(q))]])["over"]: pass
        ask([q])
    if FAULT == "several":
        far = [x + 0.3 for x in q]
        return say(message="solved", answers=[[9] * len(q), far, q, problem["start"]], extras={"restarts": 3, "nothing": None})
    say(message="solved", seed=problem["seed"], q=q, error=error + (0.01 if FAULT == "lies" else 0), **counted)

solves = batches = 0
say(message="hello", ikbench=2, name="faulty", version="1", batch=FAULT != "one by one", options=[
    {"name": "w", "type": "number", "default": 0.5, "low": 0, "high": 1, "meaning": "nothing"}])
for line in sys.stdin:
    told = json.loads(line)
    if told["message"] == "robot":
        robot = told
        for joint in robot["joints"]: joint["turn"] = math.cos(joint["alpha"]), math.sin(joint["alpha"])
    elif told["message"] == "solve_batch": batch(told["problems"])
    elif told["message"] == "solve":
        solves += 1
        if FAULT == "hangs" and solves == 7 and not os.path.exists("hung"):
            open("hung", "w").close()
            time.sleep(1000)
        if solves == 7 and once("stops its parent"): stop_parent(answers=False)
        if FAULT == "stops it and answers": stop_parent(answers=True)
        if FAULT == "dies" and solves == 11 and not os.path.exists("died"):
            open("died", "w").close()
            print("no more", file=sys.stderr)
            os._exit(3)
        if FAULT == "falls again" and told["seed"] > 2 and falls_again(told["seed"]): os._exit(3)
        if FAULT == "noise": print("Iteration 1 of 200\nnull", flush=True)
        if FAULT == "deep" and solves == 10: print('{"message":"solved","q":%s}' % ("[" * 400000 + "]" * 400000), flush=True)
        elif FAULT == "declines": say(message="declined", why="not today")
        elif FAULT == "nonsense" and solves == 10: say(message="solved", q="none")
        elif FAULT == "a text" and solves == 10: say(message="solved", q=[0] * 7, extras={"restarts": "three"})
        elif FAULT == "not JSON" and solves == 10: print('{"message":"solved","q":[NaN]}', flush=True)
        else: solve(told)
        if FAULT == "twice": time.sleep(0.02), solve(told)
        if FAULT == "late twice" and solves == 10: time.sleep(0.2), solve(told)

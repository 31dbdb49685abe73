# check-solver passes a good program, and finds each of the faults that are planted in it, one at a time: by its own line, and
# by no other.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
command -v python3 >/dev/null || { echo "SKIPPED: no python3"; exit 77; }

cat >planted.py <<'EOF'
import json, math, os, random, signal, sys, time

FAULT = os.environ["FAULT"]

def say(**message):
    print(json.dumps(message), flush=True)

def position(q):  # from the tip to the base
    x = y = z = 0
    for (theta, c_alpha, s_alpha, a, d), turned in zip(reversed(links), reversed(q)):
        c, s = math.cos(theta + turned), math.sin(theta + turned)
        y, z = c_alpha * y - s_alpha * z, s_alpha * y + c_alpha * z + d
        x, y = c * (x + a) - s * y, s * (x + a) + c * y
    return x, y, z

def answer(problem):
    global solves
    solves += 1
    target, draw, began = problem["target"]["position"], random.Random(problem["seed"]), time.monotonic()
    timed = problem["budget"]["seconds"] > 0
    if "one-seed" == FAULT: draw = random.Random(1)
    if "hangs" == FAULT and target[0] > 5 and not timed: time.sleep(1000)
    if "empty-budget" == FAULT and problem["budget"]["iterations"] == 0: os._exit(4)
    if "late" == FAULT and timed: time.sleep(0.1)
    if "noise" == FAULT: print("solving", flush=True)
    best = list(problem["start"])
    if "remembers" == FAULT: best[0] += 1e-6 * solves
    if "of-process" == FAULT: best[0] += 1e-9 * os.getpid()
    error = math.dist(position(best), target)
    for i in range(min(problem["budget"]["iterations"], 5 if len(best) > 7 else 10**9)):
        if 0 < problem["budget"]["seconds"] < time.monotonic() - began: break
        q = [min(max(x + draw.gauss(0, 0.1), -3), 3) for x in best]
        if math.dist(position(q), target) < error: best, error = q, math.dist(position(q), target)
    if "outside" == FAULT: best = [4.0] + best[1:]
    if "nan" == FAULT: best = [math.nan] + best[1:]
    claim = math.dist(position(best), target) if "nan" != FAULT else None
    if "lies" == FAULT: claim += 0.001
    return {"q": [None if x != x else x for x in best], "error": claim}

solves = 0
if "silent" == FAULT: sys.exit(3)
say(ikbench=1, message="hello", name="planted", version="1", modes=["solve"], deterministic="pretends" == FAULT, options=[
    {"name": "w", "type": "number", "default": 3 if "option" == FAULT else 0.5, "low": 0, "high": 1, "meaning": "nothing"}])
for line in sys.stdin:
    told = json.loads(line)
    if told["message"] == "robot":
        robot = told
        links = [(j["theta"], math.cos(j["alpha"]), math.sin(j["alpha"]), j["a"], j["d"]) for j in told["joints"]]
        if any(joint["type"] != "revolute" for joint in told["joints"]) and "slides" != FAULT:
            say(message="declined", why="it slides")
            continue
        if "long" == FAULT and len(robot["joints"]) > 7: os._exit(1)
        if "endless" == FAULT and None in [joint["upper"] for joint in robot["joints"]]: os._exit(1)
        say(message="ready")
    elif told["message"] == "solve": say(message="solved", id=told["id"] + ("id" == FAULT), **answer(told))
    elif told["message"] == "bye" and "deaf" != FAULT: sys.exit()
if "stays" == FAULT:
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    time.sleep(1000)
EOF

# finds LIST COMMAND...: for each line of the list, with that fault alone ($FAULT), checks how many checks fail and how
# each of them begins. A budget of 1 ms says nothing on a busy machine, except with the fault "late".
finds() {
  local list=$1 fault number words
  shift
  while read -r fault number words; do
    export FAULT=$fault
    run_it check-solver --patience 10 "$@"
    sed ':a;N;$!ba;s/\n  / /g' .out | grep '^FAILED' | grep -v "$([ "$fault" = late ] && echo '^$' || echo 'a budget of 1 ms')" >found
    [ "$(wc -l <found)" = "$number" ] || fail "$fault: expected $number failed checks: $(<found) $err"
    [ "$number" = 0 ] || [ "$code" = 1 ] || fail "$fault: exit code $code: $out"
    ! grep -v "$words" found || fail "$fault: expected '$words' alone: $out"
  done <<<"$list"
}

finds 'good 0
silent 1 says a proper hello: it ends before its hello (exit code 3)
option 1 says a proper hello: its option w has no default between low and high
long 1 an arm of 64 joints, or declines: crashed
outside 1 inside the joint limits: 0.858 rad outside
remembers 1 the same seed gives the same answer in the same process
of-process 1 the same seed gives the same answer in a fresh process
one-seed 0
endless 1 an arm whose joints turn without end, or declines: crashed
lies 2 or declines: it says\|the error that it claims is true: it says
hangs 1 a target that nothing reaches ends too: timed_out
empty-budget 1 a budget of 0 iterations: crashed
late 1 it keeps a budget of 1 ms within ten times: 
nan 1 its answer is finite
slides 1 an arm with a joint that slides, or declines: it says
pretends 1 it does not say that it is deterministic: another seed changes its answer
id 3 joints*, or declines: broke_protocol: its solved does not have the id
deaf 1 it ends when it is told bye: it still runs
stays 1 it ends with its standard input: it had to be ended: signal 9
noise 1 it writes nothing but messages: .* the first: solving' -- python3 planted.py
refused "COMMAND" check-solver
FAULT=one-seed succeeds check-solver -- python3 planted.py
has "$out" "here another seed changed nothing; if none ever does, say deterministic"

echo "check-solver: all right"

# check-solver passes a good program and a good shared object, and finds each of the faults that are planted in them, one at a
# time: by its own line, and by no other.
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
    if "leaks" == FAULT: leak.append(bytearray(100000))
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

def solve_batch(told):
    if "batch-of-one" == FAULT: told["problems"].pop()
    solutions = [answer(problem) for problem in told["problems"]]
    if "mixes" == FAULT: solutions.reverse()
    say(message="solved_batch", id=told["id"], solutions=solutions)

leak, solves = [], 0
if "silent" == FAULT: sys.exit(3)
say(ikbench=1, message="hello", name="planted", version="1", modes=["solve"], deterministic="pretends" == FAULT,
    batch=1000 if "greedy" == FAULT else 4, options=[
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
    elif told["message"] == "ping": say(message="pong", id=told["id"])
    elif told["message"] == "solve": say(message="solved", id=told["id"] + ("id" == FAULT), **answer(told))
    elif told["message"] == "solve_batch": solve_batch(told)
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

# The faults of programs and objects alike.
alike='good 0
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
leaks 1 its memory does not grow over 1000 solves: +'
finds "$alike
nan 1 its answer is finite
slides 1 an arm with a joint that slides, or declines: it says
pretends 1 it does not say that it is deterministic: another seed changes its answer
id 3 joints*, or declines: broke_protocol: its solved does not have the id
greedy 1 says a proper hello: its batch is not a count from 1 to 500
mixes 1 the same answer in a batch as alone: problem 1 differs by
batch-of-one 1 the same answer in a batch as alone: broke_protocol: its solutions are not a list of 3
deaf 1 it ends when it is told bye: it still runs
stays 1 it ends with its standard input: it had to be ended: signal 9
noise 1 it writes nothing but messages: .* the first: solving" -- python3 planted.py
refused "COMMAND" check-solver
FAULT=one-seed succeeds check-solver -- python3 planted.py
has "$out" "here another seed changed nothing; if none ever does, say deterministic"

# The faults of a shared object.
command -v c++ >/dev/null || { echo "left out: no C++ compiler"; echo "check-solver: programs are all right"; exit; }
cat >planted.cpp <<'EOF'
#include <unistd.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ikbench_plugin.hpp>
#include <random>
#include <vector>

static bool has(const char* fault) {
  const char* const planted = std::getenv("FAULT");
  return planted != nullptr && std::strcmp(planted, fault) == 0;
}

static bool has_solved = false;  // a process that stays takes 2 s to end, and most of them solve

static struct Whole {
  Whole() {
    if (has("silent")) _exit(3);
    if (has("mode")) std::fesetround(FE_UPWARD);
  }
  ~Whole() {
    if (!has("stays") || has_solved) return;
    std::signal(SIGTERM, SIG_IGN);
    sleep(1000);
  }
} whole;

struct Planted {
  explicit Planted(const ikbench_robot& robot) : joints(robot.joints) {
    if (has("long") && joints > 7) std::abort();
    if (has("throws") && joints > 7) throw 7;
    if (has("endless") && std::isinf(robot.upper[0])) std::abort();
    if (std::count(robot.types, robot.types + joints, 1) > 0) throw ikbench_plugin::Declined("it slides");
  }
  void start(const ikbench_problem& told, ikbench_plugin::Objective& objective, ikbench_plugin::Best& best) {
    static int solves = 0;
    has_solved = ++solves > 0;
    own.seed(has("one-seed") ? 1 : told.seed);
    if (has("remembers")) best.q[0] += 1e-6 * solves;
    if (has("of-process")) best.q[0] += 1e-9 * getpid();
    if (has("hangs") && told.target[3] > 5 && told.seconds == 0) sleep(1000);
    if (has("empty-budget") && told.iterations == 0) _exit(4);
    if (has("late") && told.seconds > 0) usleep(100000);
    if (has("leaks")) std::memset(std::malloc(100000), 1, 100000);
    if (has("fails")) throw std::runtime_error("no more");
    best.error = objective.error(best.q);
    q.assign(best.q, best.q + joints);
    spoil(objective, best);
  }
  void step(ikbench_plugin::Objective& objective, ikbench_plugin::Best& best) {
    std::vector<double> next = q;
    for (double& x : next) x += 0.1 * (own() / 4294967296.0 - 0.5);
    const double error = objective.error(next.data());
    if (!(error < objective.error(q.data()))) return;
    best.error = error;
    q = next;
    std::copy(q.begin(), q.end(), best.q);
    spoil(objective, best);
  }
  void spoil(ikbench_plugin::Objective& objective, ikbench_plugin::Best& best) const {
    if (has("outside")) best.q[0] = 4;
    if (has("outside")) best.error = objective.error(best.q);
    if (has("lies")) best.error += 0.001;
    if (has("nan")) best.q[0] = std::nan("");
  }
  int joints;
  std::vector<double> q;
  std::mt19937 own;
};
static const char* const option = R"([{"name": "w", "type": "number", "default": 3, "low": 0, "high": 1}])";
IKBENCH_SOLVERS(ikbench_plugin::solver<Planted>("planted", "1", has("option") ? option : nullptr))
EOF
c++ -std=c++17 -O1 -Wall -Wextra -fPIC -shared -I "$scripts/../../experiments/foreign/plugin" -o planted.so planted.cpp \
  2>c++.err || fail "$(<c++.err)"
# A solver that throws in its constructor declines; this answer that is not finite has a finite error.
finds "$alike
nan 2 its answer is finite\|the error that it claims is true: it says
throws 0
fails 3 joints*, or declines: crashed
stays 2 it ends w
mode 1 it leaves the floating-point mode as it is when it is loaded" ./planted.so
run_it check-solver ./missing.so
has "$out" "there is no file"
echo "check-solver: all right"

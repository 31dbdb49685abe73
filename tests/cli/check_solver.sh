# check-solver passes a good program and finds each planted fault.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
command -v python3 >/dev/null || { echo "SKIPPED: no python3"; exit 77; }

cat >planted.py <<'EOF'
import json, math, os, random, signal, sys, time

FAULTS = sys.argv[1:]

def say(**message):
    print(json.dumps(message), flush=True)

def position(q):
    pose = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    for joint, x in zip(robot["joints"], q):
        c, s, ca, sa = math.cos(joint["theta"] + x), math.sin(joint["theta"] + x), math.cos(joint["alpha"]), math.sin(joint["alpha"])
        m = [[c, -s * ca, s * sa, joint["a"] * c], [s, c * ca, -c * sa, joint["a"] * s], [0, sa, ca, joint["d"]], [0, 0, 0, 1]]
        pose = [[sum(pose[i][k] * m[k][j] for k in range(4)) for j in range(4)] for i in range(4)]
    return [row[3] for row in pose[:3]]

def solve(problem):
    target, draw, began = problem["target"]["position"], random.Random(problem["seed"]), time.monotonic()
    if "same" in FAULTS: draw = random.Random(1)
    if "forgets" in FAULTS: draw = random.Random()
    if "hangs" in FAULTS and target[0] > 5: time.sleep(1000)
    if "empty-budget" in FAULTS and problem["budget"]["iterations"] == 0: os._exit(4)
    if "late" in FAULTS and problem["budget"]["seconds"] > 0: time.sleep(0.3)
    if "leaks" in FAULTS: leak.append(bytearray(100000))
    if "noise" in FAULTS: print("solving", flush=True)
    best = problem["start"]
    error = math.dist(position(best), target)
    for i in range(min(problem["budget"]["iterations"], 5 if len(best) > 7 else 10**9)):
        if 0 < problem["budget"]["seconds"] < time.monotonic() - began: break
        q = [min(max(x + draw.gauss(0, 0.1), -3), 3) for x in best]
        if math.dist(position(q), target) < error: best, error = q, math.dist(position(q), target)
    if "outside" in FAULTS: best = [4.0] + best[1:]
    if "nan" in FAULTS: best = [math.nan] + best[1:]
    claim = math.dist(position(best), target) if "nan" not in FAULTS else None
    if "lies" in FAULTS: claim += 0.001
    say(message="solved", id=problem["id"] + ("id" in FAULTS), q=[None if x != x else x for x in best], error=claim)

leak = []
if "silent" in FAULTS: sys.exit(3)
say(ikbench=1, message="hello", name="planted", version="1", modes=["solve"], options=[
    {"name": "w", "type": "number", "default": 3 if "option" in FAULTS else 0.5, "low": 0, "high": 1, "meaning": "nothing"}])
for line in sys.stdin:
    told = json.loads(line)
    if told["message"] == "robot":
        robot = told
        if "long" in FAULTS and len(robot["joints"]) > 7: os._exit(1)
        say(message="ready")
    elif told["message"] == "ping": say(message="pong", id=told["id"])
    elif told["message"] == "solve": solve(told)
    elif told["message"] == "bye" and "stays" not in FAULTS: break
if "stays" in FAULTS:
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    time.sleep(1000)
EOF

failures() { # failures FAULT...: the lines that failed
  run_it check-solver --patience 10 -- python3 planted.py "$@"
  grep '^FAILED' <<<"$out"
}

# expect_twelve WORDS: in `found`, the eleven faults that a program and an object have alike, and this one.
expect_twelve() {
  local words
  for words in "an arm of 64 joints, or declines: crashed" "inside the joint limits: 0.858 rad outside" \
    "same answer in the same process" "same answer in a fresh process" "the error that it claims is true: it says" \
    "a target that nothing reaches ends too: timed_out" "a budget of 0 iterations: crashed" \
    "a budget of 1 ms within ten times: " "its memory does not grow" "ends when it is told bye: it still runs" \
    "ends with its standard input: it had to be ended: signal 9" "$1"; do
    grep -q "$words" found || fail "did not find '$words' in: $(<found)"
  done
  [ "$(wc -l <found)" = 12 ] || fail "expected 12 failures: $(<found)"
}

failures >found
grep -v "a budget of 1 ms" found && fail "a good program fails: $out $err" # but where the machine is busy

failures lies outside forgets hangs empty-budget late leaks noise long stays >found
[ "$code" = 1 ] || fail "exit code $code: $out"
expect_twelve "nothing but messages"

failures nan >found
grep -q "its answer is finite" found || fail "$(<found)"
failures same >found
grep -q "the answer is the same, and it does not say so" found || fail "$(<found)"

failures late >found
has "$(<found)" "a budget of 1 ms within ten times: "

failures option >found
[ "$(<found)" = "FAILED  it says a proper hello: its option w has no default between low and high" ] || fail "$(<found)"
failures silent >found
[ "$(<found)" = "FAILED  it says a proper hello: it ends before its hello (exit code 3)" ] || fail "$(<found)"
failures id >found
has "$(<found)" "joints, or declines: broke_protocol: its solved does not have the id"
refused "COMMAND" check-solver

# The same of a shared object; $FAULTS has the faults.
command -v c++ >/dev/null || { echo "left out: no C++ compiler"; echo "check-solver: programs are all right"; exit; }
cat >planted.cpp <<'EOF'
#include <unistd.h>

#include <algorithm>
#include <cfenv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ikbench_plugin.hpp>
#include <random>
#include <vector>

static bool has(const char* fault) {
  const char* const faults = std::getenv("FAULTS");
  return faults != nullptr && std::strstr(faults, fault) != nullptr;
}

static struct Whole {
  Whole() {
    if (has("mode")) std::fesetround(FE_UPWARD);
  }
  ~Whole() {
    if (!has("stays")) return;
    std::signal(SIGTERM, SIG_IGN);
    sleep(1000);
  }
} whole;

struct Planted {
  explicit Planted(const ikbench_robot& robot) : joints(robot.joints) {
    if (has("long") && joints > 7) std::abort();
    if (has("throws") && joints > 7) throw 7;
  }
  void start(const ikbench_problem& told, ikbench_plugin::Objective& objective, ikbench_plugin::Best& best) {
    if (has("hangs") && told.target[3] > 5) sleep(1000);
    if (has("empty-budget") && told.iterations == 0) _exit(4);
    if (has("late") && told.seconds > 0) usleep(300000);
    if (has("leaks")) std::memset(std::malloc(100000), 1, 100000);
    if (has("fails")) throw std::runtime_error("no more");
    best.error = objective.error(best.q);
    if (has("lies")) best.error += 0.001;
    q.assign(best.q, best.q + joints);
    if (has("outside")) best.q[0] = 4;
  }
  void step(ikbench_plugin::Objective& objective, ikbench_plugin::Best& best) {
    std::vector<double> next = q;
    std::random_device chance;
    for (double& x : next) x += 0.1 * ((has("forgets") ? chance() / 4294967296.0 : objective.uniform()) - 0.5);
    const double error = objective.error(next.data()) + (has("lies") ? 0.001 : 0);
    if (!(error < best.error)) return;
    best.error = error;
    q = next;
    std::copy(q.begin(), q.end(), best.q);
    if (has("outside")) best.q[0] = 4;
  }
  int joints;
  std::vector<double> q;
};
IKBENCH_SOLVERS(ikbench_plugin::solver<Planted>("planted", "1"))
EOF
c++ -std=c++17 -O1 -Wall -Wextra -fPIC -shared -I "$scripts/../../experiments/foreign/plugin" -o planted.so planted.cpp \
  2>c++.err || fail "$(<c++.err)"
failures_of_object() { # failures_of_object FAULTS: the lines that failed
  export FAULTS=$1
  run_it check-solver --patience 5 ./planted.so
  grep '^FAILED' <<<"$out"
}

failures_of_object "" >found
grep -v "a budget of 1 ms" found && fail "a good object fails: $out $err"

failures_of_object "outside lies forgets hangs empty-budget late leaks long stays mode" >found
[ "$code" = 1 ] || fail "exit code $code: $out"
expect_twelve "leaves the floating-point mode"
failures_of_object throws >found
grep -q "an arm of 64 joints" found && fail "what throws when it is made declines: $(<found)"
failures_of_object fails >found
grep -q "an arm of 7 joints, or declines: crashed" found || fail "$(<found)"
unset FAULTS
run_it check-solver ./missing.so
has "$out" "there is no file"
echo "check-solver: all right"

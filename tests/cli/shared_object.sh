# Solvers in shared objects: the paper's give the same answers as built in, each fault is a row that says what it is, and
# nothing changes of the others'.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
plugin=$scripts/../../experiments/foreign/plugin
six=$(dirname "$program")/tests/plugins/ikbench_six.so

# The same files behind the interface: the same bits in every column that is not a time, and the same files for IOHprofiler. The label decides the stream.
solvers=(ik_bat bat particle_swarm differential_evolution k_artificial_bee_colony multi_objective_swarm)
same_as_built_in() { # same_as_built_in KEYS [KEYS]: of a study, and of its [stop]
  local kind solver
  rm -rf built_in hosted
  for kind in built_in hosted; do
    {
      printf 'name = "six"\nruns = 2\nrepeats = 2\npopulation = 13\ntrace = "best_error"\n%b\n' "$1"
      printf '[path]\nkind = "random"\npoints = 4\n[stop]\niterations = 30\ntolerance_cm = 0.05\n%b' "${2:-}"
      for solver in "${solvers[@]}"; do
        printf '[[solvers]]\nlabel = "%s"\nsolver = "%s"\n' "$solver" "$solver"
        [ $kind = built_in ] || printf 'shared_object = "%s"\n' "$six"
      done
    } >$kind.toml
    succeeds run $kind.toml --no-report --out $kind
    "$program" export $kind/store.sqlite | awk -F, '
      NR == 1 { for (i = 1; i <= NF; ++i) if ($i ~ /seconds$|^(series|repeats|interruptions|timing|session)$/) other[i] = 1 }
      { for (i = 1; i <= NF; ++i) if (!(i in other)) printf "%s,", $i; print "" }' >$kind.csv
    "$program" export $kind/store.sqlite --format json | grep -o '"\(trace_cm\|improved_at\|improved_to_cm\)":\[[^]]*' >$kind.lists
    succeeds export $kind/store.sqlite --format iohprofiler -o $kind/ioh
    [ -z "$err" ] || fail "a solver is left out: $err"
  done
  [ "$(grep -c '"improved_at":\[1[.,]' hosted.lists)" = 48 ] || fail "no evaluations of improvements: $(head -c 300 hosted.lists)"
  cmp built_in.lists hosted.lists || fail "the hosted solvers converge in another way"
  diff -r -x '*.json' built_in/ioh hosted/ioh >/dev/null || fail "IOHprofiler gets other numbers of hosted solvers"
  cmp built_in.csv hosted.csv || fail "the hosted solvers give other answers: $(diff built_in.csv hosted.csv | head -4)"
}
same_as_built_in 'robot = "ur5e"\nsearch = "pose"' 'tolerance_deg = 0.1\n'
same_as_built_in 'robot = "stanford"\nsearch = "all_joints"'
same_as_built_in 'robot = "dobot_magician"\nsearch = "all_joints"'
same_as_built_in ''
[ "$(wc -l <hosted.csv)" = 49 ] || fail "$(wc -l <hosted.csv) lines"
[ "$(column hosted/store.sqlite counted_by ik_bat | counted)" = "8 suite" ] || fail "not counted here"
[ "$(column hosted/store.sqlite timing bat | counted)" = "$(column built_in/store.sqlite timing bat | counted)" ] ||
  fail "timed in another way: $(column hosted/store.sqlite timing bat | counted)"

command -v c++ >/dev/null || { echo "left out: no C++ compiler"; echo "shared objects: the paper's solvers are all right"; exit; }

# faulty.cpp: solvers that fail at their third solve, in the process that is the first.
cat >faulty.cpp <<'END'
#include <unistd.h>

#include <cfenv>
#include <cstdlib>
#include <ikbench_plugin.hpp>

#ifdef WHEN_LOADED
__attribute__((constructor)) static void when_loaded() { std::fesetround(FE_UPWARD); }
#endif

enum Fault { none, segfaults, exits, aborts, throws, hangs, changes_mode, declines, lies, prints };

template <Fault fault>
struct Faulty {
  explicit Faulty(const ikbench_robot& robot) : joints(robot.joints) {}
  void start(const ikbench_problem& problem, ikbench_plugin::Objective& objective, ikbench_plugin::Best& best) {
    best.error = objective.error(best.q);
    static int solves = 0;
    if (++solves == 6 && access("failed", F_OK) != 0) fail();  // three of them go unrecorded
    if (fault == prints) std::puts("{\"message\":\"solved\",\"id\":1,\"q\":[0,0,0,0,0,0,0]}"), std::fflush(stdout);
    if (fault == lies) best.error += 0.01;
    static_cast<void>(problem);
  }
  void step(ikbench_plugin::Objective& objective, ikbench_plugin::Best& best) {
    double q[64];
    for (int j = 0; j < joints; ++j) q[j] = best.q[j] + 0.1 * (objective.uniform() - 0.5);
    const double error = objective.error(q);
    if (fault == lies || !(error < best.error)) return;
    best.error = error;
    for (int j = 0; j < joints; ++j) best.q[j] = q[j];
  }
  void fail() {
    if (fault == segfaults || fault == exits || fault == aborts || fault == throws || fault == hangs)
      std::fclose(std::fopen("failed", "w"));
    volatile int* nowhere = nullptr;
    if (fault == segfaults) *nowhere = 1;
    if (fault == exits) std::exit(0);
    if (fault == aborts) std::abort();
    if (fault == throws) throw std::runtime_error("no more");
    if (fault == hangs) sleep(1000);
    if (fault == changes_mode) std::fesetround(FE_UPWARD);
    if (fault == declines) throw ikbench_plugin::Declined("not today");
  }
  int joints;
};

template <Fault fault>
constexpr ikbench_solver faulty(const char* name) {
  return ikbench_plugin::solver<Faulty<fault>>(name, "1.0");
}
IKBENCH_SOLVERS(faulty<none>("none"), faulty<segfaults>("segfaults"), faulty<exits>("exits"), faulty<aborts>("aborts"),
                faulty<throws>("throws"), faulty<hangs>("hangs"), faulty<changes_mode>("changes_mode"),
                faulty<declines>("declines"), faulty<lies>("lies"), faulty<prints>("prints"))
END
build() { c++ -std=c++17 -O1 -Wall -Wextra -fPIC -shared -I "$plugin" "$@" 2>c++.err || fail "$(<c++.err)"; }
build -o faulty.so faulty.cpp

entry() { # entry SOLVER [FURTHER KEYS]
  printf '[[solvers]]\nlabel = "mine"\nshared_object = "./faulty.so"\nsolver = "%s"\npatience_s = 1\n%s\n' "$1" "${2:-}"
}

study good "$(entry none)"
succeeds run good.toml --no-report --out good
[ "$(column good/store.sqlite status mine | counted)" = "16 ok" ] || fail "$(column good/store.sqlite status mine | counted)"
[ "$(column good/store.sqlite evaluations mine | counted)" = "16 9" ] || fail "$(column good/store.sqlite evaluations mine)"

# expect FAULT STATUS NUMBER: so many rows have the status, and nothing else changes.
expect() {
  rm -f failed
  study "$1" "$(entry "$1")"
  succeeds run "$1.toml" --no-report --out "$1"
  local store=$1/store.sqlite seen
  seen=$(column "$store" status mine | counted)
  [ "$(column "$store" status mine | grep -c "^$2\$")" = "$3" ] || fail "$1: $seen; $err"
  [ "$(column "$store" position_error_cm DLS)" = "$(column good/store.sqlite position_error_cm DLS)" ] ||
    fail "$1 changed the numbers of another solver"
  words=$err
}
expect segfaults crashed 1
expect exits crashed 1
has "$words" "exit code 0"
expect aborts crashed 1
expect throws crashed 1
has "$words" "no more"
expect hangs timed_out 1
expect changes_mode broke_protocol 5 # one in three solves of every process, as the first three are no more than a warm-up
has "$words" "it changed the floating-point mode"
expect declines declined 1
expect lies claimed_but_wrong 16
expect prints ok 16

# It gets its options; the number of evaluations shows them: 1, 10 if the flag is set, 100 times the way.
cat >told.cpp <<'END'
#include <ikbench_plugin.hpp>

struct Told {
  explicit Told(const ikbench_robot& robot)
      : evaluations(1 + 10 * static_cast<int>(robot.options[0]) + 100 * static_cast<int>(robot.options[1])) {}
  void start(const ikbench_problem&, ikbench_plugin::Objective& objective, ikbench_plugin::Best& best) {
    for (int i = 0; i < evaluations; ++i) best.error = objective.error(best.q);
  }
  int evaluations;
};
IKBENCH_SOLVERS(ikbench_plugin::solver<Told>("told", "1", R"([
  {"name": "flag", "type": "boolean", "default": true},
  {"name": "way", "type": "choice", "choices": ["left", "right", "up"], "default": "up"}])",
  ikbench_plugin::Deterministic::yes))
END
build -o told.so told.cpp
while read -r evaluations options; do
  study told "$(printf '[[solvers]]\nlabel = "told"\nshared_object = "./told.so"\noptions = { %s }' "$options")"
  succeeds run told.toml --no-report --out told
  [ "$(column told/store.sqlite evaluations told | counted)" = "16 $evaluations" ] ||
    fail "options $options: $(column told/store.sqlite evaluations told | counted)"
done <<'END'
211
201 flag = "false"
11 flag = "true", way = "left"
101 flag = "false", way = "right"
END
study told "$(printf '[[solvers]]\nlabel = "told"\nshared_object = "./told.so"\noptions = { flag = "yes" }')"
refused 'option flag is "yes"' run told.toml

# A changed mode when it is loaded is undone and told.
build -DWHEN_LOADED -o loaded.so faulty.cpp
study loaded "$(entry none | sed 's/faulty.so/loaded.so/')"
succeeds run loaded.toml --no-report --out loaded
has "$err" "lines that are no messages: 1"
[ "$(column loaded/store.sqlite position_error_cm mine)" = "$(column good/store.sqlite position_error_cm mine)" ] ||
  fail "the mode of the processor was not restored"

# A second run solves nothing; another object is another one.
succeeds run good.toml --no-report --out good
has "$out" "(32 were already stored)"
build -DEDITED=1 -O2 -o faulty.so faulty.cpp
succeeds run good.toml --no-report --out good
has "$err" "16 solves of mine come from another version"

# A user's mistakes.
study mistake "$(entry nobody)"
refused 'it has no solver "nobody"; expected one of none, segfaults' run mistake.toml
study mistake '[[solvers]]
shared_object = "./missing.so"'
refused 'there is no file' run mistake.toml
study mistake '[[solvers]]
shared_object = "./mistake.toml"'
refused 'cannot load it' run mistake.toml
echo 'int x;' >empty.c
cc -shared -fPIC -o empty.so empty.c
study mistake '[[solvers]]
shared_object = "./empty.so"'
refused 'has no function ikbench_solver_at' run mistake.toml
study mistake '[[solvers]]
shared_object = "./faulty.so"
process = ["true"]'
refused 'expected one of them' run mistake.toml
study mistake "$(entry none 'options = { w = 1 }')"
refused 'unknown option "w"' run mistake.toml
echo "shared objects: all right"

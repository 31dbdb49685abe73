#!/usr/bin/env bash
# Programs write mutants of each message of the protocol. None of them ends ikbench by a signal or by a fault of its own, none
# makes it wait longer than its timeout, and each solve gets the status that the protocol says.
#
#   tests/cli/mutated_messages.sh PROGRAM            a few mutants of each message, as ./check does
#   tests/cli/mutated_messages.sh PROGRAM 400        400 of each
#
# IKBENCH_MUTANTS_SEED=N draws other mutants.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
count=${2:-12}
seed=${IKBENCH_MUTANTS_SEED:-1}
cp "$scripts/programs/mutating.py" .
echo "mutated_messages.sh: $count of each, IKBENCH_MUTANTS_SEED=$seed"

# mutants KIND ENTRIES MORE: a study with a program for every two mutants, since a program that fails three times in a row is
# not asked again.
mutants() {
  local i
  printf 'robot = "kuka_iiwa14"\nsearch = "all_joints"\nruns = 1\nstart = "random"\n[path]\nkind = "random"\npoints = 2\n[stop]\nevaluations = 100\niterations = 100\n%s\n' "${3:-}"
  printf '[[solvers]]\nlabel = "DLS"\nsolver = "damped_least_squares"\n'
  for ((i = 0; i < $2; ++i)); do
    printf '[[solvers]]\nlabel = "M%s"\nprocess = ["python3", "mutating.py", "%s", "%s.%s", "of-%s-%s"]\ntimeout_s = 20\n' "$i" "$1" "$seed" "$i" "$1" "$i"
  done
}

# ended KIND SECONDS COMMAND...: it ends within so many seconds, with one of its exit codes, and says nothing that only a
# programmer understands.
ended() {
  local code=0
  timeout "$2" "$program" "${@:3}" >.out 2>.err </dev/null || code=$?
  ((code <= 3)) || fail "a mutant of $1 (IKBENCH_MUTANTS_SEED=$seed): exit code $code; it said $(tail -c 600 .err)"
  ! grep -iE 'internal|std::|nlohmann|json\.exception|bad_alloc' .err || fail "a mutant of $1 (IKBENCH_MUTANTS_SEED=$seed): words of a programmer"
}

for kind in solved evaluate; do
  mutants $kind $((count / 2)) >$kind.toml
  ended $kind $((60 + count)) run $kind.toml --no-report --out $kind
  python3 - $kind <<'END' || fail "other statuses of $kind, IKBENCH_MUTANTS_SEED=$seed"
import collections, json, sqlite3, sys
kind, counts, wrong = sys.argv[1], collections.Counter(), []
for label, target, status in sqlite3.connect(f"{kind}/store.sqlite").execute(
        "SELECT label, target_position_m, status FROM solves WHERE label <> 'DLS'"):
    noted = [line[1:] for line in map(json.loads, open(f"of-{kind}-{label[1:]}.log")) if line[0] == json.loads(target)]
    counts[status] += 1
    if not noted or noted[0][0] and status not in noted[0][0]: wrong.append((label, status, *(noted or [[None, None]])[0]))
for each in wrong: print("%s is %s, expected %s, after %s" % each, file=sys.stderr)
print(f"{kind}: {sum(counts.values())} solves: {dict(counts)}")
sys.exit(bool(wrong or not counts))
END
done
mutants batch $((count / 2)) | sed 's/^timeout_s.*/&\nbatch = 2/' >batch.toml
ended batch $((60 + count)) run batch.toml --no-report --out batch
equal "solves of batches" "$(solves batch/store.sqlite)" $((2 * (count / 2) + 2))
for ((i = 0; i < count; ++i)); do
  ended hello 60 check-solver --timeout 1 -- python3 mutating.py hello "$seed.$i" of-hello
done
for ((i = 0; i < count; ++i)); do
  mutants fine 0 "$(printf '[check]\nprocess = ["python3", "mutating.py", "checked", "%s.%s", "of-checked"]\nsmaller = ["lean"]\ntimeout_s = 2\n' "$seed" "$i")" >checked.toml
  ended checked 60 run checked.toml --no-report --out checked
done

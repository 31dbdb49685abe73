#!/usr/bin/env bash
# compare: its exit codes and numbers, of two stores and of two labels; and the command of action.yml.
source "$(dirname "$0")/common.sh"

# make FOLDER SETTINGS...: the paper's six on a short path; their errors grow where they have fewer iterations.
make() {
  succeeds run slim2023-50 --set runs=8 --set path.points=3 --set stop.iterations=40 --set population=10 "${@:2}" --no-report --out "$1"
}
make base
make again
make fewer --set stop.iterations=5
base=base/store.sqlite again=again/store.sqlite fewer=fewer/store.sqlite

# Two stores: nothing worse, and worse; the other way round nothing is.
cp $base before.sqlite
succeeds compare $base $again
has "$out" "IK-BA, BA, DE, PSO, K-ABC and MO-PSO: all 144 solves are identical, bit for bit."
succeeds compare $base $again --json
quiet
json 'of["exit_code"] == 0 and len(of["worse"]) == 6 and not any(of["worse"].values()) and of["files"] == []'
ends 3 compare $base $fewer --json
json 'all(row["metric"] in of["direction"] for row in of["comparisons"]) and of["metric"].keys() == of["worse"].keys()'
json '[label for label in of["worse"] if "position error" in of["worse"][label]] == ["DE", "PSO", "K-ABC", "MO-PSO"]'
golden compare-stores
ends 4 compare $base $fewer --label BA --strict
succeeds compare $base $fewer --label BA
cmp $base before.sqlite || fail "compare changed the store"
ends 3 compare $base $fewer --label BA --label K-ABC --strict -o verdict.md
equal "metrics of two labels in verdict.md" "$(grep -c '^| position error |' verdict.md)" 2

# Two labels of one store.
succeeds compare BA IK-BA --store $base --json
golden compare-labels
succeeds compare IK-BA BA --store $base --margin 10%  # the plan names the error alone
has "${out//$'\n'/ }" "Not counted (not in the plan): worse in joint motion."

# A pair has one p and one verdict, whichever command and option tells them.
cat >pairs.py <<'END'
import json, subprocess, sys
program, store = sys.argv[1:3]
def rows_of(*arguments):
    said = subprocess.run([program, *arguments, "--json"], capture_output=True, text=True).stdout
    rows = {}
    for row in json.loads(said)["comparisons"]:
        winner = {"better": row["first"], "worse": row["second"]}.get(row["verdict"], row["verdict"])
        rows[row["metric"], frozenset((row["first"], row["second"]))] = row["p"], row["n"], winner
    return rows
told = rows_of("report", store, "--figures", "none", "--out", "told")
labels = sorted({label for metric, pair in told for label in pair})
checked = 0
for one in labels:
    for other in labels:
        for options in [], ["--time-margin", "10%"], ["--metric", "solved"], ["--margin", "20%"]:
            if one == other:
                continue
            for key, row in rows_of("compare", one, other, "--store", store, *options).items():
                if key[0] == "answered":
                    continue
                compared = 2 if options and options[0].endswith("margin") else 3  # a margin changes what is the same
                assert told[key][:compared] == row[:compared], (one, other, options, key, told[key], row)
                checked += row[0] is not None
assert checked > 50, checked
END
succeeds run --robot ur5e --only "LM,DLS,Newton, restarts,SLSQP" --set path.points=60 --no-report --out several
python3 pairs.py "$program" several/store.sqlite || fail "report and compare tell another p of one pair"
# The plan's metrics decide, and --metric asks fewer of them.
run_it compare LM SLSQP --store several/store.sqlite --json
equal "exit code for more evaluations" $code 3
json 'of["worse"]["SLSQP"] == ["evaluations"] or of["worse"]["SLSQP"] == ["evaluations per success"]'
succeeds compare LM SLSQP --store several/store.sqlite --metric solved --json
json 'of["worse"]["SLSQP"] == [] and of["also_worse"]["SLSQP"] != []'
cp several/store.sqlite nobody.sqlite && sqlite3 nobody.sqlite 'DELETE FROM series'
refused "no solver to compare" compare nobody.sqlite several/store.sqlite
refused "names solved, time and evaluations" compare LM SLSQP --store several/store.sqlite --metric motion
refused "--time-margin 10%" compare LM SLSQP --store several/store.sqlite --metric time
refused "add time" compare LM SLSQP --store several/store.sqlite --metric solved --time-margin 10%

# Programs: three times the evaluations for the same answers are worse (crashes: regression.test.cpp).
cp "$scripts/studies/gate.toml" .
pso=$root/docs/examples/pso.py action=$(sed -n 's/^ *run: //p' "$root/action.yml" | tail -n 1)
for input in $(sed -n 's/^ *\([A-Z_]*\): \${{ inputs.*/\1/p' "$root/action.yml"); do
  grep -q "{$input:" "$root/cli/gate.sh" || fail "cli/gate.sh does not know $input of action.yml"
done
export IKBENCH=$program STUDY=gate.toml BASELINE=baseline.sqlite GITHUB_OUTPUT=outputs GITHUB_STEP_SUMMARY=summary.md

# gate CODE OUTCOME [NAME=VALUE]...
gate() {
  local code=0 expected=$1 outcome=$2
  shift 2
  env GITHUB_ACTION_PATH="$root" "$@" bash -c "$action" >.out 2>.err || code=$?
  equal "exit code of the gate ($*), which said $(<.out) $(<.err)" $code "$expected"
  equal "outcome ($*)" "$(tail -n 2 outputs | head -n 1)" "outcome=$outcome"
}
cp "$pso" mine.py
cp "$root/solvers/helpers/ikbench.py" .
gate 0 no-baseline
cp ikbench-gate/store.sqlite baseline.sqlite
gate 0 passed OUT=same STRICT=true
gate 0 passed BASELINE= OUT=required REQUIRE='solved=50%'
has "$(<summary.md)" "at least 50 %"
gate 4 inconclusive OUT=required REQUIRE=$'mine.solved=50%\nsolved=99.9%'
gate 1 failed OUT=required REQUIRE=time=5%
sed 's/^evaluations = .*/evaluations = 8/' gate.toml >few.toml
gate 3 unmet BASELINE= STUDY=few.toml OUT=few REQUIRE='solved=99%'
sed '/^\[stop\]/i [require]\nsolved = "99%"' few.toml >own.toml
gate 3 unmet BASELINE=nowhere.sqlite STUDY=own.toml OUT=own
sed '/^\[stop\]/i [require]\nsolved = "50%"' gate.toml >met.toml
gate 0 passed BASELINE= STUDY=met.toml OUT=met
has "$(<.out)" "at least 50 %"
[[ $(<.out) != *"Nothing was compared"* ]] || fail "a met requirement that counts for nothing: $(<.out)"
gate 0 no-baseline BASELINE= OUT=alone
for file in few own; do
  sed 's/^process = .*/process = ["python3", "dies.py"]/' $file.toml >$file-dead.toml
done
sed 's/^import ikbench$/import ikbench, os/; s/^    swarm = .*/    os._exit(1)/' "$pso" >dies.py
gate 3 failed BASELINE= STUDY=few-dead.toml OUT=few-dead REQUIRE='solved=99%'
gate 3 failed BASELINE=nowhere.sqlite STUDY=own-dead.toml OUT=own-dead
[ -s same/verdict.md ] && has "$(<summary.md)" "$(<same/verdict.md)" || fail "no verdict in the summary: $(<summary.md)"
refused 'alternating rounds' compare $base $again --time-margin 10%
code=0  # 3 where the machine was slower in one's rounds, 1 where it was busy
OUT=rounds OLD=$program ROUNDS=6 BASELINE='' bash "$root/cli/gate.sh" >.out 2>.err || code=$?
[[ $code == [03] ]] || [[ $code = 1 && $(<.out) == *'time (not comparable)'* ]] || fail "two programs in turn: exit code $code, and said $(<.out) $(<.err)"
equal "solves of the old program" "$(column rounds/before/store.sqlite evaluations mine)" "$(column rounds/store.sqlite evaluations mine)"
gate 1 failed OUT=rounds OLD="$program" ROUNDS=1000
sed 's/errors := problem.evaluate(swarm):/told := problem.evaluate(3 * swarm):\n        errors = told[:size]/' "$pso" >mine.py
gate 3 worse OUT=thrice MARGIN=10%
gate 0 passed OUT=thrice METRIC=solved
equal "evaluations" "$(column thrice/store.sqlite evaluations mine | awk '{ n += $1 } END { print n }')" \
  "$((3 * $(column baseline.sqlite evaluations mine | awk '{ n += $1 } END { print n }')))"
sed 's/^runs = 20/runs = 19/' gate.toml >shorter.toml
gate 1 failed STUDY=shorter.toml OUT=shorter
gate 1 failed STUDY=none.toml OUT=none GITHUB_ACTIONS=true
[[ $(head -n 1 .out) == ::stop-commands::???* && $(tail -n 1 .out) == "::$(head -n 1 .out | cut -d : -f 5)::" ]] ||
  fail "a label may command the forge: $(<.out)"
for input in TURNS=6 STRICT=yes STUDY= BASELINE=ikbench-gate/../ikbench-gate/store.sqlite; do gate 1 failed $input; done
ln -s nowhere dangling.sqlite
gate 1 failed BASELINE=dangling.sqlite OUT=-x
has "$(<.err)" dangling.sqlite
[ -s ./-x/store.sqlite ] || fail "no store in -x: $(<.err)"

#!/usr/bin/env bash
# cli/gate.sh, which action.yml runs: green on an equal solver, red on a worse one, and what it leaves behind.
source "$(dirname "$0")/common.sh"
gate=$scripts/../../cli/gate.sh
"$program" list studies slim2023 >my.toml
sed -i 's/^name = .*/name = "my"/; s/^published = .*/published = ""/; s/^runs = .*/runs = 8/; s/^points = .*/points = 3/;
  s/^population = .*/population = 20/; s/^iterations = .*/iterations = 30/' my.toml
export IKBENCH=$program STUDY=my.toml BASELINE=baseline.sqlite GITHUB_OUTPUT=outputs GITHUB_STEP_SUMMARY=summary.md

bash "$gate" >.out 2>.err || fail "no baseline: exit code $?: $(<.err)"
has "$(<.out)" "There is no baseline baseline.sqlite. Keep ikbench-gate/store.sqlite"
has "$(<outputs)" "outcome=no-baseline"
cp ikbench-gate/store.sqlite $BASELINE

rm -r ikbench-gate outputs
bash "$gate" >.out 2>.err || fail "the same solver: exit code $?: $(<.out) $(<.err)"
has "$(<outputs)" "outcome=passed"
has "$(<summary.md)" "No regression"

# The same solver in a second session is green with --strict and the metrics by default: times are shown and do not count.
# Who names them asks for what two sessions cannot decide.
OUT=second STRICT=true bash "$gate" >.out 2>.err || fail "the same solver, strict: exit code $?: $(<.out) $(<.err)"
"$program" compare $BASELINE second/store.sqlite --strict --json >strict.json || fail "compare --strict: exit code $?"
grep -q '"metric": "seconds' strict.json || fail "no row of times: $(<strict.json)"
code=0
OUT=times STRICT=true METRICS=seconds bash "$gate" >.out 2>.err || code=$?
[ "$code" = 4 ] || fail "times of two sessions, strict: exit code $code, expected 4: $(<.out) $(<.err)"

for file in store.sqlite verdict.md verdict.json; do
  [ -s ikbench-gate/$file ] || fail "no $file"
done

# Another seed is green, a third of the iterations red; both with the metrics by default, over two sessions, and --strict.
sed -i 's/^seed = .*/seed = 7/' my.toml
OUT=other-seed bash "$gate" >.out 2>.err || fail "another seed: exit code $?: $(<.out) $(<.err)"
sed -i 's/^iterations = .*/iterations = 10/' my.toml
code=0
OUT=worse STRICT=true METRICS="position_error_cm solved" bash "$gate" >.out 2>.err || code=$?
[ "$code" = 3 ] || fail "a worse solver: exit code $code, expected 3: $(<.out) $(<.err)"
has "$(<outputs)" "outcome=worse"
has "$(<summary.md)" "Regression beyond 5 %"
code=0
STUDY=none.toml OUT=none bash "$gate" >.out 2>.err || code=$?
[ "$code" = 1 ] || fail "no study: exit code $code, expected 1"
[ "$(tail -n 1 .err)" = "Nothing was compared: ikbench run failed with exit code 1." ] || fail "it does not say that nothing was compared: $(<.err)"
has "$(<outputs)" "outcome=failed"
code=0
echo "no store" >broken.sqlite
BASELINE=broken.sqlite OUT=broken bash "$gate" >.out 2>.err || code=$?
[ "$code" = 1 ] || fail "a broken baseline: exit code $code, expected 1"
has "$(<.err)" "Nothing was compared: ikbench compare failed with exit code 1."

# A program that crashes is red, and the screen says so above the table.
command -v python3 >/dev/null || exit 77
cat >mine.py <<'E2'
import json, os, sys
def say(**message): print(json.dumps(message), flush=True)
say(ikbench=1, message="hello", name="mine", version="1", modes=["solve"], deterministic=True, options=[])
for line in sys.stdin:
    told = json.loads(line)
    if told["message"] == "robot": say(message="ready")
    elif told["message"] == "ping": say(message="pong", id=told["id"])
    elif told["message"] == "solve":
        if "CRASH" in os.environ: os._exit(4)
        say(message="solved", id=told["id"], q=told["start"], error=None)
    elif told["message"] == "bye": break
E2
study crashing '[[solvers]]' 'label = "mine"' 'process = ["python3", "mine.py"]'
sed -i 's/^runs = 2/runs = 8/' crashing.toml
STUDY=crashing.toml BASELINE=none.sqlite OUT=alive bash "$gate" >.out 2>.err || fail "no baseline: $(<.out) $(<.err)"
code=0
CRASH=1 STUDY=crashing.toml BASELINE=alive/store.sqlite OUT=dead bash "$gate" >.out 2>.err || code=$?
[ "$code" = 3 ] || fail "a program that crashes: exit code $code, expected 3: $(<.out) $(<.err)"
[[ $(flat "$(<.out)") == "Regression "*"mine: Solves without an answer: none of A's 64; 64 of B's 64 (crashed 64)."*"label "* ]] ||
  fail "it does not say that it crashed: $(<.out)"
[ "$(cat .out .err | wc -l)" -le 30 ] && [ "$(cat .out .err | wc -L)" -le 100 ] || fail "the gate: not one screen: $(<.out) $(<.err)"

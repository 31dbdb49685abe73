#!/usr/bin/env bash
# check-solver passes a good program, and finds each fault that is planted in it by its own check, and by no other.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

cp "$scripts/programs/planted.py" .

# A fault, and words of each check that fails with it. A budget of 50 ms says nothing on a busy machine, except with the
# fault "late". They mostly wait, so four at a time; only who hangs is given up soon.
cp "$scripts/programs/planted.faults" table
cut -d'|' -f1 table | xargs -P 4 -I{} env FAULT={} bash -c '[ $FAULT = hangs ] && timeout=20 || timeout=60
  "$0" check-solver --timeout $timeout -- python3 planted.py >$FAULT.said 2>$FAULT.err; echo $? >$FAULT.code' "$program"
python3 "$scripts/programs/failed.py" <table || fail "see above: $(cat ./*.err)"
has "$(<good.said)" "All 12 checks passed"
[[ $(<good.said) =~ some\ of\ the\ [0-9]+\ poses\ that\ LM\ solves:\ [0-9]+\ within ]] || fail "counted twice: $(<good.said)"
has "$(<lies.said)" "2 of 12 checks failed"
has "$(<null.said)" 'expected "q"'

# A NUL does not end what is said of a line.
"$program" check-solver printf '{"message":"hello\0"}\n' >.out 2>&1
equal "code at a NUL" $? 1
has "$(<.out)" "; expected a JSON object"

# Who asks for one candidate at a time may spend all evaluations.
cat >asked.py <<'END'
import json, sys
print(json.dumps({"message": "hello", "ikbench": 2, "name": "asked", "version": "1"}), flush=True)
for line in sys.stdin:
    if (asked := json.loads(line))["message"] == "solve":
        json.dump(asked["budget"], open("budget.json", "w"))
        sys.exit()
END
ends 1 check-solver -- python3 asked.py
json 'of["iterations"] >= of["evaluations"] > 0' budget.json

# A value that is not finite is told with its joint.
cp "$root/solvers/helpers/ikbench.py" .
echo 'import ikbench; ikbench.run("nan", lambda robot: None, lambda _, problem: problem.start[:2] + [float("nan")] + problem.start[3:])' >nan.py
ends 1 check-solver -- python3 nan.py
has "$(xargs <.out)" "joint 3 is nan"

#!/usr/bin/env bash
# check-solver passes a good program, and finds each of the faults that are planted in it, one at a time: by its own check,
# and by no other.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

cp "$scripts/programs/planted.py" .

# A fault, and words of each check that fails with it. A budget of 1 ms says nothing on a busy machine, except with the
# fault "late".
while IFS='|' read -r fault checks; do
  export FAULT=$fault
  run_it check-solver --json --patience 10 -- python3 planted.py
  python3 "$scripts/programs/failed.py" "$fault" "$checks" .out || fail "$fault, exit code $code: $(<.out)"
  [ -z "$checks" ] || equal "exit code with $fault" "$code" 1
done <<'END'
good|
one-seed|
silent|hello
option|hello
long|64 joints
outside|inside the joint limits
remembers|same process
of-process|fresh process
endless|turn without end
lies|declines; claims
hangs|nothing reaches
empty-budget|0 iterations
late|1 ms
nan|finite
slides|slides
pretends|deterministic
id|declines; declines; declines
deaf|bye
stays|standard input
noise|nothing but messages
END
FAULT=good succeeds check-solver -- python3 planted.py
equal checks "$(FAULT=good "$program" check-solver --json -- python3 planted.py | grep -c '"check"')" 19

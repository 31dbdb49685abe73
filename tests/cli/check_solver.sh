#!/usr/bin/env bash
# check-solver passes a good program, and finds each of the faults that are planted in it, one at a time: by its own check,
# and by no other.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

cp "$scripts/programs/planted.py" .

# A fault, and words of each check that fails with it. A budget of 50 ms says nothing on a busy machine, except with the
# fault "late".
while IFS='|' read -r fault checks; do
  export FAULT=$fault
  run_it check-solver --json --patience 3 -- python3 planted.py
  python3 "$scripts/programs/failed.py" "$fault" "$checks" .out || fail "$fault, exit code $code: $(<.out)"
  [ -z "$checks" ] || equal "exit code with $fault" "$code" 1
done <<'END'
good|
silent|hello
option|hello
outside|inside the limits
remembers|same seed
of-process|same seed
endless|without end
lies|position; without end
hangs|50 ms
late|50 ms
nan|position
null|position
again|position
twice|answers once
pose|pose
slides|slides
stays|standard input
END
FAULT=good succeeds check-solver -- python3 planted.py
has "$(head -n 1 .out)" "All 8 checks passed"
equal checks "$(FAULT=good "$program" check-solver --json -- python3 planted.py | grep -c '"check"')" 8
FAULT=lies run_it check-solver -- python3 planted.py
has "$(head -n 1 .out)" "2 of 8 checks failed"
FAULT=null run_it check-solver -- python3 planted.py
has "$out" 'expected "q"'

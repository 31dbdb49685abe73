#!/usr/bin/env bash
# A warm study: a program gets one message a target, solves twice in its process, and the second solve counts.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
cp "$scripts"/programs/faulty.py "$root"/solvers/helpers/ikbench{.py,_program.hpp} "$root"/solvers/programs/nothing.cpp .
cat >twice.py <<'PY'
import json, random, sys, time
import ikbench
mode, last, calls = sys.argv[1], None, 0

def solve(_, problem):
    global last, calls
    calls += 1
    with open(mode + ".calls", "a") as file: print(problem.seed, file=file)
    draw = random if mode == "global" else problem.random
    begins_at_last = last and (mode == "remembers" or mode == "knows" and hasattr(problem, "state"))
    q = [x + draw.uniform(-0.1, 0.1) for x in (last if begins_at_last else problem.start)]
    problem.start[0] = 9  # what it does to a problem is forgotten
    problem.extras["calls"] = calls
    if mode == "sleeps": time.sleep(1.1)
    if mode == "asks" and problem.evaluate([q]) is None: return None
    last = q
    return q

ikbench.run(mode, lambda robot: robot, solve)
PY
cat >claims.py <<'PY'
import json, sys
mode = sys.argv[1]
print(json.dumps({"message": "hello", "ikbench": 2, "name": mode}), flush=True)
for line in sys.stdin:
    told = json.loads(line)
    if told["message"] != "solve": continue
    if mode == "evaluates":
        print(json.dumps({"message": "evaluate", "candidates": [told["start"]]}), flush=True)
        sys.stdin.readline()
    print(json.dumps({"message": "solved", "q": told["start"], "timed": "second",
                      "seconds": 1e6 if mode == "years" else 1e-9}), flush=True)
PY
program_entry() { printf '[[solvers]]\nlabel = "%s"\nprocess = [%s]\ntimeout_s = %s\n' "$1" "$2" "${3:-60}"; }
warm() { # NAME ENTRY...
  study "$@"
  sed -i '1i start = "middle"\nstate = "warm"' "$1.toml"
}
twice() { program_entry "$1" "\"python3\", \"twice.py\", \"$1\"" "${2:-60}"; }
claims() { program_entry "$1" "\"python3\", \"claims.py\", \"$1\""; }
timing() { [[ $(column "$1/store.sqlite" timing "$2" | counted) =~ ^16\ ($3|debug_build)$ ]] || fail "timing of $2: $(column "$1/store.sqlite" timing "$2" | counted)"; }

warm both "$(twice fine)" "$(twice global)" "$(twice remembers)" "$(twice asks)" "$(entry old fine)"
succeeds run both.toml --figures none --out both
grep -q "gave another answer" .err && cp .err told
for label in fine global remembers; do timing both $label process_warm; done
for label in asks old; do timing both $label process; done
equal "solves" "$(solves both/store.sqlite)" 96
# Both solves have one seed, also those that are not recorded; who asks for evaluations solves once.
for label in fine global remembers; do equal "calls of $label" "$(uniq -c $label.calls | awk '$1 % 2' | wc -l)" 0; done
equal "calls of asks" "$(uniq -c asks.calls | awk '$1 > 2' | wc -l)" 0
equal "evaluations of asks" "$(column both/store.sqlite evaluations asks | grep . | sort -u)" 1
equal "numbers of the first solve" "$(column both/store.sqlite extra_calls fine | awk '$1 % 2' | wc -l)" 0
for label in global remembers; do
  grep -q "$label: .*its second solve of a target gave another answer than the first in 16 of 16 targets" <(tr -s '\n ' ' ' <told) ||
    fail "not told of $label: $(<told)"
done
has_no "$(<told)" "fine: "
if ! grep -q "debug build" both/report.md; then # whose times are not told apart
  has "$(<both/report.md)" "those of asks and old through a pipe, which are not warm"
fi
succeeds verify both/store.sqlite

# The answers are those of a study of first calls, where nothing says that it solved twice.
succeeds run both.toml --no-report --set state=first --set name=first --out first
for label in DLS fine asks old; do
  equal "answers of $label" "$(column both/store.sqlite answer_rad_1 $label)" "$(column first/store.sqlite answer_rad_1 $label)"
done
timing first fine process
warm claims "$(claims honest)" "$(claims years)" "$(claims evaluates)"
succeeds run claims.toml --no-report --out claims
is claims honest "$any"
for label in years evaluates; do is claims $label "16 protocol_error"; done
succeeds run claims.toml --no-report --set state=first --out claims-first
is claims-first honest "16 protocol_error"
has "$(tr -s '\n ' ' ' <.err)" "as one solve was asked for"

# The timeout is doubled, and the stored wall time is that of one solve: both take 2.2 s at least, and 4 s at most.
warm sleeps "$(twice sleeps 2)"
succeeds run sleeps.toml --no-report --set runs=1 --set path.points=1 --out sleeps
equal "solves that timed out" "$(column sleeps/store.sqlite status sleeps | grep -c timed_out)" 0
equal "wall time of one solve" "$(column sleeps/store.sqlite wall_seconds sleeps | awk '1.1 <= $1 && $1 < 2.1' | wc -l)" 1

ends 1 check-solver -- python3 twice.py fine # which does not search
has "$(xargs <.out)" "ok it gives the same answer in a warm study: it solves twice, and times the second solve"
ends 1 check-solver -- python3 twice.py asks
has "$(xargs <.out)" "ok it gives the same answer in a warm study: it solves once, so its time counts as one through a pipe"
ends 1 check-solver -- python3 twice.py knows # that it is asked as in a warm study
has "$(xargs <.out)" "it gives another answer when it solves twice in a row"
if can c++; then
  c++ -std=c++17 -O2 -Wall -Wextra -Werror -o nothing nothing.cpp || fail "nothing.cpp"
  warm cpp "$(program_entry nothing '"./nothing"')"
  sed -i 's/^search = .*/search = "pose"/' cpp.toml
  succeeds run cpp.toml --no-report --out cpp
  timing cpp nothing process_warm
fi

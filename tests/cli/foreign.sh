#!/usr/bin/env bash
# Programs as solvers: each fault is a row that says what it is, and changes nothing of the others'.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
examples=$root/docs/examples
cp "$scripts"/programs/*.py .

# entry LABEL FAULT [FURTHER KEYS]
entry() { printf '[[solvers]]\nlabel = "%s"\nprocess = ["python3", "faulty.py", "%s"]\npatience_s = 1\n%s\n' "$1" "$2" "${3:-}"; }
# runs NAME ENTRY...: a study of damped least squares and these entries, run into a folder of its name.
runs() {
  study "$@"
  succeeds run "$1.toml" --no-report --out "$1"
  equal "numbers of another solver beside $1" "$(column "$1/store.sqlite" position_error_cm DLS)" "$alone"
}
# is STUDY LABEL STATUS...: the statuses of its 16 solves, with their counts.
is() {
  local found
  found=$(column "$1/store.sqlite" status "$2" | counted | paste -sd' ')
  [[ $found =~ ^${*:3}$ ]] || fail "$2 in $1: $found, expected ${*:3}"
}
any='([0-9]+ (ok|tolerance_missed|limit_violated) ?)+' # no fault

study plain
succeeds run plain.toml --no-report --out plain
alone=$(column plain/store.sqlite position_error_cm DLS)

# Each fault is a status of its own solves, and changes nothing of the others'.
runs faults "$(entry good fine)" "$(entry hangs hangs)" "$(entry dies dies)" "$(entry noise noise)" "$(entry lies lies)" \
  "$(entry nonsense nonsense)" "$(entry declines declines)" "$(entry deep deep)" "$(entry early early)"
has "$err" "no more" # the last words of what died
store=faults/store.sqlite
is faults good "$any"
is faults noise "$any"
is faults hangs ".*1 timed_out"
is faults dies "1 crashed $any"
is faults lies "16 claimed_but_wrong"
is faults nonsense ".*[0-9]+ broke_protocol.*"
is faults deep ".*[0-9]+ broke_protocol.*"
is faults early "16 broke_protocol"
is faults declines "16 declined"
equal "errors beside noise" "$(column $store position_error_cm noise)" "$(column $store position_error_cm good)"
equal "counted by" "$(column $store counted_by good | counted)" "16 nobody"
equal "evaluations that nobody counted" "$(column $store evaluations good | tr -d '\n')" ""
[[ $(column $store timing good | counted) =~ ^16\ (process|debug_build)$ ]] || fail "$(column $store timing good | counted)"
equal "moves of solves without an answer" "$(sqlite3 $store "SELECT count(*) FROM solves WHERE
  status IN ('crashed', 'timed_out', 'broke_protocol', 'declined') AND start_rad <> answer_rad")" 0
succeeds run faults.toml --no-figures --out faults --json
equal "solves of a second run" "$(solves $store)" 160
json 'any("lies" in doubt and "16 of 16" in doubt for doubt in of["doubts"])'
ends 3 compare good declines --store $store --json
json '"solves with an answer" in of["solvers"][0]["worse"]'

# Ends: a program that dies at each end; one that is edited while it runs; one that is stuck, in a group of its own.
sed 's/if errors is None:/if errors is None: sys.exit("dead at over")\n        if errors is None:/' "$examples/pso.py" >over.py
sed '/solves += 1/a\        if solves == 6: open(__file__, "a").write("#"); os._exit(3)' faulty.py >changing.py
for name in over changing stuck; do
  runs $name "$(printf '[[solvers]]\nlabel = "%s"\nprocess = ["python3", "%s.py"]\npatience_s = 0.5\n' $name $name)"
done
is over over "16 crashed"
is changing changing "1[3-6] crashed.*"
is stuck stuck "16 timed_out"
! pgrep -f "python3 stuck.py" >/dev/null || fail "a stuck program is left"
ends 1 check-solver --patience 1 -- python3 over.py

# Budgets: one question may have more candidates than there are evaluations; who overruns a budget has not solved.
sed 's/size, joints = problem\["population"\]/size, joints = 5000/' "$examples/pso.py" >many.py
study many '[[solvers]]' 'label = "many"' 'process = ["python3", "many.py"]'
succeeds run many.toml --set stop.evaluations=100 --no-report --out many
equal evaluations "$(column many/store.sqlite evaluations many | counted)" "16 100"
study budgets "$(entry late late)" "$(entry boasts boasts)" "$(entry spends spends)"
sed -i 's/^iterations = 8$/iterations = 8\nseconds = 0.3\nevaluations = 100\ntolerance_cm = 1000/; s/^runs = 2/runs = 12/; s/^points = 8/points = 2/' budgets.toml
succeeds run budgets.toml --no-figures --out budgets --json
for label in late spends; do is budgets $label "([0-9] limit_violated )?[12][0-9] over_budget"; done
! column budgets/store.sqlite status boasts | grep -q over_budget || fail "who claims one evaluation is over budget"
json '[row["mean"] for row in of["groups"] if row["metric"] == "solved" and row["solver"] == "late"] == [0]'
json 'all(row["p"] is None for row in of["findings"] if row["metric"] == "evaluations" and {row["first"], row["second"]} & {"boasts", "spends"})'

# An edited program is another one, and so is one whose further files changed. Two at once give the same answers.
runs edited "$(entry mine fine)"
succeeds run edited.toml --no-report --out parallel --jobs 2
equal "answers of two at once" "$(column parallel/store.sqlite position_error_cm mine)" "$(column edited/store.sqlite position_error_cm mine)"
sed -i 's/step \*= 0.8/step *= 0.7/' faulty.py
succeeds run edited.toml --no-report --out edited
equal "solves of the edited program" "$(sqlite3 edited/store.sqlite "SELECT count(*) FROM solves WHERE solver = 'mine'")" 32
echo "package missing" >packages.txt
needy=$(entry needy fine 'files = ["packages.txt"]' | sed 's/faulty.py/needy.py/')
runs needy "$needy"
is needy needy "16 crashed"
touch package
echo "package 1.0" >packages.txt
runs needy "$needy"
is needy needy "$any"

# If the system cannot start it any more, that is no result: the run ends, and continues when it can.
{ echo '#!/usr/bin/env python3'; sed '/solves += 1/a\        if solves == 6 and not os.path.exists("righted"): open("righted", "w"); os.chmod(__file__, 0o644); os._exit(3)' faulty.py; } >rights.py
chmod +x rights.py
study rights '[[solvers]]' 'label = "rights"' 'process = ["./rights.py"]'
ends 2 run rights.toml --no-report --out rights
refused rights.py run rights.toml --no-report --out rights
chmod +x rights.py
succeeds run rights.toml --no-report --out rights
is rights rights "1 crashed $any"

# A user's mistakes.
mistake() {
  study mistake "$2"
  refused "$1" run mistake.toml
}
command_is() { printf '[[solvers]]\nprocess = [%s]\n%s' "$1" "${2:-}"; }
mistake "option w" "$(entry mine fine 'options = { w = 2 }')"
mistake '"ask"' "$(entry mine fine 'mode = "ask"')"
mistake missing.py "$(entry mine fine 'files = ["missing.py"]')"
mistake no_such_program "$(command_is '"no_such_program"')"
mistake "exit code 1" "$(command_is '"false"')"
mistake patience_s "$(command_is '"sleep", "1000"' 'patience_s = 0.5')"
mistake million "$(command_is '"cat", "/dev/zero"')"
sed 's/"name": "w"/"name": "mode"/' faulty.py >clash.py
mistake "option mode" "$(command_is '"python3", "clash.py"')"

# Any end of ikbench ends its programs, and what these have started in their own session.
printf 'setsid sleep 31415.$PPID </dev/null >/dev/null 2>&1 &\nexec python3 faulty.py "$@"\n' >leaver.sh
left() { pgrep -f "faulty.py until-$1|^sleep 31415.$process" | wc -l; }
for signal in INT KILL; do
  sed -e 's/runs = 2/runs = 2000/' -e "s/fine/until-$signal/" -e 's/"python3", "faulty.py"/"sh", "leaver.sh"/' \
    -e 's/patience_s = 1/patience_s = 20/' edited.toml >long.toml
  "$program" run long.toml --no-report --out long-$signal >/dev/null 2>&1 &
  process=$!
  for ((i = 0; i < 200; ++i)); do
    [ "$(solves long-$signal/store.sqlite 2>/dev/null)" -ge 1 ] && break # not the process that only says hello
    sleep 0.1
  done
  [ "$(left $signal)" -ge 2 ] || fail "the program did not start, or started nothing"
  kill -$signal $process
  wait $process 2>/dev/null
  for ((i = 0; i < 50; ++i)); do
    [ "$(left $signal)" = 0 ] && break
    sleep 0.1
  done
  equal "processes after SIG$signal" "$(left $signal)" 0
done

# The examples of docs/solvers-in-any-language.md, below 70 lines each, find solutions that are near; those whose
# interpreter or compiler is not here are left out.
cp "$examples"/* .
entries=()
add() { entries+=("$(printf '[[solvers]]\nlabel = "%s"\nprocess = [%s]\n' "$1" "$2")"); }
for file in "$examples"/*; do [ "$(wc -l <"$file")" -lt 70 ] || fail "$file has 70 lines or more"; done
add pso.py '"python3", "pso.py"'
! python3 -c "import scipy" 2>/dev/null || add least_squares.py '"python3", "least_squares.py"'
! command -v octave-cli >/dev/null || add damped.m '"octave-cli", "--quiet", "damped.m"'
! cc -O2 -Wall -Wextra -Werror -o search search.c 2>cc.err || add search.c '"./search"'
! c++ -std=c++17 -O1 -I/usr/include/eigen3 -o descent descent.cpp 2>cc.err || add descent.cpp '"./descent"'
study examples "${entries[@]}"
sed -i 's/^repeats = 1/&\nrobot = "ur5e"\nstart = "near"\nnear_deg = 10/; s/points = 8/points = 3/; s/^iterations = 8/iterations = 60\ntolerance_cm = 0.5/' examples.toml
succeeds run examples.toml --no-report --out examples
echo "examples: $(column examples/store.sqlite status pso.py | wc -l) solves each of ${#entries[@]}"
for label in $(sed -n 's/^label = "\(.*\..*\)"/\1/p' examples.toml); do
  [[ $label == pso.py || $label == search.c ]] && least=1 || least=4 # which try at random
  [ "$(column examples/store.sqlite status "$label" | grep -cx ok)" -ge $least ] || fail "$label: $(column examples/store.sqlite status "$label" | counted)"
done

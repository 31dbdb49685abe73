#!/usr/bin/env bash
# Programs as solvers: each fault is a row that says what it is, and changes nothing of the others'.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
examples=$root/docs/examples
cp "$scripts"/programs/*.py "$scripts"/programs/printed/* .

# runs NAME ENTRY...: a study of damped least squares and these entries, run into a folder of its name.
runs() {
  study "$@"
  succeeds run "$1.toml" --no-report --out "$1"
  equal "numbers of another solver beside $1" "$(column "$1/store.sqlite" position_error_cm DLS)" "$alone"
}

study plain
succeeds run plain.toml --no-report --out plain
alone=$(column plain/store.sqlite position_error_cm DLS)



# Each fault is a status of its own solves, and changes nothing of the others'.
runs faults "$(entry good fine)" "$(entry hangs hangs "" 2)" "$(entry dies dies)" "$(entry noise noise)" "$(entry lies lies)" \
  "$(entry nonsense nonsense)" "$(entry declines declines)" "$(entry deep deep)" "$(entry json "not JSON")" "$(entry twice twice)" \
  "$(entry eats eats "memory_mb = 400")" "$(entry names "new names")" "$(entry null "no extras")" \
  "$(entry years "takes years")" "$(entry again "late twice")" "$(entry warms "warms badly")" \
  "$(entry stops "stops its parent" "" 2)" "$(entry on "stops it and answers")"
has "$err" "no more"                          # the last words of what died
has "$err" '"q", a list of 7 numbers'         # what was expected of what made no sense
has "$err" "null for numbers that are not finite"
has "$(tr -s '\n ' ' ' <.err)" 'at most 50 names of "extras" in all'
has "$err" "its last output: MemoryError"
has "$err" '"seconds" from 0 to '
has "$err" "this answers another solve"
store=faults/store.sqlite
for label in good noise null on; do is faults $label "$any"; done
for label in hangs stops; do is faults $label ".*1 timed_out"; done
is faults dies "1 crashed $any"
is faults eats "[12] crashed $any"
is faults lies "16 misreported"
is faults warms "$any"
for label in nonsense deep json twice again names; do is faults $label ".*[0-9]+ protocol_error.*"; done
is faults declines "16 declined"
is faults years "16 protocol_error"
equal "errors beside noise" "$(column $store position_error_cm noise)" "$(column $store position_error_cm good)"
equal "counted by" "$(column $store counted_by good | counted)" "16 none"
equal "evaluations that nobody counted" "$(column $store evaluations good | tr -d '\n')" ""
[[ $(column $store timing good | counted) =~ ^16\ (process|debug_build)$ ]] || fail "$(column $store timing good | counted)"
equal "moves of solves without an answer" "$(sqlite3 $store "SELECT count(*) FROM solves WHERE
  status IN ('crashed', 'timed_out', 'protocol_error', 'declined') AND start_rad <> answer_rad")" 0
ends 3 run faults.toml --figures none --out faults --json # since some answer in no solve
[[ $err == *"years gave no answer in any solve"* ]] || fail "not told: $err"
equal "solves of a second run" "$(solves $store)" 304
json 'any("lies" in warning and "wrong error" in warning for warning in of["warnings"])'
ends 3 compare good declines --store $store --json
json 'of["new_failures"]["declines"] > 0'

study silent "$(entry dies dies)" "$(entry declines declines)"
succeeds run silent.toml --figures none --out silent
study silent "$(entry years "takes years")"
ends 3 run silent.toml --figures none --out silent
equal "first line" "$(head -n 1 .out)" "years gave no answer in any solve (crash, timeout or protocol error)."
[ "$(tail -n 1 .out)" = "Report: silent/report.html" ] && [ -s silent/report.html ] || fail "no report: $out"

# Ends: one that is edited while it runs is another; one that is stuck, in a group of its own, is ended.
sed '/solves += 1/a\        if solves == 6: open(__file__, "a").write("#"); os._exit(3)' faulty.py >changing.py
sed '/solves += 1/a\        os._exit(3)' faulty.py >falls.py
study falls '[[solvers]]' 'label = "falls"' 'process = ["python3", "falls.py"]'
succeeds run falls.toml --no-report --out falls
equal "solves without a time, after the third" "$(column falls/store.sqlite seconds falls | grep -c NaN)" 13
study changing '[[solvers]]' 'label = "changing"' 'process = ["python3", "changing.py"]'
ends 2 run changing.toml --no-report --out changing
has "$err" "changed while it ran"
runs stuck "$(printf '[[solvers]]\nlabel = "stuck"\nprocess = ["python3", "stuck.py", "of-%s"]\ntimeout_s = 0.1\n' $$)"
is stuck stuck "16 timed_out"
equal "stuck programs left" "$(pgrep -f "stuck.py of-$$\$" | wc -l)" 0

# Nor does one that stopped its parent keep a run that is told to end.
rm "stops its parent once"
study parent "$(entry stops "stops its parent" "" 2)"
"$program" run parent.toml --no-report --out parent >/dev/null 2>&1 &
process=$!
until [ -e "stops its parent once" ]; do
  kill -0 $process || fail "it ended before it was told to"
  sleep 0.02
done
kill -TERM $process
wait $process
equal "exit code of a run that is told to end" $? 143

# Who asks counts here. Who asks too little to have found its answer, or answers another one, has kinematics of its own.
cp "$root/solvers/helpers/ikbench.py" .
sed 's/size, joints = problem.population/size, joints = 1000/' "$examples/pso.py" >many.py
study many '[[solvers]]' 'label = "many"' 'process = ["python3", "many.py"]' \
  "$(entry once "asks once")" "$(entry first "asks at first")"
succeeds run many.toml --set stop.evaluations=100 --no-report --out many
equal evaluations "$(column many/store.sqlite evaluations many | counted)" "16 100"
for who in "many ikbench" "once none" "first none"; do
  [[ $(column many/store.sqlite counted_by ${who% *} | counted) =~ ^1[0-9]\ ${who#* } ]] || fail "not counted by: $who"
done

# Who asks for one candidate at a time has all evaluations, as others have.
sed 's/size, joints = problem.population/size, joints = 1/' "$examples/pso.py" >one.py
study one '[[solvers]]' 'process = ["python3", "one.py"]' 'label = "one"' '[[solvers]]' 'solver = "particle_swarm"' 'label = "PSO"'
sed -i '/^iterations/d' one.toml
succeeds run one.toml --set stop.evaluations=300 --figures none --out one
for label in one PSO; do equal evaluations "$(column one/store.sqlite evaluations $label | counted)" "16 300"; done
has_no "$out" "budgets differ"

# Budgets: who overruns one has not solved, and its arm stays. On a busy machine others than late would overrun one of time.
study late "$(entry late late)"
succeeds run late.toml --set stop.seconds=0.05 --set stop.tolerance_cm=1000 --figures none --out late --json
json '[row["mean"] for row in of["groups"] if row["metric"] == "targets solved" and row["solver"] == "late"] == [0]'
[ ! -e late/tables/extras.csv ] || fail "a refused answer is a metric"
study budgets "$(entry boasts boasts)" "$(entry spends spends)" "$(entry on "asks on")"
more=(--set stop.evaluations=100 --set stop.tolerance_cm=1000 --set runs=12 --set path.points=2)
succeeds run budgets.toml "${more[@]}" --figures none --out budgets --json
json 'all(row["p"] is None for row in of["comparisons"] if row["metric"] == "evaluations" and {row["first"], row["second"]} & {"boasts", "spends"})'
! column budgets/store.sqlite status boasts | grep -q over_budget || fail "who claims one evaluation is over budget"
for who in "late late" "budgets spends" "budgets on"; do
  is $who "([0-9] limit_violated )?[12][0-9] over_budget"
  equal "moves over budget; its answers are kept" "$(sqlite3 "${who% *}/store.sqlite" "SELECT sum(start_rad <> answer_rad),
    count(*) = (SELECT count(*) FROM extras WHERE name = 'refused_1') FROM solves WHERE status = 'over_budget'")" "0|1"
done

# A program that has its arm from the text is judged on that arm, though its file has rounded angles, soft limits and a finger;
# a check gets that file.
succeeds run printed.toml --no-report --out printed
equal "status by the text" "$(column printed/store.sqlite status "by text" | counted)" "10 ok"

# An edited program is another one, and so is one whose further files changed.
runs edited "$(entry mine fine)"
sed -i 's/step \*= 0.8/step *= 0.7/' faulty.py
succeeds run edited.toml --no-report --out edited
equal "solves of the edited program" "$(sqlite3 edited/store.sqlite "SELECT count(*) FROM solves WHERE label = 'mine'")" 32
echo "package missing" >packages.txt
needy=$(entry needy fine 'files = ["packages.txt"]' | sed 's/faulty.py/needy.py/')
runs needy "$needy"
is needy needy "16 crashed"
touch package && echo "package 1.0" >packages.txt
runs needy "$needy"
is needy needy "$any"

# A user's mistakes: what is said, the program, and the change of faulty.py that makes it.
while IFS='|' read -r said command change; do
  sed "$change" faulty.py >changed.py
  study mistake [[solvers]] "process = [$command]"
  refused "$said" run mistake.toml
done <<'TABLE'
no_such_program|"no_such_program"|
exit code 1|"false"|
expected a program|""|
it closed its standard output|"sh", "-c", "exec >&-; exec sleep 9"|
million|"cat", "/dev/zero"|
is not a key|"python3", "changed.py"|s/"name": "w"/"name": "label"/
solves for axis, pose|"python3", "changed.py"|s/ikbench=2/ikbench=2, goals=["axis", "pose"]/
"goals" of position|"python3", "changed.py"|s/ikbench=2/ikbench=2, goals=["poses"]/
"ikbench":2|"python3", "changed.py"|s/ikbench=2/ikbench=1/
TABLE
for wrong in "option w|options = { w = 2 }" 'missing.py|files = ["missing.py"]' "expected another start|batch = 5" "from 0 to 1000|batch = 1001"; do
  study mistake "$(entry mine fine "${wrong#*|}")"
  refused "${wrong%|*}" run mistake.toml
done

# Some solves are asked twice, and it is told who answers otherwise then.
study forgets "$(entry good fine)" "$(printf '[[solvers]]\nlabel = "other"\nprocess = ["env", "FAULT=remembers", "python3", "planted.py"]\n
[[solvers]]\nlabel = "gone"\nprocess = ["env", "FAULT=dies-again", "python3", "planted.py"]\n')"
succeeds run forgets.toml --no-report --out forgets
has "$err" "other: it gave other answers to the same question in 1 of 1 repeats"
has_no "$err" "good: it answers"
has "$err" "gone: last failure: crashed"
has_no "$err" "gone: it answers"

# Of several answers the nearest one inside the limits counts. All are stored, and a program's own numbers are kept.
study several "$(entry several several)" "$(entry text "a text")"
succeeds run several.toml --figures none --out several
is several several "16 ok"
equal "moves of the nearest answer" "$(column several/store.sqlite variation_deg several | counted)" "16 0"
is several text ".*[0-9]+ protocol_error.*"
equal "extras" "$(sqlite3 several/store.sqlite "SELECT name, count(*), min(value), max(value) FROM extras GROUP BY name" | paste -sd' ')" \
  "nothing|16|| restarts|16|3.0|3.0"
equal "all answers" "$(sqlite3 several/store.sqlite "SELECT json_array_length(all_answers_rad) / json_array_length(answer_rad)
  FROM current_solves WHERE label = 'several'" | counted)" "16 4"
equal "extras as CSV" "$(column several/store.sqlite extra_restarts several | counted)" "16 3"
equal "extras of a report" "$(<several/tables/extras.csv)" $'solver,restarts\nseveral,3.0'
succeeds export several/store.sqlite --format answers -o answers.csv
equal "rows of all answers" "$(grep -c ',several,' answers.csv)" 64

# A program that does not start may be left out.
study missing "$(entry there fine)" '[[solvers]]' 'label = "gone"' 'process = ["false"]' 'if_missing = "skip"'
succeeds run missing.toml --no-report --out missing
has "$err" "gone"
equal "solvers" "$(sqlite3 missing/store.sqlite "SELECT group_concat(label) FROM series")" "DLS,there"

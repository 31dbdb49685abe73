# Programs as solvers: each fault is a row that says what it is, and changes nothing of the others'.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
command -v python3 >/dev/null || { echo "SKIPPED: no python3"; exit 77; }
examples=$scripts/../../docs/examples

# A solver with own kinematics: of one joint after the other. $FAULT and the number of the solve decide what it does.
cat >faulty.py <<'EOF'
import json, math, os, sys, time

FAULT = sys.argv[1] if len(sys.argv) > 1 else ""

def say(**message):
    print(json.dumps(message), flush=True)

def matrix(joint, q):
    t, ca, sa = joint["theta"] + q, math.cos(joint["alpha"]), math.sin(joint["alpha"])
    c, s = math.cos(t), math.sin(t)
    return [[c, -s * ca, s * sa, joint["a"] * c], [s, c * ca, -c * sa, joint["a"] * s], [0, sa, ca, joint["d"]],
            [0, 0, 0, 1]]

def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]

def tool(q):
    square = lambda m: [m[0:4], m[4:8], m[8:12], m[12:16]]
    pose = square(robot["base"])
    for joint, x in zip(robot["joints"], q):
        pose = times(pose, matrix(joint, x))
    pose = times(pose, square(robot["tool"]))
    return [pose[i][3] for i in range(3)]

def solve(problem):
    q, target = list(problem["start"]), problem["target"]["position"]
    error, step = math.dist(tool(q), target), 0.3
    for i in range(problem["budget"]["iterations"]):
        for j in range(len(q)):
            for way in (step, -step):
                other = list(q)
                other[j] += way
                if math.dist(tool(other), target) < error:
                    q, error = other, math.dist(tool(other), target)
        step *= 0.8
    if FAULT == "late": time.sleep(0.6)
    counted = {"boasts": {"evaluations": 1}, "spends": {"evaluations": 1000}}.get(FAULT, {})
    say(message="solved", id=problem["id"], q=q, error=error + (0.01 if FAULT == "lies" else 0), **counted)

say(ikbench=1, message="hello", name="faulty", version="1", modes=["solve"], deterministic=True, options=[
    {"name": "w", "type": "number", "default": 0.5, "low": 0, "high": 1, "meaning": "nothing"}])
solves = 0
for line in sys.stdin:
    told = json.loads(line)
    if told["message"] == "robot":
        robot = told
        if FAULT == "declines": say(message="declined", why="not today")
        else: say(message="ready")
    elif told["message"] == "solve":
        solves += 1
        if FAULT == "hangs" and solves == 7 and not os.path.exists("hung"):
            open("hung", "w").close()
            time.sleep(1000)
        if FAULT == "dies" and solves == 11 and not os.path.exists("died"):
            open("died", "w").close()
            print("no more", file=sys.stderr)
            os._exit(3)
        if FAULT == "deep" and solves == 5: print('{"message":"solved","id":%d,"q":%s}' % (told["id"], "[" * 400000 + "]" * 400000), flush=True)
        if FAULT == "early": print("".join('{"message":"solved","id":%d,"q":[]}\n' % (told["id"] + i) for i in range(1, 1001)), flush=True)
        if FAULT == "noise": print("Iteration 1 of 200\nnull\n{\"message\": 7}\n[1e999]", flush=True)
        if FAULT == "nonsense" and solves == 5: print('{"message":"solved","id":%d,"q":"none"}' % told["id"], flush=True)
        else: solve(told)
    elif told["message"] == "bye":
        break
EOF

program_entry() { # program_entry LABEL WORD [FURTHER KEYS]
  printf '[[solvers]]\nlabel = "%s"\nprocess = ["python3", "faulty.py", "%s"]\npatience_s = 1\n%s\n' "$1" "$2" "${3:-}"
}

# Without programs, and with each faulty one besides: the others' bits are the same.
study plain
succeeds run plain.toml --no-report --out plain
study faults "$(program_entry good fine)" "$(program_entry hangs hangs)" "$(program_entry dies dies)" \
  "$(program_entry noise noise)" "$(program_entry lies lies)" "$(program_entry nonsense nonsense)" \
  "$(program_entry declines declines)"
succeeds run faults.toml --no-figures --out faults
[ "$(column faults/store.sqlite position_error_cm DLS)" = "$(column plain/store.sqlite position_error_cm DLS)" ] ||
  fail "the programs changed the numbers of another solver"
has "$err" "hangs: "
has "$err" "timed_out"
has "$err" "noise: it ended 0 times; lines that are no messages: "
has "$err" "last words: no more"
has "$(tr -s '\n ' ' ' <.out)" "declines gave no answer in 16 of 16 solves (declined): there"

store=faults/store.sqlite
for label in good noise; do
  has_no "$(column $store status $label)" "crashed"
  [ "$(column $store position_error_cm $label)" = "$(column $store position_error_cm good)" ] ||
    fail "$label has other errors than good"
done
[ "$(column $store status hangs | grep -c timed_out)" = 1 ] || fail "hangs: $(column $store status hangs | counted)"
[ "$(column $store status dies | grep -c crashed)" = 1 ] || fail "dies: $(column $store status dies | counted)"
[ "$(column $store status lies | counted)" = "16 claimed_but_wrong" ] || fail "lies: $(column $store status lies | counted)"
[ "$(column $store status declines | counted)" = "16 declined" ] || fail "$(column $store status declines | counted)"
[ "$(column $store status nonsense | grep -c broke_protocol)" -ge 1 ] || fail "$(column $store status nonsense | counted)"
[ "$(column $store counted_by good | counted)" = "16 nobody" ] || fail "$(column $store counted_by good | counted)"
[ -z "$(column $store evaluations good | tr -d '\n')" ] || fail "evaluations that nobody counted"
has "$(<faults/tables/status.csv)" "timed_out"
[ "$(column $store timing good | counted)" = "16 process" ] || [ "$(column $store timing good | counted)" = "16 debug_build" ] ||
  fail "$(column $store timing good | counted)"

# A failed solve leaves the arm where it was, and a second run solves nothing.
"$program" export $store | awk -F, '
  NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
  $column["status"] ~ /^(crashed|timed_out|broke_protocol|declined)$/ {
    for (j = 1; j <= 7; ++j) if ($column["start_rad_" j] != $column["answer_rad_" j]) exit 1 }' ||
  fail "a failed solve moved the arm"
succeeds run faults.toml --no-report --out faults
has "$out" "(128 were already stored)"
succeeds report $store --no-figures

# A comparison says how many solves have no answer; evaluations that nobody counted are no regression, also with --strict.
succeeds compare --verbose good dies --store $store --metric evaluations --strict
has "$out" "1 not compared: nobody counted."
has "$out" "Solves without an answer: none of A's 16; 1 of B's 16 (crashed 1)."
run_it compare --verbose good declines --store $store --metric position_error_cm --metric evaluations
has "$out" "Solves without an answer: none of A's 16; 16 of B's 16 (declined 16)."
has "$out" "nobody counted"

# A program that dies at the end of each solve fails; the reason is reported, and the others continue.
sed 's/if errors is None:/if errors is None: sys.exit("dead at over")\n        if errors is None:/' "$examples/pso.py" >over.py
grep -q "dead at over" over.py || fail "pso.py has another end"
study over '[[solvers]]
label = "over"
process = ["python3", "over.py"]'
succeeds run over.toml --no-report --out over
[ "$(column over/store.sqlite status over | counted)" = "16 crashed" ] || fail "$(column over/store.sqlite status over | counted)"
[ "$(column over/store.sqlite position_error_cm DLS)" = "$(column plain/store.sqlite position_error_cm DLS)" ] ||
  fail "a program that dies at the end changed the numbers of another solver"
has "$err" "last words: dead at over"
run_it check-solver --patience 1 -- python3 over.py
[ "$code" = 1 ] || fail "check-solver: exit code $code: $out $err"
has "$out" "last words: dead at over"

# One that is edited while it runs, and dies, is not mixed with its former self.
sed '/solves += 1/a\        if solves == 6: open(__file__, "a").write("#"); os._exit(3)' faulty.py >changing.py
study changing '[[solvers]]
label = "changing"
process = ["python3", "changing.py"]'
succeeds run changing.toml --no-report --out changing
has "$err" "its files changed while it ran"
[ "$(column changing/store.sqlite status changing | grep -vc crashed)" -le 3 ] || fail "it went on after it was edited"

# Its message is cut between characters.
sed 's/not today/" + 199 * "x" + "é/' faulty.py >wordy.py
study wordy "$(program_entry wordy declines | sed 's/faulty.py/wordy.py/')"
succeeds run wordy.toml --no-report --out wordy
has "$err" "xxx"
has_no "$err" "�"

# An answer nested too deeply breaks the protocol, and so does one to a question that was not asked.
study strange "$(program_entry deep deep)" "$(program_entry early early)"
succeeds run strange.toml --no-report --out strange
[ "$(column strange/store.sqlite status deep | grep -c broke_protocol)" -ge 1 ] || fail "$(column strange/store.sqlite status deep | counted)"
[ "$(column strange/store.sqlite status early | counted)" = "16 broke_protocol" ] ||
  fail "$(column strange/store.sqlite status early | counted)"

# A program in a group of its own, which does not answer and ignores SIGTERM, hangs no longer than its patience.
cat >stuck.py <<'EOF'
import json, os, signal, time
os.setpgid(0, 0)
signal.signal(signal.SIGTERM, signal.SIG_IGN)
print(json.dumps({"ikbench": 1, "message": "hello", "name": "stuck", "version": "1", "modes": ["solve"]}), flush=True)
while True:
    told = json.loads(input())
    if told["message"] == "robot": print('{"message":"ready"}', flush=True)
    if told["message"] == "solve": time.sleep(1000)
EOF
study stuck '[[solvers]]
label = "stuck"
process = ["python3", "stuck.py"]
patience_s = 0.5'
timeout 60 "$program" run stuck.toml --no-report --out stuck >/dev/null 2>&1 || fail "a stuck program: exit code $?"
[ "$(column stuck/store.sqlite status stuck | counted)" = "16 timed_out" ] || fail "$(column stuck/store.sqlite status stuck | counted)"
pgrep -f "python3 stuck.py" >/dev/null && fail "a stuck program is left"

# One question may have more candidates than the budget has evaluations.
sed 's/size, joints = problem\["population"\]/size, joints = 5000/' "$examples/pso.py" >many.py
grep -q "joints = 5000" many.py || fail "pso.py has another population"
study many '[[solvers]]
label = "many"
process = ["python3", "many.py"]'
succeeds run many.toml --set stop.evaluations=100 --no-report --out many
[ "$(column many/store.sqlite evaluations many | counted)" = "16 100" ] || fail "$(column many/store.sqlite evaluations many | counted)"

# An edited program is another one.
study edited "$(program_entry mine fine)"
succeeds run edited.toml --no-report --out edited
sed -i 's/step \*= 0.8/step *= 0.7/' faulty.py
succeeds run edited.toml --no-report --out edited
has "$err" "16 solves of mine come from another version"
[ "$(solves edited/store.sqlite)" = 32 ] || fail "$(solves edited/store.sqlite) solves in the view of the study"

# So is one whose further files changed: solves that failed for a missing package are made anew once it is installed.
cat >needy.py <<'EOF'
import os, sys
if not os.path.exists("package"):
    print('{"ikbench":1,"message":"hello","name":"faulty","version":"1","modes":["solve"],"deterministic":true}', flush=True)
    sys.exit("no package")
exec(open("faulty.py").read())
EOF
echo "package missing" >packages.txt
study needy "$(program_entry needy fine 'files = ["packages.txt"]' | sed 's/faulty.py/needy.py/')"
succeeds run needy.toml --no-report --out needy
[ "$(column needy/store.sqlite status needy | counted)" = "16 crashed" ] || fail "$(column needy/store.sqlite status needy | counted)"
touch package
echo "package 1.0" >packages.txt
succeeds run needy.toml --no-report --out needy
[ "$(column needy/store.sqlite status needy | grep -c crashed)" = 0 ] || fail "$(column needy/store.sqlite status needy | counted)"

# If the system cannot start it any more, that is no result: the run ends, and continues when it can.
{ echo '#!/usr/bin/env python3'; sed '/solves += 1/a\        if solves == 6 and not os.path.exists("righted"): open("righted", "w"); os.chmod(__file__, 0o644); os._exit(3)' faulty.py; } >rights.py
chmod +x rights.py
study rights '[[solvers]]
label = "rights"
process = ["./rights.py"]'
run_it run rights.toml --no-report --out rights
[ "$code" = 2 ] || fail "no rights: exit code $code: $out $err"
has "$err" 'cannot start "./rights.py": Permission denied, which it could before'
[ "$(column rights/store.sqlite status rights | grep -c crashed)" = 1 ] || fail "$(column rights/store.sqlite status rights | counted)"
refused 'cannot start "./rights.py": Permission denied' run rights.toml --no-report --out rights
chmod +x rights.py
succeeds run rights.toml --no-report --out rights
[ "$(column rights/store.sqlite status rights | grep -c crashed)" = 1 ] || fail "$(column rights/store.sqlite status rights | counted)"
[ "$(solves rights/store.sqlite)" = 32 ] || fail "$(solves rights/store.sqlite) solves"

# A program that overruns the budget is not ok, and one that claims one evaluation is not first.
study budgets "$(program_entry late late)" "$(program_entry boasts boasts)" "$(program_entry spends spends)"
sed -i 's/^iterations = 8$/iterations = 8\nseconds = 0.3\nevaluations = 100\ntolerance_cm = 1000/' budgets.toml
succeeds run budgets.toml --no-figures --out budgets
over=0
for label in late spends; do
  status=$(column budgets/store.sqlite status $label)
  ((over += $(grep -cx over_budget <<<"$status")))
  grep -qx -e ok -e tolerance_missed <<<"$status" && fail "$label: $(counted <<<"$status")"
done
((over > 0)) || fail "no solve is over its budget"
has_no "$(column budgets/store.sqlite status boasts)" over_budget
has "$(<budgets/report.md)" "$over solves of programs took far more than their budget of time or evaluations (over budget)."
has "$(<budgets/report.md)" "Evaluations of boasts, spends are not compared: these were counted by the solver itself, those of the others by ikbench."
grep -q "^| late | 16 | 0 |" budgets/tables/solved.md || fail "a late solve counts as solved: $(<budgets/tables/solved.md)"
succeeds report budgets/store.sqlite --no-figures
has_no "$out$err" damaged

# Several at once: the same answers.
succeeds run edited.toml --no-report --out parallel --jobs 2
[ "$(column parallel/store.sqlite position_error_cm mine)" = "$(column edited/store.sqlite position_error_cm mine)" ] ||
  fail "two processes give other answers than one"
has_no "$(column parallel/store.sqlite timing mine)" process

# A user's mistakes.
study mistake "$(program_entry mine fine 'options = { w = 2 }')"
refused 'option w is "2"; expected a number from 0 to 1' run mistake.toml
study mistake "$(program_entry mine fine 'options = { v = 2 }')"
refused 'unknown option "v"' run mistake.toml
study mistake "$(program_entry mine fine 'mode = "ask"')"
refused 'it has no mode "ask"' run mistake.toml
study mistake "$(program_entry mine fine 'files = ["missing.py"]')"
refused 'there is no file' run mistake.toml
study mistake '[[solvers]]
label = "none"
process = ["no_such_program"]'
refused 'mistake.toml:15:11:' run mistake.toml
refused 'cannot start "no_such_program"' run mistake.toml
study mistake '[[solvers]]
label = "none"
process = ["false"]'
refused 'it ends before its hello (exit code 1)' run mistake.toml
study mistake '[[solvers]]
label = "none"
process = ["sleep", "1000"]'
refused 'it says no hello within 20 s; a larger patience_s waits longer' run mistake.toml
sed 's/"name": "w"/"name": "mode"/' faulty.py >clash.py
study mistake '[[solvers]]
process = ["python3", "clash.py"]'
refused 'its option mode has the name of a key of [[solvers]]; expected another name' run mistake.toml
sed 's/name="faulty"/name="f\\u009baulty"/' faulty.py >control.py
study mistake '[[solvers]]
process = ["python3", "control.py"]'
refused 'its name is not a text of at most 200 bytes without control characters' run mistake.toml
study mistake '[[solvers]]
process = ["cat", "/dev/zero"]'
refused 'more than a million bytes' run mistake.toml

# Any end of ikbench ends its programs, and what these have started in their own session.
cat >leaver.sh <<'END'
setsid sleep 31415 </dev/null >/dev/null 2>&1 &
exec python3 faulty.py "$@"
END
children() { pgrep -f "faulty.py $1" | wc -l; }
left_by_it() { pgrep -f "^sleep 31415" | wc -l; }
for signal in INT KILL; do
  sed -e 's/runs = 2/runs = 2000/' -e "s/fine/until-$signal/" -e 's/"python3", "faulty.py"/"sh", "leaver.sh"/' \
    -e 's/patience_s = 1/patience_s = 20/' edited.toml >long.toml
  grep -q leaver.sh long.toml || fail "no leaver in $(<long.toml)"
  "$program" run long.toml --no-report --out long-$signal >/dev/null 2>&1 &
  suite=$!
  for ((i = 0; i < 200; ++i)); do
    [ "$(solves long-$signal/store.sqlite 2>/dev/null)" -ge 1 ] && break # not the process that only says hello
    sleep 0.1
  done
  [ "$(children until-$signal)" -ge 1 ] || fail "the program did not start"
  [ "$(left_by_it)" -ge 1 ] || fail "the program started nothing"
  kill -$signal $suite
  wait $suite 2>/dev/null
  for ((i = 0; i < 50; ++i)); do
    [ "$(children until-$signal) $(left_by_it)" = "0 0" ] && break
    sleep 0.1
  done
  [ "$(children until-$signal)" = 0 ] || fail "SIG$signal left a program behind"
  [ "$(left_by_it)" = 0 ] || fail "SIG$signal left what the program started in a session of its own"
done
echo "programs: all right"

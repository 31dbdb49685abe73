#!/usr/bin/env bash
# A study's own check: what it refuses is not solved, its numbers are compared, and what goes wrong ends the run.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
cp "$scripts/programs/checking.py" "$root"/{solvers/helpers/ikbench,docs/examples/manipulability}.py .

# checked NAME FAULT [LINES]: a study with a check of this fault.
checked() {
  printf 'robot = "ur5e"\nsearch = "pose"\nruns = 24\nrounds = 1\n%s\n' "${3:-start = \"random\"
[path]
kind = \"random\"
points = 1}" >"$1.toml"
  printf '[stop]\nevaluations = 10000\niterations = 10000\ntolerance_cm = 0.001\ntolerance_deg = 0.001\n[check]\nprocess = ["python3", "checking.py", "%s"]\nsmaller = ["lean"]\ntimeout_s = 1\n' "$2" >>"$1.toml"
  printf '[[solvers]]\nsolver = "levenberg_marquardt"\nlabel = "LM"\n[[solvers]]\nsolver = "damped_least_squares"\nlabel = "DLS"\n' >>"$1.toml"
}
statuses() { sqlite3 "$1/store.sqlite" "SELECT status, count(*) FROM current_solves GROUP BY status" | paste -sd' '; }

# Answers are those without it; it refuses by what it sees alone.
checked mine fine
sed '/^\[check\]/,/^timeout/d' mine.toml >plain.toml
for name in plain mine; do succeeds run $name.toml --figures none --out $name; done
has "$(<mine/report.md)" "Rejected by the check: left "
equal "answers" "$(sqlite3 mine/store.sqlite "ATTACH 'plain/store.sqlite' AS plain; SELECT count(*) FROM solves AS one
  JOIN plain.solves AS other USING (label, run, point) WHERE one.answer_rad = other.answer_rad AND one.evaluations = other.evaluations
  AND one.status = CASE WHEN other.status <> 'ok' OR one.answer_rad NOT LIKE '[-%' THEN other.status ELSE 'invalid' END")" 48
equal "numbers" "$(sqlite3 mine/store.sqlite "SELECT count(*) FROM extras JOIN solves USING (series, run, point)
  WHERE name = 'check_lean' AND value = json_extract(answer_rad, '\$[1]')")" "$(sqlite3 mine/store.sqlite "SELECT count(*) FROM solves WHERE status IN ('ok', 'invalid')")"
[[ $(statuses mine) == *"invalid|"*"ok|"* ]] || fail "$(statuses mine)"
checked mine all; succeeds run mine.toml --figures none --out all; has_no "$(statuses all)" invalid
checked mine none; succeeds run mine.toml --figures none --out none; has_no "$(statuses none)" "ok|"
equal "solved" "$(sqlite3 none/store.sqlite "SELECT sum(solved) FROM run_means")" 0.0

# Nothing but run starts it: reports, gates and merges are of what it said.
checked mine fine
for shard in 1/2 2/2; do succeeds run mine.toml --shard $shard --jobs 2 --out shard-${shard%/*}; done
mv checking.py away.py
succeeds merge merged shard-1 shard-2
same_fingerprint mine/store.sqlite merged/store.sqlite
succeeds verify merged/store.sqlite
has "${out//$'\n'/ }" "repeated"
has_no "$out" "in this version"
succeeds report merged/store.sqlite --json --figures none
json 'of["direction"]["lean"] == "smaller" and any(finding["metric"] == "lean" for finding in of["comparisons"])'
succeeds compare mine/store.sqlite merged/store.sqlite
has "$out" "bit for bit"
run_it compare LM DLS --store mine/store.sqlite --json
json '"lean" in of["direction"]'
refused "other checks" compare mine/store.sqlite all/store.sqlite
refused "check" run mine.toml --out mine
mv away.py checking.py

# A judge goes by its number, too; who asks for it names a direction, and no name that is known.
succeeds run mine.toml --figures none --out mine --set analysis.metric=lean --json
json 'of["metric"] == "lean"'
refused "a metric" run mine.toml --out mine --set 'check.larger=["seconds"]'
refused "the name of a metric" run mine.toml --out mine --set 'check.larger=["lean"]'
refused "tolerance_cm" run mine.toml --out mine --set stop.tolerance_cm=0 --set stop.tolerance_deg=0

# It is in the key: with an edited check, or another number, all are solved anew.
equal "solves" "$(solves mine/store.sqlite)" 48
echo '# edited' >>checking.py
succeeds run mine.toml --no-report --out mine
equal "solves of both" "$(sqlite3 mine/store.sqlite "SELECT count(*) FROM solves")" 96

# An edited store is refused (other edits: stored_checks.test.cpp).
cp plain/store.sqlite edited.sqlite
sqlite3 edited.sqlite "UPDATE solves SET status = 'invalid' WHERE status = 'ok'"
refused "check gives" report edited.sqlite --out edited --figures none

# What goes wrong names the answer, and what is stored is kept; a number that is no number, too few and too many, too.
for fault in hangs "stops its parent" dies "is nonsense" "is no verdict" "says no why" "lacks the number" "has another number" "is NaN" "is null"; do
  checked wrong "$fault"
  refused ", run 3, point 1: it " run wrong.toml --no-report --out "wrong $fault"
  equal "kept where it $fault" "$(sqlite3 "wrong $fault/store.sqlite" "SELECT count(*) FROM solves")" 4
done
checked late "begins late"; succeeds run late.toml --no-report --out late
for line in "batch = 5" 'larger = [" "]' 'larger = ["check_x"]'; do
  sed "s/^smaller.*/$line/" mine.toml >odd.toml
  refused "[check]" run odd.toml --no-report --out wrong
done
checked wrong twice; refused "nothing after its answer" run wrong.toml --no-report --out twice
checked wrong "says no hello"; refused "it ended" run wrong.toml --no-report --out hello
sed -i 's/, "says no hello"//; s/checking.py/nowhere.py/' wrong.toml; refused "nowhere.py" run wrong.toml --no-report --out hello
sed -i '/^process/d' wrong.toml; refused "process" run wrong.toml --no-report --out hello

# A chain goes on from an answer that is invalid; a check comes behind both calls of warm ones; an example.
checked chain fine 'start = "previous"
[path]
kind = "helix"
points = 5'
succeeds run chain.toml --no-report --out chain --set runs=2
succeeds verify chain/store.sqlite
checked warm fine 'state = "warm"
start = "random"
[path]
kind = "random"
points = 1'
succeeds run warm.toml --no-report --out warm
equal "warm" "$(statuses warm)" "$(statuses merged)"
sed -e 's/"checking.py", "fine"/"manipulability.py", "0.02"/; s/^smaller.*/larger = ["manipulability"]\nfiles = ["ikbench.py"]/' mine.toml >example.toml
succeeds run example.toml --figures none --out example
has "$(<example/report.md)" "near a singularity"
printf 'import ikbench\nikbench.check(lambda arm, answer: None)\n' >mute.py
sed -e 's/"checking.py", "fine"/"mute.py"/; /^smaller/d' mine.toml >mute.toml
refused "expected True" run mute.toml --no-report --out mute

# An arm of three bars, which fold over one another: neighbours may touch, the first and the last may not.
bar() {
  printf '<link name="%s"><collision><origin xyz="0.2 0 0"/><geometry><box size="0.3 0.05 0.05"/></geometry></collision></link>\n' "$1"
  [ -z "${2:-}" ] || printf '<joint name="to_%s" type="revolute"><parent link="%s"/><child link="%s"/><origin xyz="%s 0 0"/><axis xyz="0 0 1"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>\n' "$1" "$2" "$1" "$3"
}
{ echo '<robot name="bars">'; echo '<link name="base"/>'; bar one base 0; bar two one 0.4; bar three two 0.4; bar tip three 0.4; echo '</robot>'; } >bars.urdf
{ echo '<robot name="bars">'; printf '<disable_collisions link1="%s" link2="%s"/>\n' one two two three three tip one tip two tip; echo '</robot>'; } >bars.srdf
cp "$root/docs/examples/self_collision.py" .
printf 'robot = "bars.urdf"\nsearch = "all_joints"\nruns = 60\n[check]\nprocess = ["python3", "self_collision.py", "bars.srdf"]\nlarger = ["clearance_mm"]\n[[solvers]]\nsolver = "damped_least_squares"\n' >bars.toml
python=$root/build/libraries/with_pinocchio/bin/python
if "$python" -c 'import pinocchio' 2>.none; then
  sed -i "s|\"python3\"|\"$python\"|" bars.toml
  succeeds run bars.toml --figures none --out bars
  has "$(<bars/report.md)" "self-collision"
else
  python3 -m py_compile self_collision.py || fail "no Python"
  echo "skipped in part: no pinocchio (solvers/programs/install.sh with_pinocchio.py)"
fi

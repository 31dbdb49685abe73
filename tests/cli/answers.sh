#!/usr/bin/env bash
# Answers made elsewhere: targets go out, answers come back, are verified, and what is wrong with them stands above the verdict.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

cat >my.toml <<'END'
name = "mine"
robot = "ur5e"
search = "pose"
start = "middle"
limits = "enforced"
runs = 12
[path]
kind = "random"
points = 1
[stop]
tolerance_cm = 0.001
tolerance_deg = 0.001
evaluations = 20000
[[solvers]]
label = "LM"
solver = "levenberg_marquardt"
[[solvers]]
label = "MoveIt"
answers = "moveit.csv"
END

# The file is missing: the others are solved, and the targets are in the folder of results alone.
ends 5 run my.toml --out out --figures none
has "$err" "out/targets.csv"
has "$err" "moveit.csv"
has "$err" "ikbench run my.toml --out out --figures none"
has "$out" "LM"
equal "files beside the study" "$(ls)" "$(printf 'my.toml\nout')"
equal "solves of LM" "$(solves out/store.sqlite)" 12
equal "targets" "$(head -n 1 out/targets.csv | cut -d, -f 1-11)" "run,point,target,x,y,z,qx,qy,qz,qw,start_joint_1"
succeeds export out/store.sqlite --format targets
cmp <("$program" export out/store.sqlite --format targets) out/targets.csv || fail "other targets from the store"
ends 5 run my.toml --only MoveIt --out alone
equal "files without other solvers" "$(ls alone)" targets.csv

# answers EXPRESSION [FACTOR]: LM's own answers, as another program would write them: rows back to front, the joints `q` changed.
answers() {
  "$program" export out/store.sqlite >solves.csv
  python3 - "$1" >moveit.csv <<'END'
import csv, math, sys
targets = {(row["run"], row["point"]): row["target"] for row in csv.DictReader(open("out/targets.csv"))}
print("run;point;target;q1;q2;q3;q4;q5;q6;ms;note")
for row in reversed([row for row in csv.DictReader(open("solves.csv")) if row["label"] == "LM"]):
    q = eval(sys.argv[1], {"q": [float(row[f"answer_rad_{j + 1}"]) for j in range(6)], "math": math})
    print(row["run"], row["point"], targets[row["run"], row["point"]], *q, 2.5, "x", sep=";")
END
}

answers q
succeeds run my.toml --out out --figures none
is out MoveIt "12 ok"
has "$out" "LM and MoveIt solved all 12 targets"
has "$out" "self-reported"
[[ $out != *" as long as "* ]] || fail "times of elsewhere are compared: $out"
equal "times" "$(column out/store.sqlite seconds MoveIt | sort -u)" 0.0025
succeeds verify out/store.sqlite
has_no "$err" "was changed"
succeeds run out/store.sqlite --out again --no-report # the file lies in this folder
is again MoveIt "12 ok"

echo >>moveit.csv
succeeds verify out/store.sqlite
has "$(tr -s '\n ' ' ' <<<"$err")" "the file of MoveIt's answers was changed since they were solved"

# The cause of wrong answers is the first that is said; an edited file is read again, and its cause goes.
answers '[math.degrees(x) for x in q]'
succeeds run my.toml --out out --figures none
equal "the first line" "$(head -n 1 .out)" "! MoveIt: angles are in degrees; expected radians"
has "$(<out/report.html)" "angles are in degrees"
succeeds run my.toml --out out --figures none --json
json '"MoveIt: angles are in degrees; expected radians" in of["warnings"]'
answers q
succeeds run my.toml --out out --figures none
has_no "$out" degrees

# A target without a row has no answer. In a study with a time limit, answers without times are shown, and are in no comparison.
sed -i 6,7d moveit.csv
succeeds run my.toml --out out --figures none
has "$out" "2 of 12 solves gave no answer (MoveIt)"
equal "no row" "$(column out/store.sqlite stop_reason MoveIt | counted | head -n 1)" "2 gave_up"
succeeds run my.toml --out limited --figures none --set stop.seconds=5
has_no "$out" "MoveIt is not compared"
cut -d';' -f 1-9 moveit.csv >without && mv without moveit.csv
succeeds run my.toml --out limited --figures none --set stop.seconds=5
has "$(tr -s '\n ' ' ' <.out)" "MoveIt is not compared: solved elsewhere, and not every answer has a time"

refused "start is \"previous\"" run my.toml --set start=previous --out chained
# Answers to the targets of another seed: the current targets are written, and the command goes on.
ends 5 run my.toml --set seed=2 --out out --figures none
has "$(tr -s '\n ' ' ' <<<"$err")" "its target is"
has "$err" "ikbench run my.toml --set seed=2 --out out --figures none"
cmp <("$program" export out/store.sqlite --format targets) out/targets.csv || fail "targets of another seed"
rm moveit.csv
# The study of a store whose file of answers is missing.
ends 5 run again/store.sqlite --out again2 --no-report
has "$err" "MoveIt has no answers yet. Its targets are in again2/targets.csv"
mkfifo moveit.csv
refused "not a regular file" run my.toml --out piped

# A program with its own kinematics is told the cause, too: by `run` above the verdict, and by `check-solver`.
sed 's/^    return q$/    return [q[1], q[0], *q[2:]]/' "$root/docs/examples/descent.py" >swapped.py
cat >program.toml <<'END'
robot = "ur5e"
search = "all_joints"
start = "middle"
runs = 6
[path]
kind = "random"
points = 1
[stop]
tolerance_cm = 0.01
evaluations = 2000
[[solvers]]
label = "mine"
process = ["python3", "swapped.py"]
END
export PYTHONPATH=$root/solvers/helpers
succeeds run program.toml --figures none --out program
has "$(head -n 2 .out)" "! mine: the joints are in another order: joints 1 to 6 stand as q2, q1, q3, q4, q5, q6"
ends 1 check-solver -- python3 swapped.py
has "$(tr -s '\n ' ' ' <.out)" "its answers have no common fault: the joints are in another order"
ends 0 check-solver -- python3 "$root/docs/examples/descent.py"

#!/usr/bin/env bash
# `run STORE --out NEW` solves the study of a store again: the same solves, whatever the study asks, where only the store is.
source "$(dirname "$0")/common.sh"
small=(--set runs=2 --set stop.iterations=5 --no-report)

# again NAME: a study into NAME, and that store's study into NAME-again from another folder, with the same solves, definition and
# series, so that stores of both can be merged.
mkdir elsewhere
again() {
  succeeds run "${@:2}" "${small[@]}" --out "$1"
  (cd elsewhere && run_it run "../$1/store.sqlite" --no-report --out "../$1-again" && [ "$code" = 0 ]) || fail "$1: $(<.err)"
  same_fingerprint "$1/store.sqlite" "$1-again/store.sqlite"
  local table
  for table in "definition FROM studies" "* FROM series"; do
    cmp <(sqlite3 "$1/store.sqlite" "SELECT $table") <(sqlite3 "$1-again/store.sqlite" "SELECT $table") || fail "$1: another $table"
  done
}
again paper slim2023 --set path.points=3 --set population=6 --sweep IK-BA.alpha=0.5,0.9
again limits slim2023-limits --set path.points=3
again drawn any-arm --set robot=ur5e --set start=near --set path.set=anywhere
again numpy any-arm --set robot=ur5e --set path.generator=numpy --set start=initial --set limits=enforced
cp "$scripts/studies/my_arm.toml" .
again file any-arm --robot my_arm.toml --set search=all_joints --set stop.tolerance_deg=0 --only LM
cat >poses.toml <<'END'
robot = "planar_3"
search = "all_joints"
[path]
kind = "poses"
poses = [{ position_cm = [30, 10, 0], rpy_deg = [0, 0, 0] }, { position_cm = [33.3, 10.7, 0], rpy_deg = [0, 0, 17] }]
[stop]
[figures]
width_cm = 9
[[solvers]]
solver = "damped_least_squares"
[[solvers]]
solver = "particle_swarm"
label = "PSO, exchanged"
population = [10, 20]
colour = "#ff0000"
options = { coefficients = "exchanged" }
END
again poses poses.toml
printf 'x_cm,y_cm,z_cm\n30,10,0\n31.7,11,0\n' >targets.csv
sed 's/^kind.*/kind = "csv"\nfile = "targets.csv"/; /^poses/d' poses.toml >listed.toml
again listed listed.toml

# A URDF file is taken where it is still the arm; else the arm is as the store has it, to its rounding, and the program says so.
cp "$root/tests/data/urdf/ur5e.urdf" .
succeeds run any-arm --robot ur5e.urdf "${small[@]}" --only LM --out urdf
succeeds run urdf/store.sqlite --no-report --out urdf-here
same_fingerprint urdf/store.sqlite urdf-here/store.sqlite
cd elsewhere || exit 1
succeeds run ../urdf/store.sqlite --no-report --out ../urdf-there
has "$err" "as the store has it"
refused "add --robot" run ../urdf/store.sqlite --tip flange --no-report --out ../other
cp "$root/tests/data/urdf/panda.urdf" ur5e.urdf
refused "another arm than ur5e.urdf in the store" run ../urdf/store.sqlite --no-report --out ../other
succeeds run ../urdf/store.sqlite --robot ../ur5e.urdf --no-report --out ../urdf-given
cd ..
same_fingerprint urdf/store.sqlite urdf-given/store.sqlite
equal "errors" "$(sqlite3 urdf-there/store.sqlite "ATTACH 'urdf/store.sqlite' AS first; SELECT count(*) FROM solves AS one
  JOIN first.solves AS other USING (label, run, point) WHERE one.status = other.status")" "$(solves urdf/store.sqlite)"

# Keys may be changed, as those of a study file.
succeeds run paper/store.sqlite --no-report --set runs=3 --only DE --out changed
equal "solves" "$(solves changed/store.sqlite)" 9

# Programs run only if the user says so, and are named before.
cp "$root"/{solvers/helpers/ikbench,docs/examples/pso}.py .
printf '[[solvers]]\nlabel = "a program"\nprocess = ["python3", "pso.py"]\nfiles = ["ikbench.py"]\ntimeout_s = 70\noptions = { w = 0.5 }\n' |
  cat poses.toml - >programs.toml
succeeds run programs.toml "${small[@]}" --out programs
for command in "verify programs/store.sqlite" "report programs/store.sqlite --figures none --out shown"; do
  # shellcheck disable=SC2086
  succeeds $command
  has_no "$err" "starts"
done
refused "python3 pso.py" run programs/store.sqlite --no-report --out programs-again
has "$(tr -s ' \n' ' ' <.err)" "ikbench run programs/store.sqlite --out programs-again --start-programs"
[ ! -e programs-again ] || fail "a refused study made a folder"
succeeds run programs/store.sqlite --no-report --out programs-again --start-programs
same_fingerprint programs/store.sqlite programs-again/store.sqlite
cd elsewhere || exit 1
refused "ikbench.py" run ../programs/store.sqlite --no-report --out ../other --start-programs
cd ..

# What a store is, and what to do with it; a store of several studies has one named.
refused "run paper/store.sqlite --out NEW" run paper/store.sqlite
succeeds run slim2023-context "${small[@]}" --set path.points=3 --out paper
succeeds run paper/store.sqlite --study slim2023-context --no-report --out second
equal "study" "$(sqlite3 second/store.sqlite "SELECT name FROM studies")" slim2023-context
refused "is not a store" run poses.toml --study poses --out other
refused "older ikbench" run "$root/tests/data/version-4.sqlite" --out other
broken() { # WORD SQL
  cp poses/store.sqlite broken.sqlite
  sqlite3 broken.sqlite "$2"
  refused "$1" run broken.sqlite --no-report --out other
}
set_definition() { echo "UPDATE studies SET definition = json_set(definition, '\$.$1', json('$2'))"; }
broken "other solvers" "$(set_definition 'solvers[0]' '{"solver":"random_search","label":"damped_least_squares"}')"
broken "solvers" "$(set_definition solvers 3)"
broken "solvers" "$(set_definition solvers '[]')"
broken "solvers" "$(set_definition solvers '[7]')"
broken "label" "$(set_definition 'solvers[0].label' 7)"
broken "process" "$(set_definition 'solvers[0].process' '{"a":1}')"
broken "lacks solves" "DELETE FROM solves WHERE point = 2"
broken "rotation" "UPDATE solves SET target_rotation = '[9,0,0,0,1,0,0,0,1]'"
broken "position_m" "UPDATE solves SET target_position_m = '[1,2]'"
broken "arm" "$(set_definition arm.links '[]')"
[ ! -e other ] || fail "a refused store was begun"

#!/usr/bin/env bash
# Any arm, any task: a user's URDF file with a torso that slides and joints without end, whole poses drawn at random,
# eight solvers; and a tracked path. The reports speak of that arm and that task, and of nothing else.
source "$(dirname "$0")/common.sh"
cp "$scripts/../data/urdf/fetch.urdf" "$scripts/../data/urdf/ur5e.urdf" .

solvers=(ik_bat bat differential_evolution particle_swarm k_artificial_bee_colony random_search damped_least_squares newton)
cat >theirs.toml <<'E2'
name = "theirs"
robot = "fetch.urdf"
search = "pose"
start = "middle"
bounds = "clamp"
runs = 4
population = 10
[stop]
iterations = 200
evaluations = 1000
tolerance_cm = 0.1
tolerance_deg = 0.5
[path]
kind = "random"
points = 3
E2
for solver in "${solvers[@]}"; do printf '[[solvers]]\nsolver = "%s"\n' "$solver"; done >>theirs.toml
succeeds run --verbose theirs.toml --no-figures --out theirs
[ "$(solves theirs/store.sqlite)" = 96 ] || fail "eight solvers, four runs and three points are 96 solves"
! grep -i -n 'helix\|slim' theirs/report.html theirs/report.md || fail "the report speaks of a paper"
has "$out" "within 0.1 cm and 0.5 deg"

# With three.js the page shows the arm moving; its first joint slides and some others turn without end.
if [ -e /usr/share/javascript/three ] || [ -e /usr/share/nodejs/three ]; then
  grep -q 'id="motion-data"' theirs/report.html || fail "the page does not show the arm moving"
fi

# table_column NAME FILE: of a CSV table with a solver in the first column, "solver value" a line.
table_column() {
  awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) column = i; next } { print $1, $column }' "$2"
}

# Success against budget ends at the share that is solved; failures count.
awk '/^# [a-z_]+$/ { solver = $2 } /^[0-9]/ { share[solver] = $2 } END { for (s in share) print s, share[s] }' \
  theirs/figures/statistics-solved-evaluations.dat | sort >drawn
table_column share theirs/tables/solved.csv | sort | diff drawn - || fail "the curves end elsewhere than the table says"
awk '$1 == "damped_least_squares" { exit !($2 > 0.5) }' drawn || fail "damped least squares solves few of the poses: $(<drawn)"

# The figure of its joints shows the slide in centimetres: at most the 38.6 cm that the file allows.
has "$(<theirs/figures/joints.gp)" "joint 1 [cm]"
has_no "$(<theirs/figures/joints.gp)" "joint 2 [cm]"
awk '/^[0-9]/ { if ($2 < -0.001 || $2 > 38.616) bad = 1; if ($2 > 1) moved = 1 } END { exit bad || !moved }' \
  theirs/figures/joints.dat || fail "the torso is elsewhere than between 0 and 38.6 cm"

# A path from a program that writes poses: who keeps up.
cat >rectangle.toml <<'E2'
name = "rectangle"
robot = "ur5e.urdf"
search = "pose"
runs = 2
initial_deg = [0, -90, 90, -90, -90, 0]
deadline_ms = 10000
[stop]
iterations = 100
tolerance_cm = 0.001
tolerance_deg = 0.01
[path]
kind = "csv"
file = "rectangle.csv"
[[solvers]]
solver = "damped_least_squares"
[[solvers]]
solver = "newton"
E2
command -v python3 >/dev/null || exit 77
python3 "$scripts/../../docs/examples/rectangle.py" >rectangle.csv
[ "$(sed -n 2p rectangle.csv)" = "$(tail -n 1 rectangle.csv)" ] || fail "the rectangle does not end where it begins"
succeeds run --verbose rectangle.toml --no-figures --out rectangle
! grep -i -n 'helix\|slim' rectangle/report.html rectangle/report.md || fail "the report speaks of a paper"
for solver in damped_least_squares newton; do
  grep -q "^$solver 1$" <<<"$(table_column share rectangle/tables/solved.csv)" || fail "$solver does not follow the rectangle"
  grep -q "^$solver 0$" <<<"$(table_column over_deadline rectangle/tables/times.csv)" || fail "$solver is late"
done
[ "$(solves rectangle/store.sqlite)" = 124 ] || fail "two runs of 31 points by two solvers are 124 solves"

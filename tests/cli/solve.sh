#!/usr/bin/env bash
# One target from the command line.
source "$(dirname "$0")/common.sh"

value() { # value NAME: what `solve` says of it
  grep "^$1  " .out | sed -E 's/^.* {2,}//'
}

# answers ARGUMENTS...: an answer that is printed, within the tolerance or not: exit code 0 or 6.
answers() {
  run_it solve "$@"
  [ "$code" = $([ "$(value status)" = ok ] && echo 0 || echo 6) ] || fail "solve $*: exit code $code; it said: $out $err"
}

# Two links of half a metre: (50, 50) cm is an elbow of 90 degrees.
succeeds solve --robot planar_2 --position-cm 50 50 0 --tolerance-cm 0
[ "$(value status)" = ok ] || fail "planar: $out"
[[ $(value 'joint 2 \[deg\]') =~ ^-?(90\.000|89\.999) ]] || fail "the elbow is at $(value 'joint 2 \[deg\]')"
[ "$(grep -c '^joint' .out)" = 2 ] || fail "planar_2 has two joints: $out"
quiet

# The iiwa, wrist in closed form: the orientation is met exactly.
for tool in down eq27; do
  succeeds solve --position-cm 50 10 40 --tool $tool --tolerance-cm 1e-7
  [ "$(grep -c '^joint' .out)" = 7 ] || fail "the iiwa has seven joints: $out"
  awk -v e="$(value 'orientation error \[deg]')" 'BEGIN { exit !(e < 1e-9) }' || fail "orientation: $out"
  awk -v e="$(value 'position error \[cm\]')" 'BEGIN { exit !(e < 1e-6) }' || fail "position: $out"
done
succeeds solve --position-cm 50 10 40 --rpy-deg 180 0 180
down=$(grep '^joint' .out)
succeeds solve --position-cm 50,10,40 --tool down
[ "$(wc -l <<<"$down")" = 7 ] || fail "seven joints expected: $down"

# A UR5e has no spherical wrist: with an orientation its pose is searched, and both errors are told.
succeeds solve --robot ur5e --position-cm 40 20 30 --rpy-deg 180 0 90 --tolerance-cm 1e-6 --tolerance-deg 1e-6
[ "$(value status)" = ok ] || fail "pose: $out"
awk -v e="$(value 'position error \[cm\]')" 'BEGIN { exit !(e < 2e-6) }' || fail "position: $out"
awk -v e="$(value 'orientation error \[deg\]')" 'BEGIN { exit !(e < 2e-6) }' || fail "angle: $out"
succeeds solve --robot ur5e --position-cm 40 20 30
[[ $(value 'orientation error \[deg\]') == *"(not sought)" ]] || fail "the position alone: $out"
refused 'about the orientation, which is not searched' solve --robot ur5e --position-cm 40 20 30 --tolerance-deg 1
refused 'expects both, or neither' solve --robot ur5e --position-cm 40 20 30 --search pose --tolerance-cm 0 --tolerance-deg 1
succeeds solve --search pose --position-cm 50 10 40 --tolerance-cm 0
[ "$(grep -c '^joint' .out)" = 7 ] || fail "the iiwa has seven joints: $out"

# Every solver that is built; the same seed, the same answer, and another with another.
for solver in $("$program" list solvers | tail -n +2 | grep -v "  not built: " | cut -d' ' -f1); do
  arm=kuka_iiwa14
  [ "$solver" = closed_form ] && arm=abb_irb120  # for six joints
  answers --robot $arm --position-cm 40 20 30 --solver "$solver" --set stop.iterations=5
  [ "$(value solver)" = "$solver" ] || fail "$solver: $out"
  first=$(grep -v '^time' .out)
  answers --robot $arm --position-cm 40 20 30 --solver "$solver" --set stop.iterations=5
  [ "$(grep -v '^time' .out)" = "$first" ] || fail "$solver: another answer with the same seed"
done
answers --position-cm 60 20 30 --solver ik_bat --seed 1
first=$(grep '^joint' .out)
answers --position-cm 60 20 30 --solver ik_bat --seed 2
[ "$(grep '^joint' .out)" != "$first" ] || fail "the same answer with another seed"

# Options of the solver and of the stop rule.
answers --position-cm 60 20 30 --solver ik_bat --set bounds=clamp --set stop.iterations=7
[ "$(value iterations)" = 7 ] || fail "stop.iterations: $out"

# Negative coordinates are numbers, not options.
succeeds solve --position-cm -50 -10 40
succeeds solve --position-cm=-50,-10,40 --start-deg=-10,20,-30,40,-50,60,-70

# Out of reach, the answer is what it is, and says so, also by the exit code.
run_it solve --robot planar_2 --search all_joints --position-cm 200 0 0
[ "$code" = 6 ] || fail "200 cm with 100 cm of arm: exit code $code, expected 6"
awk -v e="$(value 'position error \[cm\]')" 'BEGIN { exit !(e > 99.9) }' || fail "200 cm with 100 cm of arm: $out"
[ "$(value status)" = tolerance_missed ] || fail "100 cm off is no answer: $out"
refused "--position-cm: '' is not a number" solve --position-cm '' 0 0
refused "--position-cm: '0x10' is not a number" solve --position-cm 0x10 0 0
refused '--position-cm has 1e+300; expected numbers within +-1e6' solve --position-cm 1e300 0 0

#!/usr/bin/env bash
# An arm is one file.
source "$(dirname "$0")/common.sh"
cat >my_study.toml <<'TOML'
robot = "my_arm.toml"
search = "all_joints"
[path]
kind = "random"
[[solvers]]
solver = "damped_least_squares"
TOML
cat >my_arm.toml <<'TOML'
summary = "SCARA: two turns and a slide"
source = "an example"
links = [
  { d_m = 0.40, a_m = 0.30, limits_deg = [-130, 130] },
  { a_m = 0.20, alpha_deg = 180, limits_deg = [-145, 145] },
  { joint = "slides", limits_m = [0, 0.15] },
]
tool = { position_m = [0, 0, 0.05] }
TOML

succeeds robot my_arm.toml
succeeds run my_study.toml "${small[@]}" --no-figures --out made
[ "$(solves made/store.sqlite)" = 6 ] || fail "two runs of three points are 6 solves"
grep -q ",my_arm," <<<"$("$program" export made/store.sqlite)" || fail "the solves do not name their arm"
grep -q 'id="motion-data"' made/report.html || fail "the page does not show the arm moving"

# The file is the one beside the study, from wherever the program is called; a copy of the arm is the same arm.
mkdir elsewhere
(cd elsewhere && "$program" run ../my_study.toml "${small[@]}" --no-report --out ../made >../.out 2>&1) || fail "$(<.out)"
has "$(<.out)" "(6 were already stored)"
cp my_arm.toml copy.toml
succeeds run my_study.toml "${small[@]}" --set robot=copy.toml --no-report --out made
has "$out" "(6 were already stored)"
sed -i 's/0.30/0.31/' my_arm.toml
succeeds run my_study.toml "${small[@]}" --no-report --out made
has_no "$out" "were already stored"

# Mistakes.
refused 'there is no file none.toml' list robots none.toml
refused '--set robot: there is no file none.toml' run my_study.toml --set robot=none.toml
sed -i 's/d_m = 0.40/d_m = 400/' my_arm.toml
for command in "list robots my_arm.toml" "run my_study.toml"; do
  refused 'my_arm.toml:4:11: links.d_m is 400; expected a number from -100 to 100' $command
done

# An arm from a URDF file: shown, solved, run, and its mistakes.
cp "$scripts/../data/urdf/fetch.urdf" "$scripts/../data/urdf/ur5e.urdf" "$scripts/../data/urdf/gen3.urdf" .
succeeds robot fetch.urdf --at 0.1,0,0,0,90,0,0,0
has "$out" "torso_lift"
has "$out" "wrist: spherical"
has "$out" "with the joints at 0.1 m, 0 deg, 0 deg, 0 deg, 90 deg, 0 deg, 0 deg, 0 deg, the tool is at (0.501"
succeeds robot gen3.urdf --out picture
has "$out" "angles are snapped, which moves the tool by at most"
[ -s picture/robot.gp ] && [ -s picture/robot.dat ] || fail "there is no picture"
succeeds robot ur5e
has "$out" "reach: at most"
# The arm that is written from the printed numbers has the same tool, to every digit that is shown. A conversion leaves no
# digits of its own.
has_no "$out" "0000000"
has_no "$out" "9999999"
succeeds robot ur5e.urdf --at 10,-20,30.5,40,50,60
unwrapped() { sed -z 's/\n  / /g' .out; }
where=$(unwrapped | tail -n 1)
{
  echo 'links = ['
  awk '/^[1-9] / { printf "{ limits_deg = [%s, %s], a_m = %s, alpha_deg = %s, d_m = %s, offset_deg = %s },\n", $3, $4, $6, $7, $8, $9 }' .out
  sed -n 's/^tool at (\(.*\)) m, roll pitch yaw (\(.*\)) deg$/]\ntool = { position_m = [\1], rpy_deg = [\2] }/p' <(unwrapped)
} >written.toml
[[ $where != *0000000* && $where != *9999999* ]] || fail "digits that nobody wrote: $where"
succeeds robot written.toml --at 10,-20,30.5,40,50,60
[ "$(unwrapped | tail -n 1)" = "$where" ] || fail "another arm than it was written from: $where, and $(unwrapped | tail -n 1)"
succeeds robot ur5e --at-rad 0.1,-0.2,0.3,0,0,0
has "$out" "with the joints at 0.1 rad, -0.2 rad, 0.3 rad"
refused '--at excludes --at-rad' robot ur5e --at 1,2,3,4,5,6 --at-rad 1,2,3,4,5,6
refused '--at-rad has 1 values; expected 6' robot ur5e --at-rad 1
sed 's/robot = .*/robot = "fetch.urdf"/' my_study.toml >urdf_study.toml
succeeds run urdf_study.toml "${small[@]}" --set urdf.tip=wrist_roll_link --no-report --out described
grep -q ",fetch," <<<"$("$program" export described/store.sqlite)" || fail "the solves do not name their arm"
refused 'tip is "griper_link", which is no link; did you mean "gripper_link"?' robot fetch.urdf --tip griper_link
refused 'urdf.limits is "both"; expected one of "hard", "soft"' run urdf_study.toml --set urdf.limits=both
refused '[urdf] is about a URDF file, but robot is "planar_2"' run urdf_study.toml --set robot=planar_2 --set urdf.tip=x
refused 'there is no file none.urdf' robot none.urdf
refused '--at has 2 values; expected 6' robot ur5e --at 1,2
echo '<robot name="r"><xacro:include filename="x"/></robot>' >macro.urdf
refused 'macro.urdf:1: this is xacro; expand it first: xacro macro.urdf > macro_expanded.urdf' robot macro.urdf

#!/usr/bin/env bash
# An arm is a name, a file of joints, or a URDF: shown, run, and its mistakes.
source "$(dirname "$0")/common.sh"
cp "$scripts"/studies/{my_*.toml,two.urdf} .
cp "$root"/tests/data/urdf/{fetch,gen3}.urdf .
sed 's/1\.57079632[0-9]*/1.5707963267948966/g; s/3\.14159265[0-9]*/3.141592653589793/g' "$root/tests/data/urdf/ur5e.urdf" >ur5e.urdf

unwrapped() { sed -z 's/\n  / /g' .out; }
# shows JOINTS PLACE ARGUMENTS...: the number of joints and where the tool is.
shows() {
  succeeds robot "${@:3}"
  equal "joints of $3" "$(grep -c '^[1-9] ' .out)" "$1"
  has "$(unwrapped)" "the tool is at ($2"
}
shows 3 "0.5, 0, 0.35) m" my_arm.toml
shows 3 "0.3, 0.2, 0.25) m" my_arm.toml --at 0,90,0.1
shows 8 "0.50165, 0, 0.25956) m" fetch.urdf --at 0.1,0,0,0,90,0,0,0
has "$out" "wrist: spherical"
has "$out" " velocity "
has "$out" " 0.1 m/s "
shows 6 "0.929, 0, 0.06) m" fetch.urdf --base shoulder_pan_link --tip wrist_roll_link
shows 7 "0, -0.02485" gen3.urdf
has "$(tr -s '\n ' ' ' <.out)" "last three axes are 0.35 mm from a common point and 0.00021 deg from right angles" # of 1.5708

# The arm that is written from the numbers of the screen has the same tool, to every digit that is shown. A conversion
# leaves no digits of its own.
succeeds robot ur5e.urdf --at 10,-20,30.5,40,50,60
where=$(unwrapped | tail -n 1)
{
  echo 'links = ['
  awk '/^[1-9] / { printf "{ limits_deg = [%s, %s], a_m = %s, alpha_deg = %s, d_m = %s, offset_deg = %s },\n", $3, $4, $6, $7, $8, $9 }' .out
  sed -n 's/^tool at (\(.*\)) m, roll pitch yaw (\(.*\)) deg$/]\ntool = { position_m = [\1], rpy_deg = [\2] }/p' <(unwrapped)
} >written.toml
for digits in 0000000 9999999; do has_no "$out" $digits; done
succeeds robot written.toml --at 10,-20,30.5,40,50,60
equal "tool of the written arm" "$(unwrapped | tail -n 1)" "$where"

# What turns text around is printed nowhere, in the tree of links neither.
sed $'s/name="wrist_3_link"/name="wrist\u202e_3_link"/; s/link="wrist_3_link"/link="wrist\u202e_3_link"/' ur5e.urdf >turned.urdf
succeeds robot turned.urdf --links
has "$out" "_3_link"
has_no "$out" $'\u202e'

# An arm of a file, run. (Where it lies, and what makes it another: study_file.test.cpp.)
succeeds run my_study.toml "${small[@]}" --figures none --out made
equal "solves" "$(column made/store.sqlite robot damped_least_squares | counted)" "6 my_arm"
grep -q 'id="motion-data"' made/report.html || [ ! -e /usr/share/javascript/three ] || fail "the page does not show the arm moving"

# A question is commands to paste; the arm's size is shown, what is odd is warned of, and a time is the only limit.
ends 1 run --robot two.urdf --set runs=2 --limit 20ms --no-report
equal "commands" "$(grep -c '^ *ikbench run .* --tip [lr][a-z]*2    # 3 joints$' .err)" 2
eval "$(grep -m 1 '^ *ikbench run' .err | sed 's/ikbench/"$program"/')" >.out 2>.err || fail "the command that was proposed: $(<.err)"
said=$(tr -s '\n ' ' ' <.err)
for word in "from body to left2" "3 joints, reach " "warning: the arm reaches" "warning: a joint's velocity is 180"; do has "$said" "$word"; done
equal "limits" "$(sqlite3 out/two/store.sqlite "SELECT definition->>'$.stop.seconds', definition->>'$.analysis.deadline_ms' FROM studies")" "0.02|20.0"
refused 5ms run ur5e --limit 5
rm two.urdf

# Files with the features of public URDF files, held against other kinematics, and run.
cp "$root"/tests/data/urdf/*.urdf .
python3 "$scripts/urdfs.py" "$program" *.urdf || fail "see above"

# An arm in the place of a study is that of --robot.
cp "$root/tests/data/urdf/ur5e.urdf" "$scripts/studies/my_arm.toml" .
for arm in ur5e.urdf my_arm.toml; do
  more=(--set runs=1 --set search=all_joints --set stop.tolerance_deg=0 --only LM --no-report)
  succeeds run $arm "${more[@]}" --out plain-$arm
  succeeds run --robot $arm "${more[@]}" --out option-$arm
  same_fingerprint plain-$arm/store.sqlite option-$arm/store.sqlite
done

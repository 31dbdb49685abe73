#!/usr/bin/env bash
# beeson2015.sh: solves the poses of ikbench's study beeson2015 with TRAC-IK itself (beeson2015.toml), on each of its
# arms, into out/beeson2015/programs.csv, which `ikbench reproduce beeson2015` takes in place of what is shipped. Before
# it: install.sh with_trac_ik.py. IKBENCH is the program, if it is not on the PATH.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")") out=out/beeson2015
cc -O2 -shared -fPIC -o "$here/../../build/libraries/processor_clock.so" "$here/processor_clock.c"
for arm in abb_irb120 abb_yumi_left atlas_2013_left atlas_2015_left baxter_left fanuc_m430ia2f franka_panda_2018 \
  kinova_jaco2_limited kuka_iiwa14_experimental motoman_csda10f_right motoman_mh180 pr2_right schunk_lwa4d; do
  ${IKBENCH:-ikbench} run "$here/beeson2015.toml" --set robot=$arm --set name=beeson2015-$arm --no-report \
    --out $out/programs
done
machine="$(nproc) cores of an $(sed -n 's/^model name\t*: //p' /proc/cpuinfo | head -1)"
sqlite3 -csv -header $out/programs/store.sqlite "SELECT robot, label AS solver, count(*) AS n, sum(status = 'ok') AS solved,
  printf('%.3f', 500 * avg(seconds)) AS mean_ms, 'pytracik 0.0.3' AS program, '$machine' AS machine,
  date('now') AS day FROM current_solves GROUP BY robot" | tr -d '\r' >$out/programs.csv

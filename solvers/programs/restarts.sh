#!/usr/bin/env bash
# restarts.sh [LIBRARY...]: after how many steps should a library begin again? The same six numbers for each library of
# libraries.toml whose steps the program counts, and for LM: on 200 poses an arm of two seeds, not the page's, and along another
# circle. Prints all tries. A number is worse than the one that solves most if it solves fewer with both seeds, or loses a pose
# of the circle; the fastest of the others is chosen. They are as good as that, unless with both seeds they take 5 % longer. The
# programs' defaults are chosen so. IKBENCH and OUT (out/restarts) as for libraries.sh.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")") out=${OUT:-out/restarts} numbers=10,15,30,60,200,400
libraries=("$@")
(($#)) || libraries=("KDL LMA" "KDL Newton" DART Klampt Pinocchio Pink mink PlaCo Drake PyBullet k LM)
asked=(--only "$(IFS=,; echo "${libraries[*]}")" --set rounds=1 --no-report --out "$out")
for library in "${libraries[@]}"; do
  [[ $library == LM ]] && option=search_iterations || option=steps
  asked+=(--sweep "$library.$option=$numbers")
done
for seed in 2 3; do
  for arm in franka_panda kuka_iiwa14 ur5e; do
    "${IKBENCH:-ikbench}" run "$here/libraries.toml" --robot $arm --set seed=$seed --set name=restarts-$arm-$seed "${asked[@]}"
  done
done
"${IKBENCH:-ikbench}" run "$here/libraries.toml" --set seed=2 --set name=circle --set start=previous --set runs=1 \
  --set path.points=100 --set 'initial_deg=[0,56.43,0,-71.67,0,128.1,45]' --set path.kind=circle \
  --set 'path.centre_cm=[50,0,17]' --set path.radius_cm=24 --set path.tool=down --set path.tool_yaw_deg=135 "${asked[@]}"
sqlite3 -readonly -header -markdown "$out/store.sqlite" <"$here/restarts.sql"

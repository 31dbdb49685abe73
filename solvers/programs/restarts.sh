#!/usr/bin/env bash
# restarts.sh: after how many steps should a library begin again? The same five numbers for each library of libraries.toml
# that searches from a start, and for LM: on 40 poses an arm, of another seed than the page's, and along another circle.
# Prints all tries, and chosen: among those that do not jump on the circle (joints move at most 5 % more than by the
# library's stillest number) and solve it, the one that solves most poses, then the fastest. The programs' defaults are
# these. IKBENCH and OUT (out/restarts) as for libraries.sh.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")") out=${OUT:-out/restarts} numbers=10,15,30,60,200
libraries=("KDL LMA" "KDL Newton" DART Klampt Pinocchio Pink mink PlaCo Drake PyBullet k)
asked=(--only "LM,$(IFS=,; echo "${libraries[*]}")" --sweep "LM.search_iterations=$numbers" --set seed=2 --no-report --out "$out")
for library in "${libraries[@]}"; do asked+=(--sweep "$library.steps=$numbers"); done
for arm in franka_panda kuka_iiwa14 ur5e; do
  "${IKBENCH:-ikbench}" run "$here/libraries.toml" --robot $arm --set name=restarts-$arm --set runs=40 "${asked[@]}"
done
"${IKBENCH:-ikbench}" run "$here/libraries.toml" --set name=circle --set start=previous --set runs=1 --set path.points=100 \
  --set 'initial_deg=[0,56.43,0,-71.67,0,128.1,45]' --set path.kind=circle --set 'path.centre_cm=[50,0,17]' \
  --set path.radius_cm=24 --set path.tool=down --set path.tool_yaw_deg=135 "${asked[@]}"
sqlite3 -readonly -header -markdown "$out/store.sqlite" "WITH tries AS (
    SELECT label, substr(label, 1, instr(label, '=') - 1) AS library, cast(substr(label, instr(label, '=') + 1) AS int) AS steps,
      sum(study <> 'circle' AND status = 'ok') AS solved, sum(study = 'circle' AND status <> 'ok') AS lost,
      1000 * avg(iif(study <> 'circle', iif(seconds <> wall_seconds, seconds, cpu_seconds), NULL)) AS ms,
      avg(iif(study = 'circle' AND point > 0, variation_deg, NULL)) AS motion
    FROM current_solves GROUP BY label),
  ranked AS (SELECT *, row_number() OVER (PARTITION BY library ORDER BY lost > 0 OR
    motion > 1.05 * least, solved DESC, ms) AS place FROM
    (SELECT *, min(motion) OVER (PARTITION BY library) AS least FROM tries))
  SELECT label, solved || ' of 120' AS solved, printf('%.3g', ms) AS 'mean, ms', printf('%.3g', motion) AS 'circle, deg',
    100 - lost || ' of 100' AS 'of the circle', iif(place = 1, 'chosen', '') AS '' FROM ranked ORDER BY library, steps"

#!/bin/sh
# joint-limits.sh [ARM...]: what clamping costs Levenberg-Marquardt and damped least squares on these arms (all of the library).
set -e
[ $# -gt 0 ] || set -- $(ikbench list robots | sed -n 's/^\([a-z]\S*\).*/\1/p')
for arm; do
  ikbench run --robot "$arm" --only LM,DLS --sweep LM.damping=1,0.1 --sweep LM.bounds=clamp,free \
    --sweep DLS.bounds=clamp,free --no-report --out out/joint-limits
done
sqlite3 -readonly -header -csv out/joint-limits/store.sqlite "WITH solves AS (SELECT label, evaluations, status = 'ok' AS ok,
    percent_rank() OVER (PARTITION BY label ORDER BY evaluations) AS place FROM current_solves)
  SELECT label, count(*) AS poses, sum(ok) AS solved, round(100.0 * sum(ok AND evaluations <= 300) / count(*), 1) AS within_300,
    min(iif(place >= 0.5, evaluations, NULL)) AS median, round(avg(evaluations), 1) AS mean FROM solves GROUP BY label"

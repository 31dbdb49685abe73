-- After how many steps to begin again: of the store of restarts.sh each try, what it solves and takes, and how it stands to the
-- chosen one of its library.
WITH tries AS (
  SELECT label, substr(label, 1, instr(label, '=') - 1) AS library, cast(substr(label, instr(label, '=') + 1) AS int) AS steps,
    study LIKE '%-3' AS seed, study = 'circle' AS is_circle, sum(status = 'ok') AS solved, count(*) AS poses,
    1000 * avg(iif(seconds <> wall_seconds, seconds, cpu_seconds)) AS ms
  FROM current_solves GROUP BY label, is_circle, seed),
whole AS (
  SELECT label, library, steps, sum(iif(is_circle, 0, solved)) AS solved, sum(iif(is_circle, 0, poses)) AS poses,
    avg(iif(is_circle, NULL, ms)) AS ms, sum(iif(is_circle, poses - solved, 0)) AS lost
  FROM tries GROUP BY label),
bests AS (SELECT *, first_value(label) OVER (PARTITION BY library ORDER BY lost > 0, solved DESC, ms) AS best FROM whole),
beside_best AS (
  SELECT w.*, w.lost > b.lost OR sum(a.solved < c.solved) = count(*) AS is_worse
  FROM bests AS w JOIN whole AS b ON b.label = w.best JOIN tries AS a ON a.label = w.label
    JOIN tries AS c ON c.label = w.best AND c.seed = a.seed AND NOT a.is_circle AND NOT c.is_circle
  WHERE w.label <> w.best GROUP BY w.label
  UNION ALL SELECT *, 0 FROM bests WHERE label = best),
chosen AS (SELECT *, first_value(label) OVER (PARTITION BY library ORDER BY is_worse, ms) AS chosen FROM beside_best)
SELECT label, solved || ' of ' || poses AS solved, printf('%.3g', ms) AS "mean, ms", lost AS "lost on the circle",
  CASE WHEN label = chosen THEN 'chosen'
    WHEN is_worse OR NOT EXISTS (SELECT * FROM tries AS a JOIN tries AS c USING (seed, is_circle)
      WHERE NOT is_circle AND a.label = chosen.label AND c.label = chosen AND a.ms < 1.05 * c.ms) THEN 'worse'
    ELSE 'as good' END AS ""
FROM chosen ORDER BY library, steps;

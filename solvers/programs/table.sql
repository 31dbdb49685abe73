-- Of each arm and library: poses solved, and percentiles of the time of its answers to all poses, solved or not [ms].
-- The time of a program is its own word; of a built-in solver the processor time of its thread.
WITH answers AS (
  SELECT robot, label, status, variation_deg, coalesce(claimed_seconds, cpu_seconds) AS seconds,
    percent_rank() OVER (PARTITION BY robot, label ORDER BY coalesce(claimed_seconds, cpu_seconds)) AS place
  FROM current_solves WHERE status <> 'declined'),
declined AS (
  SELECT DISTINCT robot, label FROM current_solves WHERE status = 'declined'),
numbers AS (
  SELECT robot, label, sum(status = 'ok') AS solved, count(*) AS poses,
    min(iif(place >= 0.5, seconds, NULL)) AS median, min(iif(place >= 0.95, seconds, NULL)) AS p95,
    min(iif(place >= 0.99, seconds, NULL)) AS p99
  FROM answers GROUP BY robot, label),
lines AS (
  SELECT robot, label, solved, poses, median, p95, p99,
    median / min(iif(solved = poses, median, NULL)) OVER (PARTITION BY robot) AS by_fastest FROM numbers)
SELECT robot, label, iif(solved IS NULL, 'refuses', solved || ' of ' || poses) AS solved,
  iif(solved IS NULL, '', printf('%.3g', 1000 * median)) AS "median, ms",
  iif(solved IS NULL, '', printf('%.3g', 1000 * p95)) AS "95 %",
  iif(solved IS NULL, '', printf('%.3g', 1000 * p99)) AS "99 %",
  iif(solved IS NULL, '', printf('%.1f', by_fastest)) AS "x fastest",
  (SELECT iif(count(*) > 0, printf('%.0f', avg(variation_deg)), '') FROM answers WHERE answers.robot = lines.robot
    AND answers.label = lines.label AND status = 'ok') AS "joint motion, deg"
FROM (
  SELECT * FROM lines UNION ALL SELECT robot, label, NULL, NULL, NULL, NULL, NULL, NULL FROM declined) AS lines
ORDER BY robot, lines.solved IS NULL, lines.solved < lines.poses, lines.median;

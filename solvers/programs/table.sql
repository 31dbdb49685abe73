-- Of each study and library: poses solved, and percentiles of the time of its answers to all poses, solved or not [ms].
-- The time of a program is its own word; of a built-in solver the processor time of its thread.
WITH answers AS (
  SELECT study, label, status, variation_deg, coalesce(claimed_seconds, cpu_seconds) AS seconds,
    percent_rank() OVER (PARTITION BY study, label ORDER BY coalesce(claimed_seconds, cpu_seconds)) AS place
  FROM current_solves WHERE status <> 'declined'),
numbers AS (
  SELECT study, label, sum(status = 'ok') AS solved, count(*) AS poses, min(iif(place >= 0.5, seconds, NULL)) AS median,
    min(iif(place >= 0.95, seconds, NULL)) AS p95, min(iif(place >= 0.99, seconds, NULL)) AS p99,
    avg(iif(status = 'ok', variation_deg, NULL)) AS motion
  FROM answers GROUP BY study, label)
SELECT * FROM (
  SELECT study, label, solved || ' of ' || poses AS solved, printf('%.3g', 1000 * median) AS "median, ms",
    printf('%.3g', 1000 * p95) AS "95 %", printf('%.3g', 1000 * p99) AS "99 %",
    printf('%.3g', median / max(iif(label = 'LM', median, NULL)) OVER (PARTITION BY study)) AS "x LM",
    iif(solved > 0, printf('%.3g', motion), '') AS "joint motion, deg"
  FROM numbers ORDER BY study, solved < poses, median)
UNION ALL SELECT DISTINCT study, label, 'declines', '', '', '', '', '' FROM current_solves
  WHERE status = 'declined' AND (study, label) NOT IN (SELECT study, label FROM numbers);

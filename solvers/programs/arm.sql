-- Who solves an arm of a file, and how fast: of each library the poses solved when asked once and again (-warm), and the median
-- time of its answers [ms] as in times.sql. Of the arm of this name, which libraries.sh gives.
WITH asked AS (
  SELECT label || iif(study LIKE 'libraries-cpp-%', ' (C++)', '') AS library, study LIKE '%-warm' AS again, status,
    status IN ('crashed', 'protocol_error') AS failed, 1000 * iif(seconds <> wall_seconds, seconds, cpu_seconds) AS ms
  FROM current_solves WHERE study IN ('libraries-' || :arm, 'libraries-' || :arm || '-warm', 'libraries-cpp-' || :arm,
    'libraries-cpp-' || :arm || '-warm') AND status <> 'declined'),
placed AS (SELECT *, percent_rank() OVER (PARTITION BY library, again, failed ORDER BY ms) AS place FROM asked),
counts AS (
  SELECT library, again, sum(status = 'ok') || iif(sum(failed), ' (' || sum(failed) || ' failed)', '') AS solved, count(*) AS poses,
    min(ms) FILTER (WHERE place >= 0.5 AND NOT failed) AS half, min(ms) FILTER (WHERE place >= 0.95 AND NOT failed) AS most
  FROM placed GROUP BY library, again)
SELECT library, once.solved || ' of ' || once.poses AS solved, warm.solved AS again,
  iif(warm.most, printf('%.2g (%.2g)', warm.half, warm.most), '-') AS ms, iif(once.half, printf('%.2g', once.half), '-') AS first
FROM counts AS once JOIN counts AS warm USING (library)
WHERE NOT once.again AND warm.again AND library NOT IN ('LM (C++)', 'nothing', 'nothing (C++)')
ORDER BY once.solved + 0 DESC, warm.half;

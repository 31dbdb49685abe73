-- How fast: of each library, on three arms, the median time of its answers, solved or not, and in brackets the time within
-- which 95 % of them came [ms] (-: it declines the arm). Of one study file (libraries, libraries-cpp) and state (first, hot),
-- which libraries.sh gives. The time of a program is its own word; of a built-in solver the processor time of its thread.
WITH placed AS (
  SELECT robot, label, ms, percent_rank() OVER (PARTITION BY robot, label ORDER BY ms) AS place FROM (
    SELECT s.robot, label, 1000 * coalesce(claimed_seconds, cpu_seconds) AS ms FROM current_solves AS s
    JOIN studies ON studies.name = s.study AND json_extract(definition, '$.state') = :state
    AND studies.name LIKE :study || '-' || s.robot || '%' WHERE status <> 'declined')),
times AS (
  SELECT robot, label, min(iif(place >= 0.5, ms, NULL)) AS half, min(iif(place >= 0.95, ms, NULL)) AS most
  FROM placed GROUP BY robot, label),
cells AS (SELECT robot, label, half, printf('%.2g (%.2g)', half, most) AS cell FROM times)
SELECT l.label AS library, coalesce(p.cell, '-') AS Panda, coalesce(i.cell, '-') AS "iiwa 14", coalesce(u.cell, '-') AS UR5e
FROM (SELECT DISTINCT label FROM times) AS l
LEFT JOIN cells AS p ON p.label = l.label AND p.robot = 'franka_panda'
LEFT JOIN cells AS i ON i.label = l.label AND i.robot = 'kuka_iiwa14'
LEFT JOIN cells AS u ON u.label = l.label AND u.robot = 'ur5e'
ORDER BY coalesce(p.half, u.half);

-- How fast: of each library, on three arms, the median time of its answers, solved or not, [ms] (-: it declines the arm, or its
-- program fails): of second calls, and in brackets the time within which 95 % of them came; of first ones. Of one study file
-- (libraries, libraries-cpp), which libraries.sh gives. The time of a program is its own word; of a built-in solver the
-- processor time of its thread. LM stands beside programs in C++ only.
WITH placed AS (
  SELECT robot, label, state, ms, percent_rank() OVER (PARTITION BY robot, label, state ORDER BY ms) AS place FROM (
    SELECT s.robot, label, json_extract(definition, '$.state') AS state, 1000 * iif(seconds <> wall_seconds, seconds, cpu_seconds) AS ms
    FROM current_solves AS s JOIN studies ON studies.name = s.study
    AND studies.name LIKE :study || '-' || s.robot || '%' WHERE status NOT IN ('declined', 'crashed', 'protocol_error')
      AND NOT (:study = 'libraries' AND label = 'LM'))),
cells AS (
  SELECT robot || ' ' || state AS called, label, min(iif(place >= 0.5, ms, NULL)) AS half, printf(iif(state = 'warm', '%.2g (%.2g)', '%.2g'),
    min(iif(place >= 0.5, ms, NULL)), min(iif(place >= 0.95, ms, NULL))) AS cell
  FROM placed GROUP BY robot, label, state)
SELECT label AS library, coalesce(max(cell) FILTER (WHERE called = 'franka_panda warm'), '-') AS Panda,
  coalesce(max(cell) FILTER (WHERE called = 'kuka_iiwa14 warm'), '-') AS "iiwa 14",
  coalesce(max(cell) FILTER (WHERE called = 'ur5e warm'), '-') AS UR5e,
  coalesce(max(cell) FILTER (WHERE called = 'franka_panda first'), '-') AS "Panda, first",
  coalesce(max(cell) FILTER (WHERE called = 'kuka_iiwa14 first'), '-') AS "iiwa 14, first",
  coalesce(max(cell) FILTER (WHERE called = 'ur5e first'), '-') AS "UR5e, first"
FROM cells GROUP BY label
ORDER BY coalesce(max(half) FILTER (WHERE called = 'franka_panda warm'), max(half) FILTER (WHERE called = 'ur5e warm'), max(half));

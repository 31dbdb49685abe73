-- Who solves: of each library the poses solved of 200 on three arms (-: it declines the arm; in brackets the calls in which its
-- program failed, as it does with a version of the library that it does not know), of these 600 when asked once and
-- again (-warm), and on how many arms it solves the first 20 poses, of those that it does not decline. From one store
-- (libraries.sh).
WITH arms AS (
  SELECT robot, label, study LIKE '%-warm' AS again, sum(status = 'ok') AS solved, sum(status = 'declined') = count(*) AS declines,
    sum(status IN ('crashed', 'protocol_error')) AS failed,
    sum(status = 'ok' AND run <= 20) = min(count(*), 20) AS is_whole,
    robot IN ('franka_panda', 'kuka_iiwa14', 'ur5e') AS is_shown
  FROM current_solves WHERE study IN ('libraries-' || robot, 'libraries-' || robot || '-warm') AND label <> 'nothing'
  GROUP BY study, robot, label),
shown AS (SELECT robot, label, iif(declines, '-', solved || iif(failed, ' (' || failed || ' failed)', '')) AS solved FROM arms WHERE NOT again)
SELECT label AS library, (SELECT solved FROM shown WHERE label = a.label AND robot = 'franka_panda') AS Panda,
  (SELECT solved FROM shown WHERE label = a.label AND robot = 'kuka_iiwa14') AS "iiwa 14",
  (SELECT solved FROM shown WHERE label = a.label AND robot = 'ur5e') AS UR5e,
  sum(iif(is_shown AND NOT again, solved, 0)) || ', ' || sum(iif(is_shown AND again, solved, 0)) AS "of 600, twice",
  sum(is_whole AND NOT again) || '/' || sum(NOT declines AND NOT again) AS arms
FROM arms AS a GROUP BY label ORDER BY sum(iif(is_shown, solved, 0)) DESC, sum(is_whole AND NOT again) DESC, label;

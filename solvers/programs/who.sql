-- Who solves: of each library the poses solved of 200 on three arms (-: it declines the arm), and the arms on which it
-- solves the first 20 poses. From one store (libraries.sh).
WITH arms AS (
  SELECT robot, label, sum(status = 'ok') AS solved, sum(status = 'declined') = count(*) AS declines,
    sum(status = 'ok' AND run <= 20) = min(count(*), 20) AS is_whole,
    robot IN ('franka_panda', 'kuka_iiwa14', 'ur5e') AS is_shown
  FROM current_solves WHERE study = 'libraries-' || robot AND label <> 'nothing' GROUP BY robot, label),
shown AS (SELECT robot, label, iif(declines, '-', solved) AS solved FROM arms)
SELECT label AS library, (SELECT solved FROM shown WHERE label = a.label AND robot = 'franka_panda') AS Panda,
  (SELECT solved FROM shown WHERE label = a.label AND robot = 'kuka_iiwa14') AS "iiwa 14",
  (SELECT solved FROM shown WHERE label = a.label AND robot = 'ur5e') AS UR5e, sum(iif(is_shown, solved, 0)) AS "of 600",
  sum(is_whole) AS "whole arms", sum(declines) AS declines
FROM arms AS a GROUP BY label ORDER BY sum(iif(is_shown, solved, 0)) DESC, sum(is_whole) DESC, label;

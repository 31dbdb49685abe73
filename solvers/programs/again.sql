-- Which libraries give another answer when asked again: of each study and library how many poses, of those that it solved
-- both times, have another answer in AGAIN, a second store of the same studies (libraries.sh with OUT=AGAIN's folder):
--   sqlite3 -cmd "ATTACH 'out/again/store.sqlite' AS again" out/libraries/store.sqlite <again.sql
SELECT study, label, sum(a.answer_rad <> b.answer_rad) AS "answered otherwise", count(*) AS "solved twice"
FROM main.current_solves AS a JOIN again.current_solves AS b USING (study, label, run, point)
WHERE a.status = 'ok' AND b.status = 'ok' GROUP BY study, label HAVING sum(a.answer_rad <> b.answer_rad) > 0;

-- Which libraries give another answer when asked again: of each study and library how many poses, of those that it solved in
-- both states (libraries.sh), have another answer.
SELECT a.study, label, sum(a.answer_rad <> b.answer_rad) AS "answered otherwise", count(*) AS "solved twice"
FROM current_solves AS a JOIN current_solves AS b USING (label, run, point)
WHERE b.study = a.study || '-warm' AND a.status = 'ok' AND b.status = 'ok'
GROUP BY a.study, label HAVING sum(a.answer_rad <> b.answer_rad) > 0;

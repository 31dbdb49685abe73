#!/usr/bin/env bash
# What stands beside a study without being solved: the archive of libraries, another store; and what reads a store of
# libraries. How it is judged: imported.test.cpp.
source "$(dirname "$0")/common.sh"
study mine

# The archive's study is solved, whatever the file asks, with its solvers and LM, and nothing of the archive is stored.
beside=(run mine.toml --robot ur5e --set runs=20 --figures none --beside)
succeeds "${beside[@]}" libraries --out panda
has "$out" "another machine"
equal "what was solved" "$(sqlite3 panda/store.sqlite 'SELECT group_concat(DISTINCT label) FROM current_solves')" "DLS,ikbench's LM"
json '[each["verdict"] for each in of["comparisons"] if {"DLS", "EAIK"} == {each["first"], each["second"]} and each["metric"] == "targets solved"] != ["not_tested"]' panda/results.json
json 'all(each["verdict"] == "not_tested" for each in of["comparisons"] if "EAIK" in (each["first"], each["second"]) and each["metric"].startswith("time"))' panda/results.json
[[ $out == *1x* && $out != *" ratio"* ]] || fail "ratios of times without their sign: $out"
grep -q '^EAIK,' panda/tables/beside.csv || fail "no multiples of EAIK"
succeeds report panda/store.sqlite --beside libraries --out again --figures none
cmp panda/tables/results.csv again/tables/results.csv || fail "another report of the same"
refused "seed is 1 and 2" "${beside[@]}" libraries --set seed=2
refused kuka_iiwa14 run mine.toml --robot puma560 --beside libraries

# A store of the same study, its own solvers with another name.
succeeds run mine.toml --out there --no-report
succeeds run mine.toml --out here --beside there/store.sqlite --figures none
has "$out" "DLS (there)"
refused "seed is 1 and 2" run mine.toml --set seed=2 --beside there/store.sqlite

# Who solves, whose program fails, and who answers otherwise when asked again.
sqlite3 store.sqlite <<'END'
CREATE TABLE said (robot, label, run, status, once, again);
INSERT INTO said VALUES
  ('ur5e', 'A', 1, 'ok', '[1]', '[1]'),
  ('ur5e', 'A', 2, 'tolerance_missed', '[1]', '[2]'),
  ('ur5e', 'B', 1, 'ok', '[1]', '[2]'),
  ('ur5e', 'B', 2, 'ok', '[1]', '[1]'),
  ('ur5e', 'C', 1, 'crashed', '[1]', '[1]'),
  ('puma560', 'A', 1, 'declined', '[1]', '[1]'),
  ('puma560', 'B', 1, 'ok', '[1]', '[1]'),
  ('ur5e', 'nothing', 1, 'ok', '[1]', '[1]');
CREATE VIEW current_solves AS
  SELECT 'libraries-' || robot AS study, *, 1 AS point, once AS answer_rad, run / 1e3 AS seconds, 1 AS wall_seconds,
    1 AS cpu_seconds FROM said
  UNION SELECT 'libraries-' || robot || '-warm', *, 1, again, run / 1e3, 1, 1 FROM said;
END
equal "who solves" "$(sqlite3 store.sqlite <"$root/solvers/programs/who.sql" | paste -sd' ')" \
  "B|||2|2, 2|2/2 A|||1|1, 1|0/1 C|||0 (1 failed)|0, 0|0/1"
equal "who answers otherwise" "$(sqlite3 store.sqlite <"$root/solvers/programs/again.sql")" "libraries-ur5e|B|1|2"
equal "who solves an arm of a file" \
  "$(sqlite3 -cmd ".parameter set :arm ur5e" store.sqlite <"$root/solvers/programs/arm.sql" | paste -sd' ')" \
  "B|2 of 2|2|2 (2)|2 A|1 of 2|1|2 (2)|2 C|0 (1 failed) of 1|0 (1 failed)|-|-"

# After how many steps to begin again: fewer solved with one seed are chance, with both they are not; a pose of the circle is not
# lost; times count if they differ with both seeds.
sqlite3 tries.sqlite <<'END'
CREATE TABLE current_solves (study, label, status, seconds, wall_seconds, cpu_seconds);
CREATE TABLE tries (label, study, solved, seconds);
INSERT INTO tries VALUES
  ('A steps=1', 's-2', 3, 1), ('A steps=1', 's-3', 2, 1), ('A steps=1', 'circle', 3, 1),
  ('A steps=2', 's-2', 2, 2), ('A steps=2', 's-3', 4, 2), ('A steps=2', 'circle', 4, 2),
  ('A steps=3', 's-2', 4, 2), ('A steps=3', 's-3', 4, 2.2), ('A steps=3', 'circle', 4, 2),
  ('A steps=4', 's-2', 4, 2.2), ('A steps=4', 's-3', 4, 1.9), ('A steps=4', 'circle', 4, 2),
  ('A steps=5', 's-2', 4, 3), ('A steps=5', 's-3', 4, 3), ('A steps=5', 'circle', 4, 3),
  ('A steps=6', 's-2', 4, 1), ('A steps=6', 's-3', 4, 1), ('A steps=6', 'circle', 3, 1);
INSERT INTO current_solves SELECT study, label, iif(value < solved, 'ok', 'tolerance_missed'), seconds, 9, 9
  FROM tries, (SELECT 0 AS value UNION SELECT 1 UNION SELECT 2 UNION SELECT 3);
END
equal "how many steps" "$(sqlite3 tries.sqlite <"$root/solvers/programs/restarts.sql" | cut -d'|' -f1,2,5 | paste -sd' ')" \
  "A steps=1|5 of 8|worse A steps=2|6 of 8|chosen A steps=3|8 of 8|as good A steps=4|8 of 8|as good A steps=5|8 of 8|worse A steps=6|8 of 8|worse"

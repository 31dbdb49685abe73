#!/usr/bin/env bash
# Every study of the paper: one command, one store, one report.
source "$(dirname "$0")/common.sh"

succeeds reproduce --runs 2 --jobs 2 --readings 1 --no-figures --out paper
quiet
has "$out" "slim2023: 240 solves"        # 6 solvers x 2 runs x 20 points
has "$out" "slim2023-context: 80 solves" # 2 solvers
has "$out" "slim2023-limits: 240 solves"
has "$out" "slim2023-time: 80 solves"    # 4 sizes of the population x 20 targets
has "$out" "slim2023-dobot: 20 solves"
# Each estimand has its own winner, in the first words of the page and among the terminal's.
for words in "Smallest mean error (its worst cases): IK-BA" "Smallest typical error: PSO" "Most often within 0.01 cm: IK-BA"; do
  has "$out" "$words"
  has "$(grep '<p class="answer">' paper/report.html)" "$words"
done
for table in table-3 table-4 table-5 table-6 table-7 table-8 limits audit readings baselines; do
  [ -s "paper/tables/$table.md" ] || fail "there is no table $table"
  has "$(<paper/report.html)" "id=\"$table\""
done
[ "$(tail -n 1 .out)" = "Report: paper/report.html" ] || fail "the last line is: $(tail -n 1 .out)"
for label in IK-BA BA DE PSO K-ABC MO-PSO; do
  has "$(<paper/tables/table-3.md)" "$label"
done
succeeds report paper/store.sqlite --study slim2023-context --no-figures --out context
has "$(<context/tables/results.md)" "DLS"

# It is the built-in study, and goes on from what is there.
succeeds run slim2023 --set runs=2 --no-report --out paper
has "$out" "(240 were already stored)"

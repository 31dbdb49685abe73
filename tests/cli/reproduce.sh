#!/usr/bin/env bash
# The paper's study and its context: one command, one store, one report.
source "$(dirname "$0")/common.sh"

succeeds reproduce --runs 2 --jobs 2 --no-figures --out paper
quiet
has "$out" "slim2023: 240 solves"        # 6 solvers x 2 runs x 20 points
has "$out" "slim2023-context: 80 solves" # 2 solvers
[ "$(tail -n 1 .out)" = "Report: paper/report.html" ] || fail "the last line is: $(tail -n 1 .out)"
for label in IK-BA BA DE PSO K-ABC MO-PSO; do
  has "$(<paper/tables/table-3.md)" "$label"
done
succeeds report paper/store.sqlite --study slim2023-context --no-figures --out context
has "$(<context/tables/table-3.md)" "DLS"

# It is the built-in study, and goes on from what is there.
succeeds run slim2023 --set runs=2 --no-report --out paper
has "$out" "(240 were there already)"

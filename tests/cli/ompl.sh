#!/usr/bin/env bash
# OMPL's own script makes of the exported log the database that is exported, table by table.
source "$(dirname "$0")/common.sh"

succeeds run slim2023 "${small[@]}" --set trace=best_error --no-report --out made
succeeds export made/store.sqlite --format ompl -o ours.db
succeeds export made/store.sqlite --format ompl-log -o benchmark.log
refused 'expected -o benchmark.db' export made/store.sqlite --format ompl

script=$(command -v ompl_benchmark_statistics) || { echo "skipped: no ompl_benchmark_statistics (Debian's ompl-demos)"; exit 77; }
python3 "$script" -d theirs.db benchmark.log >.log 2>&1 || fail "OMPL's script: $(<.log)"
python3 - <<'PYTHON' || fail "OMPL's script makes another database"
import sqlite3

ours, theirs = sqlite3.connect("ours.db"), sqlite3.connect("theirs.db")
for table in ("experiments", "plannerConfigs", "enums", "runs", "progress"):
    columns = [[row[1:] for row in db.execute(f"PRAGMA table_info({table})")] for db in (ours, theirs)]
    assert columns[0] == columns[1], (table, columns)
    rows = [db.execute(f"SELECT * FROM {table}").fetchall() for db in (ours, theirs)]
    assert rows[0] == rows[1] and rows[0], (table, rows)
for view in ("bestPlannerConfigsPerExperiment", "bestPlannerConfigs"):
    rows = [db.execute(f"SELECT * FROM {view}").fetchall() for db in (ours, theirs)]
    assert rows[0] == rows[1] and rows[0], (view, rows)
assert ours.execute("SELECT count(*) FROM runs").fetchone() == (36,)
assert ours.execute("SELECT count(*) FROM progress").fetchone() == (180,)
PYTHON

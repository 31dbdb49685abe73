#!/usr/bin/env bash
# A report keeps a hundred bytes per solve and not the record, for any number of solves.
source "$(dirname "$0")/common.sh"
command -v python3 >/dev/null || { echo "SKIPPED: no python3"; exit 77; }

succeeds run slim2023 "${small[@]}" --no-report --out few
mkdir many
python3 - <<'PYTHON' || fail "the runs cannot be copied"
import json, shutil, sqlite3

shutil.copy("few/store.sqlite", "many/store.sqlite")
runs = 1000
with sqlite3.connect("many/store.sqlite") as store:
    columns = ", ".join("run + ?" if row[1] == "run" else row[1] for row in store.execute("pragma table_info(solves)"))
    for more in range(2, runs, 2):
        store.execute(f"insert into solves select {columns} from solves where run <= 2", (more,))
    for name, text in store.execute("select name, definition from studies").fetchall():
        definition = json.dumps({**json.loads(text), "runs": runs})
        store.execute("update studies set definition = ? where name = ?", (definition, name))
PYTHON
[ "$(solves many/store.sqlite)" = 18000 ] || fail "$(solves many/store.sqlite) solves, expected 18000"

# Measures the largest resident set [kB].
python3 - "$program" <<'PYTHON' || fail "a report needs too much memory"
import resource, subprocess, sys

def peak(folder):
    subprocess.run([sys.argv[1], "report", f"{folder}/store.sqlite", "--no-figures"], check=True, stdout=subprocess.DEVNULL)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss

few, many = peak("few"), peak("many")
per_solve = (many - few) * 1024 / (18000 - 36)
print(f"{few} kB with 36 solves, {many} kB with 18000: {per_solve:.0f} bytes a solve")
# 112 bytes, as much again where times of solvers are left out, as on a loaded machine, and the 8 MB of a thousand
# replicates of the bootstrap, however many solves there are: 444 bytes of each of these.
sys.exit(per_solve > 700)
PYTHON
[ "$(wc -l <many/solves.csv)" = 18001 ] || fail "solves.csv has not all solves"
echo "a report keeps little of each solve"

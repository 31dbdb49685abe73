#!/usr/bin/env bash
# The export for IOHprofiler follows the rules by which IOHanalyzer 0.1.8.11 and IOHinspector read a folder.
source "$(dirname "$0")/common.sh"

succeeds run slim2023 "${small[@]}" --set trace=best_error --no-report --out made
succeeds export made/store.sqlite --format iohprofiler -o ioh
[ -z "$err" ] || fail "a solver of the paper is left out: $err"
refused 'expected -o FOLDER' export made/store.sqlite --format iohprofiler
refused 'is not an empty folder' export made/store.sqlite --format iohprofiler -o ioh
succeeds run slim2023 "${small[@]}" --no-report --out untraced
refused 'expected trace = "best_error"' export untraced/store.sqlite --format iohprofiler -o none
[ ! -e none ] || fail "a folder without anything in it"

# A course that nobody has run is damage, for the export too.
cp -r made harmed
sqlite3 harmed/store.sqlite "UPDATE solves SET improved_at = '[1e308,null,-3]', improved_to_cm = '[1,2,3]' WHERE run = 2 AND point = 1"
refused "the course of run 2, point 1 by 'IK-BA' is damaged" export harmed/store.sqlite --format iohprofiler -o none

# A library's one call has a row wherever its error became smaller.
study peer $'[[solvers]]\nsolver = "nlopt"'
run_it run peer.toml --set trace=best_error --no-report --out peer
if [ "$code" = 0 ]; then
  succeeds export peer/store.sqlite --format iohprofiler -o peer/ioh
  [ -z "$err" ] || fail "nlopt is left out: $err"
  for file in peer/ioh/nlopt/data_*/*.dat; do
    [ "$(wc -l <"$file")" -gt 8 ] || fail "no more than start and end of two runs in $file: $(<"$file")"
  done
else
  has "$err" "not built: apt-get install"
  echo "left out: nlopt is not built"
fi

command -v python3 >/dev/null || { echo "skipped: no python3"; exit 77; }
succeeds export made/store.sqlite --format json -o solves.json
python3 - <<'PYTHON' || fail "IOHprofiler's readers would not read it"
import json, os, re

solves = {(s["solver"], s["point"], s["run"]): s for s in json.load(open("solves.json"))["solves"]}
seen, files, plain = set(), set(), re.compile(r"[A-Za-z0-9_-]+(\.json|\.dat)?")
required = ["version", "suite", "function_id", "function_name", "maximization", "algorithm", "attributes", "scenarios"]
for folder, _, names in os.walk("ioh"):
    for name in names:
        assert plain.fullmatch(name) and plain.fullmatch(os.path.basename(folder)), name  # 7
        files.add(os.path.join(folder, name))
for file in sorted(f for f in files if f.endswith(".json")):
    head = json.load(open(file))
    assert all(key in head for key in required), head.keys()
    assert tuple(map(int, head["version"].split("."))) >= (0, 3, 3) and head["maximization"] is False  # 8
    assert head["experiment_attributes"] == head["run_attributes"] == []  # 3, 4
    assert head["attributes"] == ["evaluations", "raw_y"] and set(head["algorithm"]) == {"name", "info"}
    assert 0 < head["function_id"] < 65536  # 6
    assert os.path.basename(file) == "IOHprofiler_f%d_%s.json" % (head["function_id"], head["function_name"])
    for scenario in head["scenarios"]:
        data = os.path.join(os.path.dirname(file), scenario["path"])
        files.remove(data)
        blocks = open(data).read().split("evaluations raw_y\n")
        assert blocks[0] == "" and len(blocks) == len(scenario["runs"]) + 1 and scenario["dimension"] == 4
        for run, block in zip(scenario["runs"], blocks[1:]):
            assert set(run) == {"instance", "evals", "best"} and set(run["best"]) == {"evals", "y", "x"}  # 2
            rows = [line.split(" ") for line in block.splitlines()]
            evaluations, errors = [int(row[0]) for row in rows], [float(row[1]) for row in rows]
            solve = solves[head["algorithm"]["name"], head["function_id"], run["instance"]]
            key = (head["algorithm"]["name"], head["function_id"], scenario["dimension"], run["instance"])
            assert key not in seen  # 8
            seen.add(key)
            assert evaluations[0] == 1 and evaluations.count(1) == 1  # 1
            assert evaluations == sorted(set(evaluations)) and evaluations[-1] == run["evals"] == solve["evaluations"]
            assert all(a > b for a, b in zip(errors, errors[1:-1]))
            assert len(rows) == 1 or errors[-1] <= errors[-2]
            assert errors[-1] == min(errors) == run["best"]["y"] == solve["trace_cm"][-1]  # 5: every digit
            assert evaluations[errors.index(min(errors))] == run["best"]["evals"] and len(run["best"]["x"]) == 4
            assert set(errors[2:]) <= set(solve["trace_cm"])
assert len(seen) == len(solves) == 36
assert all(f.endswith(".json") for f in files), files  # every other file is named by one of them
PYTHON

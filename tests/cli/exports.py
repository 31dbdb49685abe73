# The CSV and the store say the same, to every digit; the folder follows the rules by which IOHanalyzer 0.1.8.11 and
# IOHinspector read it, numbered as in the specification of their format.
import csv, json, os, re, sqlite3

store = sqlite3.connect("made/store.sqlite")
store.row_factory = sqlite3.Row
rows = list(csv.DictReader(open("first.csv", newline="")))
solves = {(solve["label"], solve["point"], solve["run"]): solve
          for solve in store.execute("SELECT * FROM current_solves WHERE study = 'slim2023'")}
assert len(solves) == len(rows) == 36
for row in rows:
    solve = solves[row["label"], int(row["point"]), int(row["run"])]
    for name in ("position_error_cm", "claimed_error_cm", "variation_deg", "seconds"):
        assert solve[name] == float(row[name]), name
    assert json.loads(solve["answer_rad"]) == [float(row[f"answer_rad_{joint}"]) for joint in range(1, 8)]
    assert len(json.loads(solve["trace_cm"])) == solve["iterations"] == 5
    assert abs(solve["position_error_cm"] - solve["claimed_error_cm"]) < 1e-7

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
        path = os.path.join(os.path.dirname(file), scenario["path"])
        files.remove(path)
        blocks = open(path).read().split("evaluations raw_y\n")
        assert blocks[0] == "" and len(blocks) == len(scenario["runs"]) + 1 and scenario["dimension"] == 4
        for run, block in zip(scenario["runs"], blocks[1:]):
            assert set(run) == {"instance", "evals", "best"} and set(run["best"]) == {"evals", "y", "x"}  # 2
            lines = [line.split(" ") for line in block.splitlines()]
            evaluations, errors = [int(line[0]) for line in lines], [float(line[1]) for line in lines]
            key = (head["algorithm"]["name"], head["function_id"], run["instance"])
            solve, trace = solves[key], json.loads(solves[key]["trace_cm"])
            assert key not in seen  # 8
            seen.add(key)
            assert evaluations[0] == 1 and evaluations.count(1) == 1  # 1
            assert evaluations == sorted(set(evaluations)) and evaluations[-1] == run["evals"] == solve["evaluations"]
            assert all(a > b for a, b in zip(errors, errors[1:-1])) and errors[-1] == min(errors)
            assert errors[-1] == run["best"]["y"] == trace[-1]  # 5: every digit
            assert evaluations[errors.index(min(errors))] == run["best"]["evals"] and len(run["best"]["x"]) == 4
            assert set(errors[2:]) <= set(trace)
assert len(seen) == len(solves) == 36
assert all(f.endswith(".json") for f in files), files  # every other file is named by one of them

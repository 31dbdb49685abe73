# The CSV and the store say the same, to every digit.
import csv, json, sqlite3

store = sqlite3.connect("made/store.sqlite")
store.row_factory = sqlite3.Row
rows = list(csv.DictReader(open("first.csv", newline="")))
solves = {(solve["label"], solve["point"], solve["run"]): solve
          for solve in store.execute("SELECT * FROM current_solves WHERE study = 'slim2023'")}
assert len(solves) == len(rows) == 36
for row in rows:
    solve = solves[row["label"], int(row["point"]), int(row["run"])]
    for name in ("position_error_cm", "reported_error_cm", "variation_deg", "seconds"):
        assert solve[name] == float(row[name]), name
    assert json.loads(solve["answer_rad"]) == [float(row[f"answer_rad_{joint}"]) for joint in range(1, 8)]
    assert len(json.loads(solve["trace_cm"])) == solve["iterations"] == 5
    assert abs(solve["position_error_cm"] - solve["reported_error_cm"]) < 1e-7

# names.py STUDY FOLDER <LABELS: export.csv and the tables of FOLDER have the names as they are.
import csv, json, sys
labels = sys.stdin.read().split("\n")[:-1]
rows = list(csv.DictReader(open("export.csv", newline="")))
assert len(rows) == 6 * len(labels), len(rows)
texts = {chr(39) + label if label[0] in "=+-@" else label for label in labels}
assert {row["label"] for row in rows} == texts, {row["label"] for row in rows} ^ texts
assert {row["study"] for row in rows} == {sys.argv[1]}
results = json.load(open(sys.argv[2] + "/results.json"))
assert {row["solver"] for row in results["groups"]} == set(labels)
for name in ("results", "pairs", "descriptives"):
    table = list(csv.reader(open(sys.argv[2] + f"/tables/{name}.csv", newline="")))
    assert len({len(row) for row in table}) == 1, name
    assert not [cell for row in table for cell in row if cell[:1] in tuple("=+@")], name

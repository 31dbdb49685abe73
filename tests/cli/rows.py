# rows.py JSON: a line each group, test and pair, without times, which no machine repeats.
import json, sys
of = json.load(open(sys.argv[1]))
text = lambda x: "-" if x is None or x == "" else f"{x:.4g}" if isinstance(x, float) else str(x).replace(" ", "_")
for label in of.get("worse", [None]):
    keys = {"groups": "metric solver n mean median smallest largest", "tests": "metric test statistic p",
            "comparisons": "metric first second estimate low high p test verdict"}
    for kind, names in keys.items():
        for row in of[kind]:
            if row.get("source", "between") != "between": continue
            if row.get("excluded"): row[row["excluded"]] = {"low": ">", "high": "<"}[row["excluded"]] + text(row[row["excluded"]])
            if not row["metric"].startswith("time") and row.get("label") == label: print(kind[:-1], *(text(row.get(name)) for name in names.split()))
    for kind in ("worse", "inconclusive"):
        if kind in of: print(kind, *map(text, of[kind][label]))

#!/usr/bin/env bash
# On every built-in study `report` and `compare` never contradict each other: where both decide on a pair, they decide
# alike, and what one calls the same the other does not call different beyond the margin. Their families differ (all
# pairs of a quantity against all metrics of one pair), so one may leave open what the other decides. Both read one store,
# so a solve that is timed once proves as much as one that is timed five times, and a budget of 1 ms as much as 5 ms.
source "$(dirname "$0")/common.sh"
command -v python3 >/dev/null || { echo "SKIPPED: no python3"; exit 77; }
names=$("$program" list studies | sed -n '2,$s/^\([a-z][^ ]*\) .*/\1/p')
while read -r study; do
  budget=()
  [[ $study != baselines* ]] || budget=(--set stop.seconds=0.001)
  succeeds run "$study" --set runs=8 --set path.points=3 --set repeats=1 "${budget[@]}" --out "$study" --no-figures
  quiet
  python3 - "$program" "$study" <<'PYTHON' || fail "report and compare contradict each other on $study"
import json, subprocess, sys

program, study = sys.argv[1:]
told = {found["quantity"].replace("penalised ", "").replace("typical computing", "computing"): found
        for found in json.load(open(f"{study}/statistics.json")) if not found["from_summaries"]}
names = {"position_error_cm": "position error [cm]", "variation_deg": "angles variation [deg]", "evaluations": "evaluations",
         "seconds": "computing time [s]", "orientation_error_deg": "orientation error [deg]"}
all_pairs = [(pair["first"], pair["second"]) for pair in told["position error [cm]"]["contrasts"]]
judged = decided = 0
for first, second in all_pairs[:: max(1, len(all_pairs) // 3)]:
    done = subprocess.run([program, "compare", first, second, "--store", f"{study}/store.sqlite", "-o", "compared.json"],
                          capture_output=True, text=True)
    assert done.returncode in (0, 3, 4), done.stderr
    for row in json.load(open("compared.json"))["rows"]:
        quantity = told.get(names.get(row["metric"].split(" ")[0]))
        pairs = [c for c in quantity["contrasts"] if {c["first"], c["second"]} == {first, second}] if quantity else []
        if not pairs:
            continue
        judged += 1
        pair, says = pairs[0], row["B_is"]
        best = {"first is better": pair["first"], "second is better": pair["second"]}.get(pair["relation"])
        compared_best = second if says.startswith("better") else first if says.startswith("worse") else None
        decided += best is not None and compared_best is not None
        assert best is None or compared_best is None or best == compared_best, (row, pair)
        if row["metric"].startswith(("position", "orientation", "variation")) and None not in (row["p"], pair["p_alone"]):
            assert abs(row["p"] - pair["p_alone"]) <= 0.01 + 0.3 * row["p"], (row, pair)  # resamples differ
        assert (says == "cannot be judged") == (pair["relation"] == "not defined"), (row, pair)
        if (row["remark"] or "").startswith("equal bit for bit"):
            assert pair["relation"] == "same within the margin", (row, pair)
        if says.startswith("the same"):
            assert best is None or pair["extent"] != "beyond the margin", (row, pair)
        if pair["relation"] == "same within the margin":
            assert compared_best is None or " more than " not in says, (row, pair)
assert judged > 0 or not all_pairs, "no row of compare has a quantity of the report"
print(f"{study}: {judged} judged twice, {decided} decided, none contradicted")
PYTHON
done <<<"$names"

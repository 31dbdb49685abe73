#!/usr/bin/env bash
# `ikbench store` shows what a store has, and removes from it without harm to the rest.
source "$(dirname "$0")/common.sh"
small=(--set runs=2 --set path.points=2 --set stop.iterations=3 --no-report --out made)
store=made/store.sqlite

succeeds run slim2023 "${small[@]}"
succeeds run slim2023-limits "${small[@]}"
succeeds store ls $store
[ "$(grep -cE '^slim2023(-limits)? +6 +2 +2 +24$' <<<"$out")" = 2 ] || fail "two studies of 24 solves: $out"
has_no "$out" unused
succeeds store show $store --study slim2023-limits
has "$out" "K-ABC"
[ "$(grep -cE '^[A-Z-]+ +[a-z_]+ +4 +[0-9a-f]{16}@' <<<"$out")" = 6 ] || fail "six solvers of 4 solves: $out"
[ "$(sed -n '/^SESSION/,$p' <<<"$out" | wc -l)" = 2 ] || fail "one session: $out"
as_json '[study["solves"] for study in of["studies"]] == [24, 24] and of["studies"][1] == {"study": "slim2023-limits",
  "solvers": 6, "runs": 2, "points": 2, "solves": 24} and of["unused"] == {"solves": 0, "sessions": 0}' store ls $store
as_json 'of["study"] == "slim2023-limits" and len(of["solvers"]) == 6 and of["solvers"][0]["solves"] == 4 and
  len(of["sessions"]) == 1 and of["sessions"][0]["commit"]' store show $store --study slim2023-limits

# What no study uses any more: solves of an earlier setting, and a session that found nothing to do.
succeeds run slim2023-limits "${small[@]}" --set IK-BA.alpha=0.7
succeeds store ls $store
has "$out" "unused: 4 solves"
succeeds fingerprint $store
before=$out
succeeds store gc $store
has "$out" "removed 4 solves"
succeeds fingerprint $store
[ "$out" = "$before" ] || fail "gc changed a study: $before, then $out"
succeeds store gc $store
has "$out" "removed 0 solves and 0 sessions"
as_json 'of["study"] is None and of["solves"] == 0 and of["bytes"] <= of["bytes_before"]' store gc $store

# A removed study leaves the other as it is, and no sign of a change.
succeeds store rm $store slim2023-limits
has "$out" "removed the study slim2023-limits, 24 solves"
succeeds fingerprint $store
[ "$out" = "$(grep ' slim2023$' <<<"$before")" ] || fail "rm changed the other study: $out"
succeeds report $store --no-figures --out report
has_no "$err" changed
refused "no study 'slim2023-limits'" store rm $store slim2023-limits
[ "$(sqlite3 $store "SELECT count(*) FROM meta WHERE key LIKE '%limits%'")" = 0 ] || fail "notes of the study stayed"
succeeds run slim2023-limits "${small[@]}"
succeeds run slim2023 "${small[@]}"
has_no "$err" changed

# What was edited is not made to look whole.
sqlite3 $store "UPDATE solves SET run = 9 WHERE run = 2 AND point = 1 AND solver = 'DE'"
cp $store edited.sqlite
refused "Nothing was removed." store gc $store
cmp $store edited.sqlite || fail "a refused store was changed"

# A store that a run writes stays as it is.
"$program" run slim2023 --set runs=2000 --no-report --out busy >/dev/null 2>&1 &
writer=$!
for _ in {1..100}; do [ -e busy/store.sqlite-wal ] && break || sleep 0.1; done
sleep 0.5
run_it store rm busy/store.sqlite slim2023
[ "$code" != 0 ] || fail "a store was emptied while a run wrote it"
kill -INT $writer
wait $writer
succeeds report busy/store.sqlite --no-figures --out busy-report
has_no "$err" "changed"

echo nonsense >no.sqlite
refused "is not an ikbench store" store ls no.sqlite

# A store of 0.1.0 is read by every 1.x: what that version wrote of it is what this one says (tests/data/stores).
kept=$scripts/../data/stores
cp "$kept/0.1.0.sqlite" kept.sqlite
succeeds fingerprint kept.sqlite
has "$(tr -s ' ' <"$kept/README.md")" "fingerprint was ${out%% *}."
succeeds store show kept.sqlite
[ "$(grep -cE '^(DLS|search) .* 4 ' <<<"$out")" = 2 ] || fail "two solvers of 4 solves: $out"
succeeds export kept.sqlite -o kept.csv
succeeds report kept.sqlite --no-figures --out kept
has_no "$err" changed
succeeds compare --store kept.sqlite DLS search -o kept.json
# A store of a schema that nobody knows yet, or of one before 0.1.0.
for schema in 99 12; do
  cp kept.sqlite other.sqlite
  sqlite3 other.sqlite "PRAGMA user_version = $schema"
  for command in "report other.sqlite --out no" "export other.sqlite" "store show other.sqlite" "fingerprint other.sqlite"; do
    refused "has schema $schema, but this ikbench reads schema 23 alone; use the ikbench that wrote it, or run its studies into a new store" $command
  done
done

command -v python3 >/dev/null || exit 0
cat >read.py <<'PYTHON'
import csv, json, math, statistics, sys

def rows_of(file):
    with open(file) as text:
        return list(csv.DictReader(text))

written, read = rows_of(sys.argv[1]), rows_of("kept.csv")
assert len(written) == len(read) == 8
for old, new in zip(written, read):
    assert all(new[column] == value for column, value in old.items())

# By hand, from what 0.1.0 wrote: the mean of a solver over its runs, and the mean that is compared, in which an error
# below the tolerance counts as the tolerance.
for row in rows_of("kept/tables/results.csv"):
    if row["metric"] == "position_error_cm":
        errors = [float(old["position_error_cm"]) for old in written if old["solver"] == row["algorithm"]]
        assert math.isclose(float(row["mean"]), statistics.fmean(errors), rel_tol=1e-12), row
compared = json.load(open("kept.json"))["rows"][0]
for side, solver in (("mean_A", "DLS"), ("mean_B", "search")):
    errors = [max(0.1, float(old["position_error_cm"])) for old in written if old["solver"] == solver]
    assert compared["metric"] == "position_error_cm" and math.isclose(compared[side], statistics.fmean(errors), rel_tol=1e-12)
PYTHON
python3 read.py "$kept/0.1.0.csv" ||
  fail "what is read of a store of 0.1.0 is not what 0.1.0 wrote"

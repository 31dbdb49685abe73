#!/usr/bin/env bash
# Exports are what other programs read.
source "$(dirname "$0")/common.sh"

succeeds run slim2023 "${small[@]}" --set trace=best_error --no-report --out made
succeeds run slim2023-context "${small[@]}" --no-report --out made

succeeds export made/store.sqlite
[ -z "$err" ] || fail "export wrote to the standard error: $err"
[ "$(wc -l <.out)" = 37 ] || fail "a head and 36 solves expected, not $(wc -l <.out) lines"
[ "$(awk -F, '{ print NF }' .out | sort -u | wc -l)" = 1 ] || fail "rows of different lengths"
quiet
cp .out first.csv
succeeds export made/store.sqlite -o file.csv
[ -z "$out" ] || fail "export -o wrote to the standard output too"
cmp file.csv first.csv || fail "-o writes something else"

# -o follows links, keeps permissions, and writes into what is no regular file.
echo old >private.csv
chmod 600 private.csv
ln -s private.csv link.csv
succeeds export made/store.sqlite -o link.csv
[ -L link.csv ] || fail "-o replaced a link"
cmp private.csv first.csv || fail "-o through a link writes something else"
[ "$(stat -c %a private.csv)" = 600 ] || fail "-o made a private file $(stat -c %a private.csv)"
mkfifo pipe
cat pipe >from-pipe.csv &
reader=$!
succeeds export made/store.sqlite -o pipe
[ -p pipe ] || fail "-o replaced a pipe"
wait $reader
cmp from-pipe.csv first.csv || fail "-o into a pipe writes something else"
if mknod null c 1 3 2>.mknod && mknod full c 1 7 2>.mknod && : 2>.mknod >null; then # only root may
  succeeds export made/store.sqlite -o null
  run_it export made/store.sqlite -o full
  [ "$code" = 2 ] || fail "exit code $code of an export to a full device, expected 2: $err"
  has "$err" "cannot write 'full': No space left on device"
  [ -c null ] && [ -c full ] || fail "-o replaced a device"
fi
"$program" export made/store.sqlite -o /dev/stdout | cmp - first.csv || fail "-o /dev/stdout writes something else"

# A redirected standard output keeps what is in it before and after.
echo before >log
"$program" export made/store.sqlite -o /dev/stdout >>log
echo after >>log
{ echo before; cat first.csv; echo after; } | cmp - log || fail "-o /dev/stdout lost what its file had"
echo before >log
exec 3>>log
succeeds export made/store.sqlite -o /dev/fd/3
echo after >&3
exec 3>&-
{ echo before; cat first.csv; echo after; } | cmp - log || fail "-o /dev/fd/3 lost what its file had"
echo old >one.csv
ln one.csv other.csv
succeeds export made/store.sqlite -o one.csv
cmp other.csv first.csv || fail "-o parted a file from its other name"
for part in '' -wal -shm -journal; do
  [ -e "made/store.sqlite$part" ] || : >"made/store.sqlite$part"
  refused 'is the store itself or part of it' export made/store.sqlite -o "made/store.sqlite$part"
  [ -s "made/store.sqlite$part" ] || rm "made/store.sqlite$part"
done

succeeds export made/store.sqlite --study slim2023-context
[ "$(wc -l <.out)" = 13 ] || fail "a head and 12 solves expected of the second study"
has "$out" "DLS"

# A closed pipe is no crash.
"$program" export made/store.sqlite | head -n 1 >.out
code=${PIPESTATUS[0]}
[ "$code" = 0 ] || [ "$code" = 141 ] || fail "export | head: exit code $code"

command -v python3 >/dev/null || exit 0
succeeds export made/store.sqlite --format json -o solves.json
python3 - <<'PYTHON' || fail "the JSON is not as it should be"
import csv, json

def strict(constant):
    raise ValueError(constant)  # NaN and Infinity are not JSON

data = json.load(open("solves.json"), parse_constant=strict)
rows = list(csv.DictReader(open("file.csv", newline="")))
solves = data["solves"]
assert data["study"] == "slim2023"
assert data["definition"]["points"] == 3 and data["definition"]["runs"] == 2
assert [series["label"] for series in data["series"]] == ["IK-BA", "BA", "DE", "PSO", "K-ABC", "MO-PSO"]
assert len(data["sessions"]) == 2
assert len(solves) == len(rows) == 36
for solve, row in zip(solves, rows):
    for name in ("position_error_cm", "claimed_error_cm", "variation_deg", "seconds"):
        assert solve[name] == float(row[name]), name  # all digits in both
    assert solve["answer_rad"] == [float(row[f"answer_rad_{joint}"]) for joint in range(1, 8)]
    assert solve["solver"] == row["solver"] and solve["point"] == int(row["point"])
    assert len(solve["trace_cm"]) == solve["iterations"] == 5
    assert abs(solve["position_error_cm"] - solve["claimed_error_cm"]) < 1e-7
PYTHON

# Means for programs that chart benchmarks, against the schemas that these publish.
if command -v python3 >/dev/null; then
  succeeds run slim2023 --set runs=4 --set path.points=3 --set stop.iterations=5 --no-report --out charted
  succeeds export charted/store.sqlite --format benchmark-json -o benchmark.json
  succeeds export charted/store.sqlite --format bencher-json
  cp .out bencher.json
  PYTHONPATH="$scripts/../../results/python" PYTHONDONTWRITEBYTECODE=1 python3 - <<'PYTHON' || fail "the charts' JSON is wrong"
import json, math, ikbench

number = (int, float)
store = ikbench.Store("charted")
means = {}
for row in store.run_means(column="position_error_cm"):
    means.setdefault(row["solver"], []).append(row["position_error_cm"])
solved = {}
for row in store.solves():
    solved.setdefault(row["solver"], []).append(row["status"] == "ok")

# bencher.dev/bmf.json: an object of objects of objects with a number `value`, perhaps lower_value and upper_value.
bencher = json.load(open("bencher.json"))
assert list(bencher) == list(means)
for label, measures in bencher.items():
    for measure, metric in measures.items():
        assert set(metric) in ({"value"}, {"value", "lower_value", "upper_value"}), metric
        assert all(isinstance(value, number) and math.isfinite(value) for value in metric.values())
        assert len(measure) <= 64 and len(label) <= 1024
    mean = sum(means[label]) / len(means[label])
    assert math.isclose(measures["error"]["value"], mean, rel_tol=1e-12)
    assert measures["error"]["lower_value"] < mean < measures["error"]["upper_value"]
    assert math.isclose(measures["solved"]["value"], sum(solved[label]) / len(solved[label]), abs_tol=1e-12)

# github-action-benchmark: an array of objects with name, unit and value, perhaps range.
charted = json.load(open("benchmark.json"))
assert len({one["name"] for one in charted}) == len(charted) == sum(map(len, bencher.values()))
for one in charted:
    assert set(one) <= {"name", "unit", "value", "range"} and isinstance(one["value"], number), one
failed = next(one for one in charted if one["name"].startswith("IK-BA: 1 - "))
assert math.isclose(failed["value"], 1 - sum(solved["IK-BA"]) / len(solved["IK-BA"]), abs_tol=1e-12)
PYTHON
fi

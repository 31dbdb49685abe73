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

# A fingerprint is a line, the same with several jobs, and another with another seed.
succeeds export made/store.sqlite --study slim2023-context --format fingerprint
[[ $out =~ ^[0-9a-f]{32}\ \ 12\ \ slim2023-context$ ]] || fail "it said: $out"
succeeds run slim2023 "${small[@]}" --set trace=best_error --jobs 3 --no-report --out many
same_fingerprint many/store.sqlite made/store.sqlite
succeeds run slim2023 "${small[@]}" --set trace=best_error --set seed=2 --no-report --out seed-2
succeeds export seed-2/store.sqlite --format fingerprint
[ "$out" != "$("$program" export made/store.sqlite --format fingerprint)" ] || fail "the same fingerprint with another seed"

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

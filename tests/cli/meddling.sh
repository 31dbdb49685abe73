#!/usr/bin/env bash
# The program never reports success over what others do to a store while it writes it.
source "$(dirname "$0")/common.sh"

study=(run slim2023 --set runs=6 --set path.points=10 --set stop.iterations=200 --set population=20 --no-figures)

# begin FOLDER: the study runs into it, in the background, as $process; its store has solves.
begin() {
  "$program" "${study[@]}" --out "$1" >.first-out 2>.first-err &
  process=$!
  until [ -s "$1/store.sqlite-wal" ] && [ "$(solves "$1/store.sqlite" 2>.polled)" -ge 5 ]; do
    kill -0 $process 2>.polled || fail "it ended before anybody could meddle: $(<.first-err)"
    sleep 0.02
  done
}

# ended CODE WORDS: checks how it ended, and that it reported no success.
ended() {
  wait $process 2>.waited
  code=$?
  [ "$code" = "$1" ] || fail "exit code $code, expected $1; it said: $(<.first-out) $(<.first-err)"
  has "$(<.first-err)" "$2"
  has_no "$(<.first-out)" "solves in"
  has_no "$(<.first-out)" "Report"
}

# The store is removed, with its folder or alone, moved away, or replaced.
begin removed
rm -r removed
ended 2 "'removed/store.sqlite' was removed, moved or replaced while ikbench wrote to it"
begin alone
rm alone/store.sqlite
ended 2 "'alone/store.sqlite' was removed, moved or replaced"
begin moved
mv moved elsewhere
ended 2 "'moved/store.sqlite' was removed, moved or replaced"
mv elsewhere moved
succeeds "${study[@]}" --out moved
has "$out" "were already stored)"
succeeds run slim2023 "${small[@]}" --no-report --out another
begin replaced
cp another/store.sqlite replaced/copy
mv replaced/copy replaced/store.sqlite
ended 2 "'replaced/store.sqlite' was removed, moved or replaced"

# Another study of the same name takes its place in the store.
begin shared
succeeds run slim2023 "${small[@]}" --set seed=2 --no-report --out shared
has "$err" "has a different study named slim2023"
ended 1 "saved a different study named 'slim2023' in this store"
succeeds "${study[@]}" --out shared
has "$out" "(360 were already stored)"
has "$out" "Report: shared/report.html"

# The same study runs twice.
begin twice
run_it "${study[@]}" --out twice
second=$code
wait $process
first=$?
case "$first $second" in
  "0 1") has "$err" "another ikbench is running the same study into 'twice/store.sqlite'; wait until it has ended" ;;
  "1 0") has "$(<.first-err)" "another ikbench is running the same study into 'twice/store.sqlite'; wait until" ;;
  *) fail "one of two goes on, and the other is refused; exit codes $first and $second: $(<.first-err) $err" ;;
esac

command -v python3 >/dev/null || exit 0

# An error or an answer that somebody changed stops a report and a comparison, with its place.
for edit in "position_error_cm = -1" "orientation_error = 1" "answer_rad = json_set(answer_rad, '\$[0]', 3)" \
  "target_position_m = json_set(target_position_m, '\$[0]', 3)"; do
  rm -rf changed
  mkdir changed
  cp shared/store.sqlite changed/
  sqlite3 changed/store.sqlite "UPDATE solves SET $edit WHERE solver = 'BA' AND run = 2 AND point = 3"
  refused "study slim2023, BA, run 2, point 3: " report changed/store.sqlite --no-figures
  [ "$(ls changed)" = store.sqlite ] || fail "a refused report left $(ls changed)"
  refused "study slim2023, BA, run 2, point 3: " compare IK-BA BA --store changed/store.sqlite
  has "$err" " is stored, but "
done

# Broken pages are found when a store is opened.
mkdir broken
cp shared/store.sqlite broken/
printf '%4096s' x | dd of=broken/store.sqlite bs=4096 seek=20 conv=notrunc 2>.dd
refused "'broken/store.sqlite' is damaged (" report broken/store.sqlite --no-figures

# Somebody else's folder: what lies in it is not run.
mkdir theirs
cp shared/store.sqlite theirs/
succeeds report theirs/store.sqlite
for script in theirs/figures/*.gp; do echo "system 'touch $PWD/ran'" >>"$script"; done
succeeds report theirs/store.sqlite
[ ! -e ran ] || fail "a script of the folder was run"
! grep -q "touch" theirs/figures/*.gp || fail "a script of the folder stayed"

# A reader that does not end keeps the log from being folded in.
begin read
python3 - <<'PYTHON' &
import os, sqlite3, time

store = sqlite3.connect("file:read/store.sqlite?mode=ro", uri=True, isolation_level=None)
store.execute("BEGIN")
store.execute("SELECT count(*) FROM solves").fetchone()
open("is-reading", "w").close()
while not os.path.exists("end-reading"):
    time.sleep(0.01)
PYTHON
reader=$!
until [ -e is-reading ]; do kill -0 $reader 2>.polled || fail "the reader does not read"; done
wait $process || fail "exit code $? with a reader; it said: $(<.first-err)"
has "$(<.first-err)" "read/store.sqlite-wal; copy both files together"
: >end-reading
wait $reader
mkdir copied
cp read/store.sqlite read/store.sqlite-wal copied/
[ "$(solves copied/store.sqlite)" = 360 ] || fail "the files that were named are not the whole store"
succeeds "${study[@]}" --out read
[ ! -e read/store.sqlite-wal ] || fail "running again did not make one file of them"
exit 0

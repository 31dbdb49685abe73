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

# Numbers that somebody changed are told first, and end a report and a comparison with 1.
mkdir changed
cp shared/store.sqlite changed/
python3 - <<'PYTHON'
import sqlite3

store = sqlite3.connect("changed/store.sqlite")
store.execute("update solves set position_error_cm=-1 where solver='BA'")
store.commit()
PYTHON
run_it report changed/store.sqlite --no-figures
[ "$code" = 1 ] || fail "a changed store: exit code $code"
has "$err" "the store is damaged"
[ "$(cat .out .err | wc -l)" -le 30 ] || fail "a changed store: not one screen: $out $err"
has "$(sed '/^## Warnings/q' changed/report.md)" "Believe nothing here"
warnings=$(sed -n '/^## Warnings/,/^## [^W]/p' changed/report.md)
has "$warnings" "Damaged: position_error_cm of 60 solves (first: BA, run 1, point 1, session 1: -1 is stored"
refused "Damaged: position_error_cm" compare IK-BA BA --store changed/store.sqlite

# Every other change is reported too, even if nothing can compute it again: by digests, by the definition, by the
# answer.
succeeds run slim2023 "${small[@]}" --set repeats=3 --no-report --out pristine
succeeds run slim2023 "${small[@]}" --set repeats=3 --set runs=3 --no-figures --out pristine
has_no "$err" "Damaged"
[ "$(sqlite3 pristine/store.sqlite 'SELECT count(*) FROM sessions')" = 2 ] || fail "not two sessions"
mkdir edits
python3 - <<'PYTHON' || fail "the edits"
import shutil, sqlite3

columns = """evaluations=evaluations+1 | evaluations=evaluations*10 | iterations=iterations+1 | iterations=0 | seconds=seconds/2
cpu_seconds=cpu_seconds/2 | smallest_seconds=smallest_seconds/2 | largest_seconds=largest_seconds*2 | interruptions=0.5
repeats=repeats+1 | timing='clean' where timing<>'clean' | timing='parallel' | stop_reason='tolerance' | trace_cm='[1]'
improved_at='[1]', improved_to_cm='[1]' | claimed_error_cm=0 | counted_by='solver' | robot='other' | study='other' | digest=0 | digest=1
run=run+100 | run=run+100 where run=3 | series=substr(series,2) where run=3 | session=session+1 | waited_seconds=1 | transport_seconds=1 | claimed_seconds=1 | round_trips=1
position_error_cm=NULL | orientation_error=NULL | seconds=NULL | smallest_seconds=NULL
variation_m=NULL | variation_deg=NULL | status='tolerance_missed' where status='ok'""".replace("\n", "|")
whole = ["update solves set " + (edit.strip() if " where " in edit else edit.strip() + " where solver='BA'")
         for edit in columns.split("|")]
whole += [
    "delete from solves where run=2",
    "delete from solves where solver='BA' and point=3",
    "delete from solves where solver='BA'",
    "delete from solves where session=(select max(id) from sessions)",
    "update environment set value='other' where key='source'",
    "update environment set value='other' where key='cpu'",
    "update environment set value='other' where key='command'",
    "update environment set value='other' where key='commit'",
    "update environment set value='0' where key='stolen_seconds'",
    "delete from environment where key='analysis'",
    "delete from meta where key glob 'look after *'",
    "update meta set value='2020-01-01T00:00:00Z' where key glob 'look after *'",
    "update sessions set began='2020-01-01T00:00:00Z'",
    "update studies set definition=json_set(definition,'$.runs',1)",
    "update studies set definition=json_set(definition,'$.points',2)",
    "update studies set definition=json_set(definition,'$.analysis.significance',0.2)",
    "update studies set definition=json_set(definition,'$.stop.iterations',7)",
    "update studies set definition=json_set(definition,'$.title','Other')",
    "update series set options='{}' where label='BA'",
    "delete from series where label='BA'",
    "update series set label='x' where label='BA'; update solves set solver='x' where solver='BA';"
    "update series set label='BA' where label='DE'; update solves set solver='BA' where solver='DE';"
    "update series set label='DE' where label='x'; update solves set solver='DE' where solver='x'",
    "update series set key='x' where label='BA'; update series set key='y' where label='DE';"
    "update series set key=(select min(series) from solves where solver='DE') where key='x'",
]
for number, edit in enumerate(whole):
    shutil.copy("pristine/store.sqlite", f"edits/{number}.sqlite")
    store = sqlite3.connect(f"edits/{number}.sqlite")
    before = store.total_changes
    store.executescript(edit)
    store.commit()
    if store.total_changes > before:  # else it changes nothing of this store
        print(edit, file=open(f"edits/{number}.sql", "w"))
PYTHON
[ "$(ls edits/*.sql | wc -l)" -gt 50 ] || fail "few edits change the store"
for edit in edits/*.sql; do
  run_it compare IK-BA PSO --store "${edit%.sql}.sqlite"
  [ "$code" = 1 ] || fail "believed by compare, exit code $code: $(<"$edit")"
  [[ $err == *Damaged* || $err == *damaged* ]] || fail "compare says nothing of an edit: $(<"$edit"): $err"
done
mkdir unedited
cp pristine/store.sqlite unedited/
succeeds report unedited/store.sqlite --no-figures

# Solves of a session that the store does not have are reported, too.
mkdir astray
cp shared/store.sqlite astray/
python3 - <<'PYTHON'
import sqlite3

store = sqlite3.connect("astray/store.sqlite")
store.execute("update solves set session=99 where solver='BA'")
store.commit()
PYTHON
run_it report astray/store.sqlite --no-figures
[ "$code" = 1 ] || fail "an unknown session: exit code $code"
has "$(sed -n '/^## Warnings/,/^## [^W]/p' astray/report.md)" "Damaged: its solves name 1 session that the table of sessions does not have (first: 99)."
refused "(first: 99)" compare IK-BA DE --store astray/store.sqlite

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

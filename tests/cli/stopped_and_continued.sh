#!/usr/bin/env bash
# A run that is killed, or stopped by Ctrl-C, and started again gives the numbers of one that was let alone.
source "$(dirname "$0")/common.sh"

study=(run slim2023 --set runs=10 --set path.points=10 --set stop.iterations=200 --set population=20 --no-report)
succeeds "${study[@]}" --out whole
[ "$(solves whole/store.sqlite)" = 600 ] || fail "600 solves expected" # 6 solvers x 10 runs x 10 points
numbers whole/store.sqlite >whole.csv

# stop_in_the_middle SIGNAL FOLDER: sends it once the store has solves; $code is how the program ended.
stop_in_the_middle() {
  local signal=$1 folder=$2 process
  "$program" "${study[@]}" --out "$folder" >.stopped-out 2>.stopped-err &
  process=$!
  until [ -s "$folder/store.sqlite-wal" ] && [ "$(solves "$folder/store.sqlite" 2>.polled)" -ge 5 ]; do
    kill -0 $process 2>.polled || fail "it ended before it could be stopped: $(<.stopped-err)"
  done
  kill -s "$signal" $process || fail "it had ended before it could be stopped"
  wait $process 2>.waited
  code=$?
  done_before=$(solves "$folder/store.sqlite")
  [ "$done_before" -gt 0 ] && [ "$done_before" -lt 600 ] || fail "not stopped in the middle: $done_before solves"
}

stop_in_the_middle KILL killed
[ "$code" = 137 ] || fail "exit code $code after kill -9"
run_it "${study[@]}" --out killed
[ "$code" = 0 ] || fail "cannot go on after kill -9: $err"
has "$out" "($done_before were already stored)"
numbers killed/store.sqlite | cmp - whole.csv || fail "killed and continued: other numbers"

for signal in INT TERM HUP; do
  stop_in_the_middle $signal "stopped-$signal"
  [ "$code" = $((128 + $(kill -l $signal))) ] || fail "exit code $code after SIG$signal; it said: $(<.stopped-err)"
  has "$(<.stopped-err)" "Stopping after the current solve"
  has "$(<.stopped-err)" "Stopped: $done_before of 600 solves are kept"
  succeeds "${study[@]}" --out "stopped-$signal"
  numbers "stopped-$signal/store.sqlite" | cmp - whole.csv || fail "stopped by SIG$signal and continued: other numbers"
done

# Again: nothing is left to do, and nothing changes.
"$program" export whole/store.sqlite >before.csv
succeeds "${study[@]}" --out whole
has "$out" "(600 were already stored)"
"$program" export whole/store.sqlite | cmp - before.csv || fail "running again changed the solves"

# More runs: only those.
succeeds "${study[@]}" --set runs=12 --out whole
has "$out" "720 solves"
has "$out" "(600 were already stored)"
numbers whole/store.sqlite | awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "run") run = i } NR == 1 || $run <= 10' |
  cmp - whole.csv || fail "more runs changed the others"
[ ! -e whole/store.sqlite-wal ] || fail "a finished store is more than one file"

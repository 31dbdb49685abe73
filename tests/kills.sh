#!/usr/bin/env bash
# Disturbs a working program: kill -9, SIGTERM and SIGHUP at random moments, to it alone and to all processes, a pause.
# No stored solve is lost, none is there twice, and at the end all is as if nothing had happened. (Files:
# files.test.cpp; locks: store_faults.test.cpp.)
#
#   tests/kills.sh PROGRAM                  one of each, as ./check does
#   tests/kills.sh PROGRAM 100              a hundred of each
#
# IKBENCH_KILLS_SEED=N repeats the moments of another time.
source "$(dirname "$0")/cli/common.sh"
rounds=${2:-1}
seed=${IKBENCH_KILLS_SEED:-$((10#$(date +%N)))}
RANDOM=$seed
echo "kills.sh: $rounds of each, IKBENCH_KILLS_SEED=$seed"
ends=(TERM INT)
# A program that nohup starts ignores SIGHUP.
[ -n "$(trap -p HUP)" ] && echo "skipped in part: SIGHUP is ignored here" || ends+=(HUP)

begins() { "$program" "$@" >.said 2>&1 </dev/null & process=$!; }
# at_work FILES SIGNAL COMMAND...: the signal as soon as FILES are there, which the command makes long before its end. It
# ends by it; all but SIGKILL let it say so.
at_work() {
  local files=$1 signal=$2
  begins "${@:3}"
  until compgen -G "$files" >/dev/null; do
    kill -0 $process 2>/dev/null || fail "it ended before SIG$signal: $(<.said)"
    sleep 0.01
  done
  kill -s "$signal" $process
  wait $process 2>/dev/null
  code=$?
  equal "exit code after SIG$signal, which said $(<.said)" $code $((128 + $(kill -l "$signal")))
  [ "$signal" = KILL ] || grep -q "^Stopped" .said || fail "no word after SIG$signal: $(<.said)"
}

# signalled SIGNAL COMMAND...: the signal at a random moment of the time that the command took at first, $moment.
signalled() {
  local signal=$1 after_ms
  begins "${@:2}"
  after_ms=$((RANDOM % moment))
  sleep "$((after_ms / 1000)).$(printf '%03d' $((after_ms % 1000)))"
  before=$(look)
  ! kill -s "$signal" $process 2>/dev/null || { wait $process 2>/dev/null; code=$?; }
  [ "$code" = 0 ] || [ "$code" = $((128 + $(kill -l "$signal"))) ] || fail "exit code $code after SIG$signal: $(<.said)"
}
lasts() {
  local began
  began=$(date +%s%N)
  succeeds "$@"
  moment=$((($(date +%s%N) - began) / 1000000 + 1))
}

# until_done FOLDER SIGNAL COMMAND...: the same again and again, then the command to its end. What was in the store before
# a signal has to be there after it.
until_done() {
  local folder=$1 signal=$2 round
  shift 2
  look() { rows "$folder/store.sqlite"; }
  rm -rf "$folder"
  for ((round = 0; round < rounds; ++round)); do
    signalled "$signal" "$@"
    [ "$(look)" -ge "$before" ] || fail "SIG$signal lost $((before - $(look))) solves of: $*"
    [ "$code" != 0 ] || rm -rf "$folder" # it came too late: anew
  done
  succeeds "$@"
}
# rows STORE: its solves, also of one that a kill left half-written.
rows() {
  rm -rf .copy
  cp -r "$(dirname "$1")" .copy 2>/dev/null
  sqlite3 .copy/store.sqlite "SELECT count(*) FROM solves" 2>/dev/null || echo 0
}

study=(run slim2023 --set runs=12 --set path.points=8 --set stop.iterations=60 --set population=20 --no-report)
succeeds "${study[@]}" --out whole
numbers whole/store.sqlite >whole.csv
for i in 1 2 3; do succeeds "${study[@]}" --shard $i/3 --out shards/$i-of-3; done
as_whole() {
  numbers "$1" | cmp - whole.csv || fail "other numbers after $2"
  same_fingerprint "$1" whole/store.sqlite
}

kill_run() {
  local more signal
  lasts "${study[@]}" --out run
  for more in "--jobs 1" "--jobs 2" "--shard 1/1"; do
    for signal in KILL "${ends[@]}"; do
      until_done run $signal "${study[@]}" --out run $more
      as_whole run/store.sqlite "SIG$signal with $more"
    done
  done
  for signal in KILL "${ends[@]}"; do
    rm -rf run
    at_work "run/store.sqlite-wal" $signal "${study[@]}" --set stop.iterations=1000 --out run
  done
}

kill_merge() { # into a store that is there; a new one: merge.test.cpp
  local k signal begun
  look() { echo 0; }
  ends 5 merge begun shards/2-of-3
  begun=$(rows begun/store.sqlite)
  lasts merge first shards
  for ((k = 0; k < 2 * rounds; ++k)); do
    signal=$( ((k % 2)) && echo KILL || echo TERM)
    rm -rf merged
    cp -r begun merged
    signalled "$signal" merge merged shards
    [ "$(rows merged/store.sqlite)" -ge "$begun" ] || fail "SIG$signal of a merge lost solves"
    succeeds merge merged shards
    as_whole merged/store.sqlite "a merge with SIG$signal"
    equal "files of a merge" "$(ls merged)" store.sqlite
  done
}

kill_report() { # while it is drawn
  local signal
  ! can gnuplot || for signal in "${ends[@]}"; do
    rm -rf drawn
    at_work "drawn/figures/.ikbench-*" $signal report whole/store.sqlite --out drawn
    equal "SIG$signal left" "$(find drawn -name '.ikbench-*')" ""
  done
  printf '#!/bin/sh\necho $$ >%s/hangs\nexec sleep 1000\n' "$work" | install -D /dev/stdin hanging/gnuplot
  PATH=$work/hanging:$PATH at_work hangs KILL report whole/store.sqlite --out drawn
  sleep 0.2
  ! grep -qvs ') Z' "/proc/$(<hangs)/stat" || fail "a gnuplot that hangs outlives SIGKILL"
}

# below PROCESS: all processes that it started.
below() {
  local child
  for child in $(pgrep -P "$1"); do
    below "$child"
    echo "$child"
  done
}
# undisturbed FOLDER WHAT: its program has done there what it does alone, and failed nowhere.
undisturbed() {
  equal "failed after $2" "$(sqlite3 "$1/store.sqlite" "SELECT run, point, status FROM solves WHERE status NOT IN ('ok', 'tolerance_missed')
    UNION SELECT key, value, 0 FROM environment WHERE key LIKE 'program.%'")" ""
}
# until_solved FOLDER PROCESS: its program has solved something more, or all is over.
until_solved() {
  local had
  of_program() { sqlite3 "$1/store.sqlite" "SELECT count(*) FROM solves WHERE label <> 'DLS'" 2>/dev/null || echo 0; }
  had=$(of_program "$1")
  until [ "$(of_program "$1")" -gt "$had" ]; do
    kill -0 "$2" 2>/dev/null || break
    sleep 0.02
  done
}
kill_all() { # as batch systems stop a job: the solver that is a program ends first
  local round signal all
  cp "$root"/{solvers/helpers/ikbench,docs/examples/pso}.py .
  study all '[[solvers]]' 'label = "PSO"' 'process = ["python3", "pso.py"]'
  all=(run all.toml --set stop.iterations=400 --set population=10 --set stop.tolerance_cm=0.0001 --no-report --out)
  succeeds "${all[@]}" all-alone
  for signal in KILL "${ends[@]}"; do
    rm -rf all
    for ((round = 0; round < rounds; ++round)); do
      begins "${all[@]}" all
      until_solved all $process
      sleep 0.0$((RANDOM % 10))
      kill -s "$signal" $(below $process) $process 2>/dev/null
      wait $process 2>/dev/null
      [ ! -e all/store.sqlite ] || undisturbed all "SIG$signal to all, which said $(<.said)"
    done
    succeeds "${all[@]}" all
    equal "numbers after SIG$signal to all" "$(column all/store.sqlite position_error_cm PSO)" "$(column all-alone/store.sqlite position_error_cm PSO)"
  done
}

pause_all() { # for longer than its program may take for a solve
  local round slow paused
  sed 's/^import ikbench/&, time/; s/^def solve.*/&\n    time.sleep(0.5)/' "$root/docs/examples/pso.py" >slow.py
  cp "$root/solvers/helpers/ikbench.py" .
  study slow '[[solvers]]' 'label = "slow"' 'process = ["python3", "slow.py"]' 'timeout_s = 2'
  slow=(run slow.toml --set runs=1 --set path.points=4 --no-report --out)
  succeeds "${slow[@]}" slow-alone
  for ((round = 0; round < rounds; ++round)); do
    rm -rf slow
    begins "${slow[@]}" slow
    until_solved slow $process
    paused=$(below $process)
    kill -s STOP $paused $process
    sleep 2.5
    kill -s CONT $paused $process
    wait $process || fail "exit code $? after a pause: $(<.said)"
    undisturbed slow "a pause"
    equal "numbers after a pause" "$(column slow/store.sqlite position_error_cm slow)" "$(column slow-alone/store.sqlite position_error_cm slow)"
  done
}

kill_run
kill_merge
kill_report
kill_all
pause_all

#!/usr/bin/env bash
# Disturbs a working program: kill -9, SIGTERM and SIGHUP at random moments, a full disk, a locked store. No stored
# solve is lost, none is there twice, and at the end all is as if nothing had happened.
#
#   tests/kills.sh PROGRAM                  one of each, as ./check does
#   tests/kills.sh PROGRAM 100              a hundred of each
#   tests/kills.sh PROGRAM 100 run merge    of these parts alone: run program shard merge multiverse
#                                           report files disk locked
#
# IKBENCH_KILLS_SEED=N repeats the moments of another time.
source "$(dirname "$0")/cli/common.sh"
command -v sqlite3 >/dev/null || fail "no sqlite3, which ./setup installs"
rounds=${2:-1}
parts=("${@:3}")
[ ${#parts[@]} -gt 0 ] || parts=(run program shard merge multiverse report files disk locked)
seed=${IKBENCH_KILLS_SEED:-$((10#$(date +%N)))}
RANDOM=$seed
echo "kills.sh: $rounds of each, IKBENCH_KILLS_SEED=$seed"
ends=(TERM INT)
# A program that nohup starts ignores SIGHUP.
[ -n "$(trap -p HUP)" ] && echo "SIGHUP is ignored here and left out" || ends+=(HUP)
met=0 # signals that came while the program worked

# signalled LONGEST SIGNAL COMMAND...: the command, with the signal after at most LONGEST milliseconds.
signalled() {
  local longest=$1 signal=$2 process after_ms
  shift 2
  after_ms=$((RANDOM % longest))
  "$program" "$@" >.said 2>&1 </dev/null &
  process=$!
  sleep "$((after_ms / 1000)).$(printf '%03d' $((after_ms % 1000)))"
  before=$(look)
  kill -s "$signal" $process 2>/dev/null
  wait $process 2>/dev/null
  code=$?
  [ "$code" = 0 ] && return # it came too late
  met=$((met + 1))
  [ "$code" = $((128 + $(kill -l "$signal"))) ] || fail "exit code $code after SIG$signal: $(<.said)"
  [ "$signal" = KILL ] || grep -q "^Stopped" .said || [ ! -s .said ] || fail "no sentence after SIG$signal: $(<.said)"
}

# lasts COMMAND...: how many milliseconds it takes to its end, in $moment, so that signals come meanwhile.
lasts() {
  local began
  began=$(date +%s%N)
  succeeds "$@"
  moment=$((($(date +%s%N) - began) / 1000000 + 1))
}

# until_done FOLDER LONGEST SIGNAL COMMAND...: the same again and again, then the command to its end. What `look` finds
# before a signal has to be there after it. What is done is begun anew.
until_done() {
  local folder=$1 round after
  shift
  rm -rf "$folder"
  for ((round = 0; round < rounds; ++round)); do
    signalled "$@"
    after=$(look_after)
    [ "$after" -ge "$before" ] || fail "SIG$2 lost $((before - after)) solves of: ${*:3}"
    [ "$code" != 0 ] || rm -rf "$folder"
  done
  succeeds "${@:3}"
}

# at_work FILES SIGNAL COMMAND...: the signal as soon as FILES are there, which the command makes long before its end. It
# has to be obeyed, with a sentence.
at_work() {
  local files=$1 signal=$2 process
  shift 2
  "$program" "$@" >.said 2>&1 </dev/null &
  process=$!
  until compgen -G "$files" >/dev/null; do
    kill -0 $process 2>/dev/null || fail "it ended before SIG$signal: $(<.said)"
    sleep 0.01
  done
  kill -s "$signal" $process
  wait $process
  code=$?
  [ "$code" = $((128 + $(kill -l "$signal"))) ] || fail "exit code $code after SIG$signal while at work: $(<.said)"
  grep -q "^Stopped" .said || fail "no sentence after SIG$signal: $(<.said)"
}

told() {
  echo "$1: $met of $2 signals came while it worked; nothing lost"
  met=0
}

# The number of solves: in a store that is written, and in one that a kill may have left half-written.
look() { echo 0; }
look_after() { look; }
rows_of() {
  "$program" export "$1" 2>/dev/null | tail -n +2 | wc -l
}
rows_after() {
  rm -rf .copy
  cp -r "$(dirname "$1")" .copy 2>/dev/null
  sqlite3 .copy/store.sqlite "SELECT count(*) FROM solves" 2>/dev/null || echo 0
}

study=(slim2023 --set runs=12 --set path.points=8 --set stop.iterations=60 --set population=20)
long_study=(slim2023 --set runs=30 --set path.points=20 --set stop.iterations=400)
succeeds run "${study[@]}" --out whole --no-report
numbers whole/store.sqlite >whole.csv

as_whole() {
  numbers "$1" | cmp - whole.csv || fail "other numbers after $2"
  same_fingerprint "$1" whole/store.sqlite
}

kill_run() {
  local jobs signal
  look() { rows_of run/store.sqlite; }
  look_after() { rows_after run/store.sqlite; }
  lasts run "${study[@]}" --out run --no-report
  for jobs in 1 2; do
    for signal in KILL "${ends[@]}"; do
      until_done run $moment $signal run "${study[@]}" --out run --no-report --jobs $jobs
      as_whole run/store.sqlite "SIG$signal with $jobs jobs"
      told "run, $jobs job(s), SIG$signal" "$rounds"
    done
  done
  for signal in "${ends[@]}"; do
    rm -rf run
    at_work "run/store.sqlite-wal" $signal run "${long_study[@]}" --out run --no-report
  done
}

# A solver that is a program.
kill_program() {
  look() { rows_of program/store.sqlite; }
  look_after() { rows_after program/store.sqlite; }
  command -v python3 >/dev/null || { echo "no program: no python3"; return; }
  cp "$scripts/../../docs/examples/pso.py" .
  printf 'name = "program"\nruns = 6\nrepeats = 1\npopulation = 10\n[path]\npoints = 4\n[stop]\niterations = 10\n[[solvers]]\nlabel = "mine"\nprocess = ["python3", "pso.py"]\n' >process.toml
  lasts run process.toml --no-report --out whole-process
  until_done program $moment KILL run process.toml --out program --no-report
  same_fingerprint program/store.sqlite whole-process/store.sqlite
  told "run of a program, SIGKILL" "$rounds"
}

# A shard has no log, so a kill may leave it half-written: the same command mends it.
kill_shard() {
  local signal
  look() { rows_of shard/store.sqlite; }
  look_after() { rows_after shard/store.sqlite; }
  lasts run "${study[@]}" --shard 1/1 --out shard
  for signal in KILL TERM; do
    until_done shard $moment $signal run "${study[@]}" --shard 1/1 --out shard
    as_whole shard/store.sqlite "SIG$signal of a shard"
    told "run --shard, SIG$signal" "$rounds"
  done
}

# Merging: all or nothing, into a new store and into one that is there, which a kill may leave half-written. The signals
# come while a merge takes as long as the first one did.
kill_merge() {
  local i k kind signal rows begun all half=0
  look() { echo 0; }
  for i in 1 2 3; do succeeds run "${study[@]}" --shard $i/3 --out shards/$i-of-3; done
  run_it merge begun shards/2-of-3
  [ "$code" = 5 ] || fail "exit code $code of a merge of one of three shards, expected 5: $err"
  begun=$(rows_after begun/store.sqlite)
  all=$(rows_after whole/store.sqlite)
  lasts merge first shards
  for kind in new there; do
    for signal in KILL TERM; do
      for ((k = 0; k < rounds; ++k)); do
        rm -rf merged
        [ $kind = new ] || cp -r begun merged
        signalled $moment $signal merge merged shards
        [ ! -s merged/store.sqlite-journal ] || half=$((half + 1))
        [ $signal = KILL ] || [ ! -d merged ] || [[ $(ls -A merged) =~ ^(store.sqlite)?$ ]] || fail "SIG$signal of a merge leaves $(ls -A merged)"
        rows=$(rows_after merged/store.sqlite)
        [ "$rows" = "$all" ] || [ "$rows" = $([ $kind = new ] && echo 0 || echo "$begun") ] ||
          fail "SIG$signal left a merge with $rows solves, neither all nor those before"
        succeeds merge merged shards
        as_whole merged/store.sqlite "a merge with SIG$signal"
        [ "$(ls -A merged)" = store.sqlite ] || fail "a merged store is more than one file: $(ls -A merged)"
      done
      told "merge into a store that is $kind, SIG$signal" "$rounds"
    done
  done
  echo "$half of them left a store half-written, which the next merge mended"
}

# An interpretation is a line of a file.
kill_multiverse() {
  local multiverse=(multiverse slim2023 --set runs=2 --set path.points=3 --set stop.iterations=5 --set population=6
    --dimensions bounds,BA.best_of --no-figures)
  lines() { cat "$1/series.csv" 2>/dev/null | wc -l; }
  look() { lines killed; }
  look_after() { lines killed; }
  lasts "${multiverse[@]}" --out means
  until_done killed $moment KILL "${multiverse[@]}" --out killed
  cmp means/series.csv killed/series.csv || fail "another series.csv after kills"
  told "multiverse, SIGKILL" "$rounds"
  at_work "stopped/series.csv" TERM multiverse slim2023 --set stop.iterations=300 --out stopped
}

# While a report is drawn: a sentence, the code of the signal, and no scratch folder.
kill_report() {
  local signal k
  look() { echo 0; }
  for signal in "${ends[@]}"; do
    for ((k = 0; k < rounds; ++k)); do
      signalled 2000 $signal report whole/store.sqlite --out drawn
      [ -z "$(find drawn -name '.drawing-*' 2>/dev/null)" ] || fail "SIG$signal left $(find drawn -name '.drawing-*')"
    done
    told "report, SIG$signal" "$rounds"
    rm -rf drawn
    at_work "drawn/figures/.drawing-*" $signal report whole/store.sqlite --out drawn
    [ -z "$(find drawn -name '.drawing-*')" ] || fail "SIG$signal left $(find drawn -name '.drawing-*')"
  done
}

# Files that are exported: whole or not there, and the same command again succeeds and cleans.
kill_files() {
  local format k signal
  look() { echo 0; }
  succeeds run slim2023 --set runs=8 --set trace=best_error --out exported-from --no-report
  for format in csv json iohprofiler; do
    rm -rf exported-whole.$format
    lasts export exported-from/store.sqlite --format $format -o exported-whole.$format
    for ((k = 0; k < rounds; ++k)); do
      rm -rf exported && mkdir exported
      signalled $moment KILL export exported-from/store.sqlite --format $format -o exported/result
      # A folder that is there is refused: the kill came after it had its name.
      [ "$code" = 0 ] || { [ $format = iohprofiler ] && [ -e exported/result ]; } ||
        succeeds export exported-from/store.sqlite --format $format -o exported/result
      diff -r exported/result exported-whole.$format || fail "a killed export of $format is not whole"
      [ "$(ls -A exported)" = result ] || fail "a killed export of $format leaves $(ls -A exported)"
    done
    told "export --format $format, SIGKILL" "$rounds"
  done
}

# Takes away what is in a place on the small disk, and leaves room for half of it.
fill_but_half_of() {
  local size
  size=$(du -s --block-size=1 "small/$1" | cut -f1)
  rm -r "small/$1"
  local room
  room=$(df --output=avail --block-size=1 small | tail -1)
  head -c $((room - size / 2)) /dev/zero >small/filler
}

# A disk that is full while solves are stored: exit code 2, the name of the store, and later all goes on.
kill_disk() {
  mkdir small
  mount -t tmpfs -o size=256k none small 2>/dev/null || { echo "no full disk: only root can make a small one"; return; }
  trap 'cd /; umount "$work/small"; rm -rf "$work"' EXIT
  local i
  [ -d shards ] || for i in 1 2 3; do succeeds run "${study[@]}" --shard $i/3 --out shards/$i-of-3; done
  run_it run "${study[@]}" --out small/run --no-report
  [ "$code" = 2 ] || fail "exit code $code on a full disk: $out $err"
  has "$err" "cannot use 'small/run/store.sqlite': database or disk is full"
  run_it merge small/run shards
  [ "$code" = 2 ] || fail "exit code $code of a merge on a full disk: $out $err"
  has "$err" "cannot use 'small/run/store.sqlite': database or disk is full"
  mount -o remount,size=8m small
  succeeds run "${study[@]}" --out small/run --no-report
  as_whole small/run/store.sqlite "a full disk"
  # Files that do not fit are told by name, and nothing is left of them.
  local format
  succeeds run slim2023 --set runs=2 --set trace=best_error --out traced --no-report
  for format in csv json iohprofiler; do
    succeeds export traced/store.sqlite --format $format -o small/$format
    fill_but_half_of $format
    run_it export traced/store.sqlite --format $format -o small/$format
    [ "$code" = 2 ] || fail "exit code $code of $format on a full disk: $out $err"
    has "$err" "cannot write 'small/$format"
    [ ! -e small/$format ] || fail "$format on a full disk leaves $(find small/$format)"
    rm small/filler
  done
  mount -o remount,size=200m small
  succeeds report traced/store.sqlite --out small/report
  fill_but_half_of report/figures
  run_it report traced/store.sqlite --out small/report
  [ "$code" = 2 ] || fail "exit code $code of a report on a full disk: $out $err"
  # The page comes before the figures and may be what does not fit.
  has "$err" "cannot write 'small/report/"
  local picture
  for picture in small/report/figures/*.svg; do
    [ ! -e "$picture" ] || tail -c 9 "$picture" | grep -q '</svg>' || fail "half of a figure: $picture"
  done
  tail -c 9 small/report/report.html | grep -q '</html>' || fail "half of a page"
  rm -r small/report small/filler
  mount -o remount,size=8m small
  # Full before what is merged is together, and after that: the store that was there is as it was.
  local bytes
  for bytes in 60000000 2500000; do
    cp shards/1-of-3/store.sqlite large.sqlite
    sqlite3 large.sqlite "UPDATE solves SET series = series || ' of before', robot = hex(zeroblob($bytes / (SELECT count(*) FROM solves)))"
    run_it merge small/run large.sqlite
    [ "$code" = 2 ] || fail "exit code $code of a large merge on a full disk: $out $err"
    has "$err" "cannot use 'small/run/store.sqlite': database or disk is full"
    [ "$(ls -A small/run)" = store.sqlite ] || fail "a merge on a full disk leaves $(ls -A small/run)"
    as_whole small/run/store.sqlite "a merge on a full disk"
  done
  rm large.sqlite
  mount -o remount,ro small
  refused "cannot open 'small/run/store.sqlite'" run "${study[@]}" --set runs=13 --out small/run --no-report
  refused "cannot write" merge small/other shards
  mount -o remount,rw small
}

# A store that another program keeps locked: some seconds of waiting, a sentence, and later all goes on.
kill_locked() {
  local holder
  cp -r whole locked
  printf 'BEGIN EXCLUSIVE;\n.shell touch holds\n.shell sleep 60\n' | sqlite3 locked/store.sqlite &
  holder=$!
  until [ -e holds ]; do sleep 0.1; done
  run_it run "${study[@]}" --set runs=13 --out locked --no-report
  [ "$code" = 2 ] || fail "exit code $code of a locked store, expected 2: $out $err"
  has "$err" "another process has kept 'locked/store.sqlite' locked for 10 s; wait until it has ended"
  pkill -P $holder
  kill $holder 2>/dev/null
  wait $holder 2>/dev/null
  succeeds run "${study[@]}" --set runs=13 --out locked --no-report
}

for part in "${parts[@]}"; do
  declare -F "kill_$part" >/dev/null || fail "there is no part $part"
  "kill_$part"
done
exit 0

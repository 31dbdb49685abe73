#!/usr/bin/env bash
# What is done to a program that works: kill -9, SIGTERM and SIGHUP at random moments, a full disk. No solve is lost that
# was stored, none is there twice, and at the end all is as if nothing had happened.
#
#   tests/kills.sh PROGRAM         a few of each, as ./check does
#   tests/kills.sh PROGRAM 100     a hundred kills of each
source "$(dirname "$0")/cli/common.sh"
rounds=${2:-2}
RANDOM=${3:-$(date +%N | sed 's/^0*//')}
echo "kills.sh: $rounds of each"

# until_done LONGEST SIGNAL COMMAND...: the command, with the signal after at most LONGEST milliseconds, again and again, at
# most `rounds` times; then to its end. What `look` finds before a signal has to be there after it.
until_done() {
  local longest=$1 signal=$2 round process before after
  shift 2
  for ((round = 0; round < rounds; ++round)); do
    "$program" "$@" >.said 2>&1 </dev/null &
    process=$!
    sleep "$(printf '0.%03d' $((RANDOM % longest)))"
    before=$(look)
    kill -s "$signal" $process 2>/dev/null
    wait $process 2>/dev/null
    code=$?
    after=$(look)
    [ "$after" -ge "$before" ] || fail "SIG$signal lost $((before - after)) solves of: $*"
    ended "$signal"
  done
  succeeds "$@"
}

# Code and words after a signal; 0 where it came too late.
ended() {
  case $1 in
    KILL) [ "$code" = 137 ] || [ "$code" = 0 ] || fail "exit code $code after SIGKILL: $(<.said)" ;;
    *)
      [ "$code" = 0 ] && return
      [ "$code" = $((128 + $(kill -l "$1"))) ] || fail "exit code $code after SIG$1: $(<.said)"
      grep -q "^Stopped" .said || [ ! -s .said ] || fail "no sentence after SIG$1: $(<.said)"
      ;;
  esac
}

look() {
  echo 0
}
rows_of() {
  local rows
  rows=$("$program" export "$1" 2>/dev/null | wc -l)
  echo "$rows"
}

study=(slim2023 --set runs=12 --set path.points=8 --set stop.iterations=60 --set population=20)
succeeds run "${study[@]}" --out whole --no-report
numbers whole/store.sqlite >whole.csv

for jobs in 1 2; do
  for signal in KILL TERM HUP; do
    rm -rf run
    look() { rows_of run/store.sqlite; }
    until_done 700 $signal run "${study[@]}" --out run --no-report --jobs $jobs
    numbers run/store.sqlite | cmp - whole.csv || fail "other numbers after SIG$signal with $jobs jobs"
    [ "$("$program" fingerprint run/store.sqlite)" = "$("$program" fingerprint whole/store.sqlite)" ] || fail "another fingerprint"
  done
done

# Merging: all or nothing.
for i in 1 2 3; do succeeds run "${study[@]}" --shard $i/3 --out shards/$i-of-3; done
look() { echo 0; }
for ((k = 0; k < rounds; ++k)); do
  rm -rf merged
  "$program" merge merged shards >.said 2>&1 &
  process=$!
  sleep "$(printf '0.%03d' $((RANDOM % 60)))"
  kill -9 $process 2>/dev/null
  wait $process 2>/dev/null
  succeeds merge merged shards
  numbers merged/store.sqlite | cmp - whole.csv || fail "other numbers after a killed merge"
  [ -z "$(find merged -name 'store.sqlite?*')" ] || fail "a merged store is more than one file: $(ls merged)"
done

# An interpretation is a line of a file.
multiverse=(multiverse slim2023 --set runs=2 --set path.points=3 --set stop.iterations=5 --set population=6
  --dimensions bounds,BA.best_of --no-figures)
succeeds "${multiverse[@]}" --out means
until_done 400 KILL "${multiverse[@]}" --out killed
cmp means/series.csv killed/series.csv || fail "another series.csv after kills"

# A store of the first version gets columns when it is written.
old=$scripts/../data/store-of-4de262c.sqlite
"$program" export "$old" >old.csv || fail "cannot read $old"
study_of_old=$("$program" fingerprint "$old")
for ((k = 0; k < rounds; ++k)); do
  rm -rf migrated && mkdir migrated && cp "$old" migrated/store.sqlite && chmod u+w migrated/store.sqlite
  "$program" run slim2023-dobot "${small[@]}" --out migrated --no-report >.said 2>&1 &
  process=$!
  sleep "$(printf '0.%03d' $((RANDOM % 40)))"
  kill -9 $process 2>/dev/null
  wait $process 2>/dev/null
  succeeds run slim2023-dobot "${small[@]}" --out migrated --no-report
  [ "$("$program" fingerprint migrated/store.sqlite | head -n "$(wc -l <<<"$study_of_old")")" = "$study_of_old" ] || fail "a killed migration changed the old solves"
done

# While a report is drawn: a sentence, the code of the signal, and no scratch folder.
for signal in TERM HUP INT; do
  for ((k = 0; k < rounds; ++k)); do
    "$program" report whole/store.sqlite --out drawn >.said 2>&1 </dev/null &
    process=$!
    sleep "$(printf '%d.%03d' $((RANDOM % 2)) $((RANDOM % 1000)))"
    kill -s $signal $process 2>/dev/null
    wait $process 2>/dev/null
    code=$?
    ended $signal
    [ -z "$(find drawn -name '.drawing-*' 2>/dev/null)" ] || fail "SIG$signal left $(find drawn -name '.drawing-*')"
  done
done

# A disk that is full while solves are stored: exit code 2, the name of the store, and later all goes on.
mkdir small
if mount -t tmpfs -o size=256k none small 2>/dev/null; then
  trap 'cd /; umount "$work/small"; rm -rf "$work"' EXIT
  run_it run "${study[@]}" --out small/run --no-report
  [ "$code" = 2 ] || fail "exit code $code on a full disk: $out $err"
  has "$err" "cannot use 'small/run/store.sqlite': database or disk is full"
  run_it merge small/run shards
  [ "$code" = 2 ] || fail "exit code $code of a merge on a full disk: $out $err"
  has "$err" "disk is full"
  mount -o remount,size=8m small
  succeeds run "${study[@]}" --out small/run --no-report
  numbers small/run/store.sqlite | cmp - whole.csv || fail "other numbers after a full disk"
  mount -o remount,ro small
  refused "cannot open 'small/run/store.sqlite'" run "${study[@]}" --set runs=13 --out small/run --no-report
  refused "cannot write" merge small/other shards
  mount -o remount,rw small
else
  echo "no full disk: only root can make a small one"
fi
exit 0

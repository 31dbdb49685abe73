#!/usr/bin/env bash
# The system's clock jumps by days, back and forth, at every look: no result, limit or time depends on it, nor which
# scratch folder is old.
#   clock.sh PROGRAM JUMPING_CLOCK
source "$(dirname "$0")/common.sh"
clock=$(realpath "$2")
off=$(($(LD_PRELOAD=$clock date +%s) - $(date +%s)))
[ ${off#-} -gt 80000 ] || fail "the clock does not jump"
study=(run slim2023 "${small[@]}" --set runs=4 --no-report)
succeeds "${study[@]}" --out straight
printf '#!/bin/sh\nLD_PRELOAD=%s exec %s "$@"\n' "'$clock'" "'$program'" >jumping
chmod +x jumping
program=$work/jumping

# sound STORE: all times of a solve are elapsed times, without a jump.
sound() {
  equal "solves of $1 with times that nobody lived" "$(sqlite3 "$1" "SELECT count(*) FROM solves WHERE NOT (
    seconds BETWEEN 0 AND 1000 AND cpu_seconds BETWEEN 0 AND 1000 AND wall_seconds = seconds)")" 0
}

# The same solves, with one job and with two, begun and continued.
for jobs in 1 2; do
  succeeds "${study[@]}" --set runs=2 --out "jobs-$jobs" --jobs $jobs
  touch -d 2001-01-01 "jobs-$jobs/store.sqlite"
  succeeds "${study[@]}" --out "jobs-$jobs" --jobs $jobs
  has "$out" "(36 were"
  succeeds report "jobs-$jobs/store.sqlite" --figures none
  same_fingerprint "jobs-$jobs/store.sqlite" straight/store.sqlite
  sound "jobs-$jobs/store.sqlite"
done
succeeds merge merged jobs-1 jobs-2
same_fingerprint merged/store.sqlite straight/store.sqlite

# A limit of wall time is as long as it says, also of a library's solver.
succeeds run "$scripts/studies/limit.toml" --out limit --no-report
sound limit/store.sqlite
equal "solves that end too soon" "$(sqlite3 limit/store.sqlite "SELECT label, stop_reason, seconds FROM solves
  WHERE stop_reason NOT IN ('time', 'finished') OR seconds < 0.05")" ""

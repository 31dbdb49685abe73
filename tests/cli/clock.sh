#!/usr/bin/env bash
# The system's clock jumps by hours, back and forth, at every look: no result, limit, time or rate depends on it.
#   clock.sh PROGRAM JUMPING_CLOCK
source "$(dirname "$0")/common.sh"
command -v sqlite3 >/dev/null || fail "no sqlite3, which ./setup installs"
clock=$(realpath "$2")
off=$(($(LD_PRELOAD=$clock date +%s) - $(date +%s)))
[ ${off#-} -gt 3000 ] || fail "the clock does not jump"

straight=$program
printf '#!/bin/sh\nLD_PRELOAD=%s exec %s "$@"\n' "'$clock'" "'$program'" >jumping
chmod +x jumping

# All times of a solve are elapsed times, without a jump.
sound() {
  local wrong
  wrong=$(sqlite3 "$1" "SELECT count(*) FROM solves WHERE NOT (seconds BETWEEN 0 AND 1000 AND cpu_seconds BETWEEN 0 AND 1000
    AND smallest_seconds BETWEEN 0 AND seconds AND largest_seconds BETWEEN seconds AND 1000)") || fail "sqlite3 $1"
  [ "$wrong" = 0 ] || fail "$wrong solves in $1 have times that nobody lived"
}

# The same solves, with one job and with two, begun, continued, in shards and merged.
study=(slim2023 "${small[@]}" --set runs=4)
succeeds run "${study[@]}" --out straight --no-report
program=$work/jumping
for jobs in 1 2; do
  succeeds run "${study[@]}" --set runs=2 --out "jobs-$jobs" --no-report --jobs $jobs
  touch -d 2001-01-01 "jobs-$jobs/store.sqlite"
  succeeds run "${study[@]}" --out "jobs-$jobs" --no-report --jobs $jobs
  has "$out" "were already stored)"
  touch -d 2099-01-01 "jobs-$jobs/store.sqlite"
  succeeds run "${study[@]}" --out "jobs-$jobs" --no-report
  same_fingerprint "jobs-$jobs/store.sqlite" straight/store.sqlite
  sound "jobs-$jobs/store.sqlite"
done
for i in 1 2; do succeeds run "${study[@]}" --shard $i/2 --out merged/shards/$i-of-2; done
for _ in 1 2; do succeeds merge merged merged/shards; done
same_fingerprint merged/store.sqlite straight/store.sqlite
[ "$(sqlite3 merged/store.sqlite "SELECT count(*) FROM sessions")" = 2 ] || fail "merging again doubled sessions"
succeeds report jobs-2/store.sqlite --no-figures --out report
has_no "$(<report/report.md)" " -[0-9]* s"

# A limit of wall time is as long as it says, also of a library's solver.
cat >limit.toml <<'TOML'
name = "limit"
start = "initial"
runs = 1
stop = { seconds = 0.05, iterations = 100000000 }
path = { kind = "random", points = 2 }
solvers = [
  { solver = "random_search" },
  { solver = "bat" },
  { solver = "nlopt", if_missing = "leave_out", options = { restarts = "random" } },
]
TOML
succeeds run limit.toml --out limit --no-report
sound limit/store.sqlite
short=$(sqlite3 limit/store.sqlite "SELECT solver, stop_reason, seconds FROM solves WHERE stop_reason NOT IN ('time', 'finished') OR seconds < 0.05")
[ -z "$short" ] || fail "0.05 s are over too soon: $short"

exit 0

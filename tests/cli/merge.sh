#!/usr/bin/env bash
# Shards, merged, are what one machine gives, bit for bit.
source "$(dirname "$0")/common.sh"
chained=(slim2023 "${small[@]}" --set runs=8)
cat >drawn.toml <<'TOML'
name = "drawn"
runs = 5
population = 6
start = "random"
stop.iterations = 5
path = { kind = "random", points = 9 }
solvers = [{ solver = "bat" }, { solver = "newton" }]
TOML
drawn=(drawn.toml)

# shards FOLDER N: the study, in N shards, of which some are killed at some moment, and all begun again.
shards() {
  local folder=$1 n=$2 i process
  for ((i = n; i >= 1; --i)); do
    if ((i % 3 == 1)); then
      "$program" run "${study[@]}" --shard "$i/$n" --out "$folder/shards/$i-of-$n" >.killed 2>&1 &
      process=$!
      sleep "0.0$((i % 7))"
      kill -9 $process 2>.killed
      wait $process 2>.killed
    fi
    succeeds run "${study[@]}" --shard "$i/$n" --out "$folder/shards/$i-of-$n"
    [ ! -e "$folder/shards/$i-of-$n/report.md" ] || fail "a shard has a report"
  done
}

# counts ADDED KNOWN MISSING: what the last merge, with --json, said.
counts() { json "(of['added'], of['known'], sum(of['missing'].values())) == ($1, $2, $3)"; }

for name in chained drawn; do
  declare -n study=$name
  succeeds run "${study[@]}" --out "$name/one" --no-report
  numbers "$name/one/store.sqlite" >"$name.csv"
  for n in 1 7 40; do
    [ $name-$n != chained-40 ] || continue # it has 8 parts
    shards "$name/$n" $n
    succeeds merge "$name/$n" "$name/$n/shards"
    same_fingerprint "$name/$n/store.sqlite" "$name/one/store.sqlite"
    numbers "$name/$n/store.sqlite" | cmp - "$name.csv" || fail "$name in $n shards: other numbers"
  done
done
unset -n study

# Merged again, one by one or with itself: nothing is added, and nothing changes.
before=$("$program" export chained/7/store.sqlite --format json | md5sum)
succeeds merge chained/7 chained/7/shards/{5,1}-of-7 chained/7/store.sqlite chained/7/shards/5-of-7/store.sqlite --json
counts 0 72 0 # 6 solvers x 3 points x (1 run + 2 + 1), without itself
equal "the store, merged again" "$("$program" export chained/7/store.sqlite --format json | md5sum)" "$before"

# The same verdict, bit for bit, but for times.
for n in one 7; do succeeds report chained/$n/store.sqlite --figures none --out report-$n; done
cmp <(grep -v '^time,' report-one/tables/descriptives.csv) <(grep -v '^time,' report-7/tables/descriptives.csv) || fail "another report of shards"

# What is missing is counted; a run or its shards go on from there. More runs are merged into what there is.
mkdir parts && cp -r drawn/7/shards/{2,6}-of-7 parts
ends 5 merge holes parts --json
counts 26 0 64 # 7 + 6 targets by 2 solvers of 90
succeeds run drawn.toml --out holes --no-report
same_fingerprint holes/store.sqlite drawn/one/store.sqlite
for i in 1 2; do succeeds run drawn.toml --set runs=6 --shard $i/2 --out more/shards/$i-of-2; done
succeeds merge drawn/40 more/shards --json
counts 18 90 0
succeeds run drawn.toml --set runs=6 --out six --no-report
same_fingerprint drawn/40/store.sqlite six/store.sqlite

# A store that a kill left half-written is mended.
cp -r drawn/7/shards broken
sqlite3 broken/3-of-7/store.sqlite >.killed 2>&1 <<'SQL' || true
PRAGMA cache_size = 1;
BEGIN;
UPDATE solves SET trace_cm = '[1]';
UPDATE solves SET trace_cm = '[2]';
.shell kill -9 $PPID
SQL
[ -s broken/3-of-7/store.sqlite-journal ] || fail "no half-written store"
: >broken/4-of-7/store.sqlite
ends 5 merge rest broken --json
counts 78 0 12 # 6 targets by 2 solvers of 90

mkdir bad && echo text >bad/store.sqlite
# Other bits, another study, no store: refused.
cp -r drawn/7/shards/2-of-7 edited
sqlite3 edited/store.sqlite "UPDATE solves SET evaluations = evaluations + 1 WHERE solver = 'bat'"
refused "run 1, point 2" merge drawn/7 edited
same_fingerprint drawn/7/store.sqlite drawn/one/store.sqlite
refused edited merge new drawn/7/shards/2-of-7 edited
succeeds run drawn.toml --set seed=2 --out other --no-report
refused seed merge drawn/7 other
sed 's/solver = "bat"/solver = "bat", options = { alpha = 0.7 }/' drawn.toml >optioned.toml
succeeds run optioned.toml --out optioned --no-report
refused options merge drawn/7 optioned
refused bad merge drawn/7 bad
for shard in 0/3 4/3 3 3/ /3 a/b 1/100001 -1/3 1/3/5 ""; do refused I/N run drawn.toml --shard "$shard" --out none; done
refused 9/9 run "${chained[@]}" --shard 9/9 --out none
refused 1/46 run drawn.toml --shard 1/46 --out none
[ ! -e none ] || fail "a refused shard made a folder"

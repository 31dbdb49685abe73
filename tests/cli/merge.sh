#!/usr/bin/env bash
# Shards, merged, are what one machine gives, bit for bit, though some were killed; a store is added whole or not. How stores
# are merged: merge.test.cpp; how a study is divided: shard.test.cpp.
source "$(dirname "$0")/common.sh"
cp "$scripts/studies/drawn.toml" .
chained=(slim2023 "${small[@]}" --set runs=8)
drawn=(drawn.toml)

# counts ADDED KNOWN: what the last merge said.
counts() { [[ ${out//$'\n ' /} == *": $1 solves added "*" $2 were there"* ]] || fail "expected $1 added and $2 known: $out"; }

for name in chained drawn; do
  declare -n study=$name
  succeeds run "${study[@]}" --out "$name/one" --no-report
  for i in 7 6 5 4 3 2 1; do
    run_shard=(run "${study[@]}" --shard "$i/7" --out "$name/7/shards/$i-of-7")
    if ((i % 3 == 1)); then timeout -s KILL "0.0$i" "$program" "${run_shard[@]}" >.killed 2>&1; fi
    succeeds "${run_shard[@]}"
    [ ! -e "$name/7/shards/$i-of-7/report.md" ] || fail "a shard has a report"
  done
  succeeds merge "$name/7" "$name/7/shards"
  same_fingerprint "$name/7/store.sqlite" "$name/one/store.sqlite"
  numbers "$name/7/store.sqlite" | cmp - <(numbers "$name/one/store.sqlite") || fail "$name in shards: other numbers"
done

# Merged again, one by one or with itself, nothing is added. The verdict is the same, bit for bit, but for times.
succeeds merge chained/7/shards/{5,1}-of-7 -o chained/7 chained/7/store.sqlite chained/7/shards/5-of-7/store.sqlite
counts 0 72 # 6 solvers x 3 points x (1 run + 2 + 1), without itself
for n in one 7; do succeeds report chained/$n/store.sqlite --figures none --out report-$n; done
cmp <(grep -v '^time,' report-one/tables/descriptives.csv) <(grep -v '^time,' report-7/tables/descriptives.csv) || fail "another report of shards"

# What is missing is counted; a run goes on from there. More runs are merged into what there is.
mkdir parts && cp -r drawn/7/shards/{2,6}-of-7 parts
ends 5 merge holes parts
counts 26 0
has "$err" "lacks 64 of 90 solves" # 7 + 6 targets by 2 solvers of 90
ends 5 verify holes/store.sqlite --solves 0
has "$(tr -s " \n" " " <<<"$out")" "No solve was repeated" && has "$err" "lacks 64 of 90 solves"
succeeds run drawn.toml --out holes --no-report
same_fingerprint holes/store.sqlite drawn/one/store.sqlite
for i in 1 2; do succeeds run drawn.toml --set runs=6 --shard $i/2 --out more/shards/$i-of-2; done
succeeds merge drawn/7 more/shards
counts 18 90

# What is edited into a definition is told, and nothing runs without end.
cp -r drawn/7/shards/1-of-7 endless
sqlite3 endless/store.sqlite "UPDATE studies SET definition = json_set(definition, '\$.stop.iterations', 1000000000)"
for command in verify "report --figures none"; do refused "stops by iterations" $command endless/store.sqlite; done
ends 1 merge others drawn/7/shards/2-of-7 endless
has "$err" "left out: 'endless/store.sqlite'"

# What a store's own tables do not name was not checked: it is told and left out, and the merged store is read.
cp -r drawn/7/shards/3-of-7 nameless
sqlite3 nameless/store.sqlite "UPDATE solves SET position_error_cm = position_error_cm / 2; DELETE FROM studies; DELETE FROM series"
ends 1 merge named drawn/7/shards/2-of-7 nameless
[[ ${err//$'\n ' /} == *"left out: "*" solves in 'nameless/store.sqlite', because none of its studies has them"* ]] || fail "not told: $err"
succeeds report named/store.sqlite --figures none

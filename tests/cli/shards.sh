#!/usr/bin/env bash
# Shards, merged, are what one machine gives: the same solves, the same fingerprint, the same report.
source "$(dirname "$0")/common.sh"

fingerprint() {
  "$program" fingerprint "$@" || fail "no fingerprint of $*"
}

chained=(slim2023 "${small[@]}" --set runs=8)
cat >drawn.toml <<'TOML'
name = "drawn"
runs = 1
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
    ((n == 1)) || has "$out" ", shard $i/$n: "
    [ ! -e "$folder/shards/$i-of-$n/report.md" ] || fail "a shard has a report"
  done
}

for name in chained drawn; do
  declare -n study=$name
  succeeds run "${study[@]}" --out "$name/one" --no-report
  numbers "$name/one/store.sqlite" >"$name.csv"
  for n in 1 2 7 40; do
    [ $name-$n != drawn-40 ] || continue # as with 7: a target is in one shard
    shards "$name/$n" $n
    succeeds merge "$name/$n" "$name/$n/shards"
    [ "$(fingerprint "$name/$n/store.sqlite")" = "$(fingerprint "$name/one/store.sqlite")" ] || fail "$name in $n shards: another fingerprint"
    numbers "$name/$n/store.sqlite" | cmp - "$name.csv" || fail "$name in $n shards: other numbers"
    succeeds run "${study[@]}" --out "$name/$n" --no-report
    has "$out" "were already stored)"
  done
done

# Merged again, one by one or with itself: nothing is added, and nothing changes.
sqlite() {
  sqlite3 "$@" || fail "sqlite3 $*"
}
before=$("$program" export chained/7/store.sqlite --format json | md5sum)
succeeds merge chained/7 chained/7/shards/{5,1}-of-7 chained/7/store.sqlite chained/7/shards/5-of-7/store.sqlite
has "$out" "0 solves added from 2 stores, 54 were there with the same bits" # 6 solvers x 3 points x (2 runs + 1)
[ "$("$program" export chained/7/store.sqlite --format json | md5sum)" = "$before" ] || fail "merging again changed the store"

# The same report, byte for byte, of stores whose times and sessions are made the same.
if command -v sqlite3 >/dev/null; then
  for n in one 7; do
    sqlite chained/$n/store.sqlite "UPDATE solves SET seconds = 0.001, cpu_seconds = 0.001, smallest_seconds = 0.001,
      largest_seconds = 0.001, interruptions = 0, session = 1; DELETE FROM environment; DELETE FROM sessions WHERE id > 1;"
    succeeds report chained/$n/store.sqlite --no-figures --out report-$n
  done
  diff -r report-one report-7 >differences || fail "another report of shards: $(head -c 2000 differences)"
fi

# What is missing is told with the commands that solve it, and the words are those of a shell.
unset -n study
study=("${chained[@]}")
shards here 3
rm -r here/shards/2-of-3
run_it merge here here/shards
[ "$code" = 5 ] || fail "exit code $code of an incomplete merge, expected 5: $err"
has "$err" "slim2023 lacks 54 of 144 solves; make them with"
has "$err" "--shard 2/3 --out here/shards/2-of-3"
has_no "$err" "--shard 1/3"
bash -c "ikbench() { \"$program\" \"\$@\"; }; $(grep '  ikbench run' .err)" >.again 2>&1 || fail "the command fails: $(<.again)"
succeeds merge here here/shards
has "$out" "54 solves added from 3 stores, 90 were there"
[ "$(fingerprint here/store.sqlite)" = "$(fingerprint chained/one/store.sqlite)" ] || fail "another fingerprint after the missing shard"

# A run goes on with a store of which shards are missing.
mkdir parts && cp -r drawn/7/shards/{2,6}-of-7 parts
run_it merge holes parts
[ "$code" = 5 ] || fail "exit code $code of an incomplete merge, expected 5: $err"
succeeds run "${drawn[@]}" --out holes --no-report
[ "$(fingerprint holes/store.sqlite)" = "$(fingerprint drawn/one/store.sqlite)" ] || fail "another fingerprint of filled holes"

# Other bits, another study, no store: refused, and nothing is merged.
if command -v sqlite3 >/dev/null; then
  cp -r drawn/7/shards/2-of-7 edited
  sqlite edited/store.sqlite "UPDATE solves SET evaluations = evaluations + 1 WHERE solver = 'bat'"
  before=$(fingerprint drawn/7/store.sqlite)
  refused "has other bits in 'edited/store.sqlite' than in" merge drawn/7 edited
  has "$err" "the solve of run 1, point 2 by 'bat'"
  has "$err" "(evaluations)"
  [ "$(fingerprint drawn/7/store.sqlite)" = "$before" ] || fail "a refused merge changed the solves"
  refused "has other bits in 'edited/store.sqlite' than in 'drawn/7/shards/2-of-7/store.sqlite'" merge new drawn/7/shards/2-of-7 edited
  [ ! -e new/store.sqlite ] || fail "a refused merge left a store"
fi
succeeds run drawn.toml --set seed=2 --out other --no-report
refused "the study 'drawn' is not the same in 'drawn/7/store.sqlite' and 'other/store.sqlite': seed is 1 and 2" merge drawn/7 other
refused "'nowhere' does not exist" merge drawn/7 nowhere
mkdir empty
refused "'empty' has no store.sqlite" merge drawn/7 empty
echo text >empty/store.sqlite
refused "is not an ikbench store" merge drawn/7 empty
for shard in 0/3 4/3 3 3/ /3 a/b 1/100001 -1/3 1/3/5 ""; do
  refused "is no shard; expected I/N" run drawn.toml --shard "$shard" --out none
done
[ ! -e none ] || fail "a refused shard made a folder"
exit 0

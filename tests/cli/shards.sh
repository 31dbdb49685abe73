#!/usr/bin/env bash
# Shards, merged, are what one machine gives: the same solves, the same fingerprint, the same report.
source "$(dirname "$0")/common.sh"

command -v sqlite3 >/dev/null || fail "no sqlite3, which ./setup installs"

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
    ((n == 1)) || has "$out" ", shard $i/$n: "
    [ ! -e "$folder/shards/$i-of-$n/report.md" ] || fail "a shard has a report"
  done
}

sqlite() {
  sqlite3 "$@" || fail "sqlite3 $*"
}

for name in chained drawn; do
  declare -n study=$name
  succeeds run "${study[@]}" --out "$name/one" --no-report
  numbers "$name/one/store.sqlite" >"$name.csv"
  for n in 1 2 7 40; do
    [ $name-$n != chained-40 ] || continue # it has 8 parts
    shards "$name/$n" $n
    succeeds merge "$name/$n" "$name/$n/shards"
    same_fingerprint "$name/$n/store.sqlite" "$name/one/store.sqlite"
    numbers "$name/$n/store.sqlite" | cmp - "$name.csv" || fail "$name in $n shards: other numbers"
    succeeds run "${study[@]}" --out "$name/$n" --no-report
    has "$out" "were already stored)"
  done
done

# Merged again, one by one or with itself: nothing is added, and nothing changes.
before=$("$program" export chained/7/store.sqlite --format json | md5sum)
succeeds merge chained/7 chained/7/shards/{5,1}-of-7 chained/7/store.sqlite chained/7/shards/5-of-7/store.sqlite
has "$out" "0 solves added from 2 stores, 54 were there with the same bits" # 6 solvers x 3 points x (2 runs + 1)
[ "$("$program" export chained/7/store.sqlite --format json | md5sum)" = "$before" ] || fail "merging again changed the store"

# The same report, byte for byte, of stores whose times and sessions are made the same.
for n in one 7; do
  sqlite chained/$n/store.sqlite "UPDATE solves SET seconds = 0.001, cpu_seconds = 0.001, smallest_seconds = 0.001,
    largest_seconds = 0.001, interruptions = 0, session = 1; DELETE FROM environment; DELETE FROM sessions WHERE id > 1"
  succeeds report chained/$n/store.sqlite --no-figures --out report-$n
done
diff -r report-one report-7 >differences || fail "another report of shards: $(head -c 2000 differences)"

# The program counts what is missing.
unset -n study
study=("${chained[@]}")
shards here 3
rm -r here/shards/2-of-3
run_it merge here here/shards
[ "$code" = 5 ] || fail "exit code $code of an incomplete merge, expected 5: $err"
has "$err" "slim2023 lacks 54 of 144 solves; solve its missing shards, then merge again"
succeeds run "${study[@]}" --shard 2/3 --out here/shards/2-of-3
succeeds merge here here/shards
has "$out" "54 solves added from 3 stores, 90 were there"
same_fingerprint here/store.sqlite chained/one/store.sqlite

# More runs are merged into what there is.
for i in 1 2; do succeeds run drawn.toml --set runs=6 --shard $i/2 --out drawn/2/shards/$i-of-2; done
succeeds merge drawn/2 drawn/2/shards
has "$out" "18 solves added from 2 stores, 90 were there"
succeeds run drawn.toml --set runs=6 --out six --no-report
same_fingerprint drawn/2/store.sqlite six/store.sqlite

# A store that a kill left half-written is named, and does not stop the others.
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
run_it merge rest broken
[ "$code" = 5 ] || fail "exit code $code of a merge with a half-written store, expected 5: $out $err"
has "$out" "from 5 stores"
has "$err" "warning: left out: 'broken/3-of-7/store.sqlite' is half-written"
has "$err" "warning: left out: 'broken/4-of-7/store.sqlite' is not an ikbench store yet: it is empty"
has "$err" "solve its missing shards"

# Two merges into one new folder, of which one is refused: the good one stays, whoever is first.
mkdir bad && echo text >bad/store.sqlite
for _ in 1 2 3 4 5 6; do
  rm -rf both
  "$program" merge both bad >.bad 2>&1 &
  refused_one=$!
  "$program" merge both drawn/7/shards >.good 2>&1 &
  wait $! || fail "a good merge beside a refused one: $(<.good)"
  wait $refused_one && fail "what is no store was merged: $(<.bad)"
  same_fingerprint both/store.sqlite drawn/one/store.sqlite
  [ "$(ls -A both)" = store.sqlite ] || fail "merges left $(ls -A both)"
done
has "$(<.bad)" "'bad/store.sqlite' is not an ikbench store"

# Stopped when all is merged and it cannot yet say so: it does not say that nothing was.
mkdir late full
mkfifo full/pipe
exec 9<>full/pipe
head -c 65536 /dev/zero >&9
"$program" merge late drawn/7/shards/1-of-7 >full/pipe 2>.late &
process=$!
until [ -e late/store.sqlite ] && [ "$(ls -A late)" = store.sqlite ]; do sleep 0.1; done
sleep 0.5
kill -TERM $process
wait $process
code=$?
exec 9>&-
[ "$code" = 143 ] || fail "exit code $code after SIGTERM at the end of a merge: $(<.late)"
has "$(<.late)" "Stopped. All was merged; give the same command again to see what is missing."
[ "$(solves late/store.sqlite)" = "$(solves drawn/7/shards/1-of-7/store.sqlite)" ] || fail "not all was merged"

# A run goes on with a store of which shards are missing.
mkdir parts && cp -r drawn/7/shards/{2,6}-of-7 parts
run_it merge holes parts
[ "$code" = 5 ] || fail "exit code $code of an incomplete merge, expected 5: $err"
succeeds run "${drawn[@]}" --out holes --no-report
same_fingerprint holes/store.sqlite drawn/one/store.sqlite

# Other bits, another study, no store: refused, and nothing is merged.
cp -r drawn/7/shards/2-of-7 edited
sqlite edited/store.sqlite "UPDATE solves SET evaluations = evaluations + 1 WHERE solver = 'bat'"
refused "has other bits in 'edited/store.sqlite' than in" merge drawn/7 edited
has "$err" "the solve of run 1, point 2 by 'bat'"
has "$err" "(evaluations)"
same_fingerprint drawn/7/store.sqlite drawn/one/store.sqlite
refused "has other bits in 'edited/store.sqlite' than in 'drawn/7/shards/2-of-7/store.sqlite'" merge new drawn/7/shards/2-of-7 edited
[ ! -e new/store.sqlite ] || fail "a refused merge left a store"

# An error that does not follow from its answer is copied, and stops a report with its place.
cp -r drawn/7/shards soiled
sqlite soiled/5-of-7/store.sqlite "UPDATE solves SET position_error_cm = -1 WHERE solver = 'bat'"
succeeds merge copied soiled
refused "position_error_cm -1 is stored, but " report copied/store.sqlite --no-figures
has "$err" "study drawn, bat, run "

succeeds run drawn.toml --set seed=2 --out other --no-report
refused "the study 'drawn' is not the same in 'drawn/7/store.sqlite' and 'other/store.sqlite': seed is 1 and 2" merge drawn/7 other
sed 's/solver = "bat"/solver = "bat", options = { alpha = 0.7 }/' drawn.toml >optioned.toml
succeeds run optioned.toml --out optioned --no-report
refused "'drawn/7/store.sqlite' and 'optioned/store.sqlite': its solvers or their options are others" merge drawn/7 optioned
cp -r drawn/7/shards looped
ln -sf store.sqlite looped/3-of-7/store.sqlite
refused "cannot open 'looped/3-of-7/store.sqlite'" merge new looped
refused "'nowhere' does not exist" merge drawn/7 nowhere
mkdir empty
refused "'empty' has no store.sqlite" merge drawn/7 empty
echo text >empty/store.sqlite
refused "is not an ikbench store" merge drawn/7 empty
for shard in 0/3 4/3 3 3/ /3 a/b 1/100001 -1/3 1/3/5 ""; do
  refused "is no shard; expected I/N" run drawn.toml --shard "$shard" --out none
done
refused "--shard 9/9: slim2023 has only 8 runs to share out" run "${chained[@]}" --shard 9/9 --out none
refused "--shard 1/46: drawn has only 45 targets to share out" run drawn.toml --shard 1/46 --out none
refused "OUT: the name is empty" merge "" drawn/7/shards
refused "--out: the name is empty" run drawn.toml --out ""
[ ! -e none ] || fail "a refused shard made a folder"
exit 0

#!/usr/bin/env bash
# Jobs, and everything else that is no part of the study, change no number.
source "$(dirname "$0")/common.sh"

succeeds run slim2023 "${small[@]}" --no-report --out one
numbers one/store.sqlite >one.csv
[ "$(wc -l <one.csv)" = 37 ] || fail "36 solves expected" # 6 solvers x 2 runs x 3 points
for jobs in 2 3; do
  succeeds run slim2023 "${small[@]}" --no-report --out "jobs-$jobs" --jobs $jobs
  numbers "jobs-$jobs/store.sqlite" | cmp - one.csv || fail "--jobs $jobs gives other numbers"
done

# The same study from the file that `list` writes.
succeeds list studies slim2023
cp .out slim.toml
succeeds run slim.toml "${small[@]}" --no-report --out file
numbers file/store.sqlite | cmp - one.csv || fail "the study from its file gives other numbers"

# Another seed does.
succeeds run slim2023 "${small[@]}" --set seed=2 --no-report --out seed-2
numbers seed-2/store.sqlite | cmp -s - one.csv && fail "--set seed=2 gives the same numbers"

# The default folder is out/<name>.
succeeds run slim2023 "${small[@]}" --no-report
numbers out/slim2023/store.sqlite | cmp - one.csv || fail "out/slim2023 has other numbers"
# Names that differ only in what no folder can have, too, have folders of their own.
for name in a/b 'a b'; do
  succeeds run slim2023 "${small[@]}" --set "name=$name" --set runs=1 --no-report
done
[ "$(find out -name 'a_b-*' | wc -l)" = 2 ] || fail "a/b and 'a b' are in: $(ls out)"
exit 0

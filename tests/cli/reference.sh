#!/usr/bin/env bash
# The papers' studies give the reference numbers, bit by bit; and their first two runs, with every instruction set of
# this machine and other numbers of threads, those of the whole.
source "$(dirname "$0")/common.sh"

references=$scripts/../../results/reference.inc
studies=(slim2023 slim2023-context slim2023-all-joints slim2023-limits slim2023-bounds slim2023-elongation slim2023-time slim2023-dobot)

succeeds reproduce --verbose --jobs 4 --quick --no-figures --out whole
for study in "${studies[@]}"; do
  has "$out" "Fingerprint of $study: $(grep "\"$study\"" "$references" | cut -d'"' -f4), equal to the reference"
  numbers whole/store.sqlite "$study" |
    awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "run") run = i } NR == 1 || $run <= 2' >"whole-$study.csv"
  [ "$(wc -l <"whole-$study.csv")" -gt 1 ] || fail "no first runs of $study"
done

mapfile -t sets < <("$program" list instruction-sets | tail -n +2 | cut -d' ' -f1)
for i in "${!sets[@]}"; do
  set=${sets[i]}
  export IKBENCH_INSTRUCTION_SET=$set
  succeeds list instruction-sets
  has "$(tr -s ' ' <.out)" "$set yes"
  succeeds reproduce --verbose --runs 2 --jobs $((${#sets[@]} - i)) --quick --no-figures --out "$set"
  for study in "${studies[@]}"; do
    numbers "$set/store.sqlite" "$study" | cmp - "whole-$study.csv" || fail "$study with $set: other numbers"
  done
done
unset IKBENCH_INSTRUCTION_SET

# Whole poses of another paper, too.
succeeds run beeson2015 --jobs 4 --no-report --out poses
has "$("$program" export poses/store.sqlite --format fingerprint)" "$(grep '"beeson2015"' "$references" | cut -d'"' -f4)"

# Another seed has no reference.
succeeds reproduce --verbose --seed 2 --runs 1 --quick --no-figures --out seed-2
has "$out" "no reference for this seed and number of runs"

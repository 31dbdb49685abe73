#!/usr/bin/env bash
# The paper's studies give the reference numbers, bit by bit, with every instruction set of this machine and any number
# of threads. After a change that is meant to give others: docs/renew-reference.
source "$(dirname "$0")/common.sh"

references=$scripts/../../results/reference.inc

# gives_the_reference FOLDER JOBS
gives_the_reference() {
  succeeds reproduce --jobs "$2" --quick --no-figures --out "$1"
  for study in slim2023 slim2023-context slim2023-limits slim2023-bounds slim2023-frequency slim2023-time slim2023-dobot; do
    has "$out" "Fingerprint of $study: $(grep "\"$study\"" "$references" | cut -d'"' -f4), equal to the reference"
  done
}

# Each instruction set with another number of threads: both change nothing, so each stands for the others (docs/same-bits
# has all combinations).
jobs=4
for set in $("$program" list instruction-sets | tail -n +2 | cut -d' ' -f1); do
  export IKBENCH_INSTRUCTION_SET=$set
  succeeds list instruction-sets
  has "$(tr -s ' ' <.out)" "$set yes"
  gives_the_reference "$set" $jobs
  jobs=$(((jobs + 1) / 2))
done
unset IKBENCH_INSTRUCTION_SET

# Another seed has no reference.
succeeds reproduce --seed 2 --runs 1 --quick --no-figures --out seed-2
has "$out" "no reference for this seed and number of runs"

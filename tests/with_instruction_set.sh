#!/usr/bin/env bash
# Runs a program of tests with the instruction set that IKBENCH_INSTRUCTION_SET names: with_instruction_set.sh IKBENCH
# PROGRAM ARGUMENT... Skipped where the machine does not run it, and where it is the machine's best: every test by itself
# has run with that.
set -euo pipefail
export LC_ALL=C.UTF-8
ikbench=$1 set=$IKBENCH_INSTRUCTION_SET
shift
listed=$(env -u IKBENCH_INSTRUCTION_SET "$ikbench" list instruction-sets)
sets=$(tail -n +2 <<<"$listed" | cut -d ' ' -f 1)
grep -qxF -- "$set" <<<"$sets" || { echo "skipped: this machine does not run $set"; exit 77; }
[[ $set != "$(tail -n 1 <<<"$sets")" ]] || { echo "skipped: $set is what this machine runs anyway"; exit 77; }
exec "$@"

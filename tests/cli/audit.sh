#!/usr/bin/env bash
# The audit of the paper: printed without a solve, and written where asked.
source "$(dirname "$0")/common.sh"

succeeds audit --verbose slim2023
quiet
has "$out" "Table 7, 20 bats"
has "$out" "the mean exceeds the maximum"
has "$out" "less than 50 ms" # and "not meeting", in one section
[[ $out =~ ^[0-9]+\ checks:\ [0-9]+\ consistent,\ [0-9]+\ rounding,\ [0-9]+\ misprint,\ [0-9]+\ not\ supported,\ [0-9]+\ contradiction$'\n' ]] ||
  fail "the first line is: ${out%%$'\n'*}"
[ -z "$(ls)" ] || fail "it wrote something: $(ls)"

succeeds audit --verbose slim2023 --out folder
for type in md csv tex; do [ -s "folder/tables/audit.$type" ] || fail "no audit.$type"; done
[ "$(head -1 folder/tables/audit.csv)" = "id,where,printed,follows,verdict,why" ] || fail "$(head -1 folder/tables/audit.csv)"

refused 'unknown paper "nobody1999"' audit nobody1999
succeeds audit --verbose # of the first paper
has "$out" "Table 7, 20 bats"
echo "a file" >file
refused 'file' audit slim2023 --out file

#!/usr/bin/env bash
# The fingerprint of a study: a line each, the same however the study was run, another for other numbers.
source "$(dirname "$0")/common.sh"

succeeds run slim2023 "${small[@]}" --no-report --out one
succeeds run slim2023-context "${small[@]}" --no-report --out one
succeeds fingerprint one/store.sqlite
[[ $out =~ ^[0-9a-f]{32}\ \ 36\ \ slim2023$'\n'[0-9a-f]{32}\ \ 12\ \ slim2023-context$ ]] || fail "it said: $out"
quiet
[ -z "$err" ] || fail "fingerprint wrote to the standard error: $err"
first=$(head -n 1 .out)
second=$(tail -n 1 .out)
succeeds fingerprint one/store.sqlite --study slim2023-context
[ "$out" = "$second" ] || fail "--study slim2023-context: $out"
refused "no study 'none'" fingerprint one/store.sqlite --study none

# Jobs, and the order in which solves came into the store, are no part of it; the seed is.
succeeds run slim2023 "${small[@]}" --no-report --jobs 3 --out many
succeeds fingerprint many/store.sqlite
[ "$out" = "$first" ] || fail "--jobs 3: $out instead of $first"
succeeds run slim2023 "${small[@]}" --set runs=1 --no-report --out parts
succeeds run slim2023 "${small[@]}" --no-report --out parts
succeeds fingerprint parts/store.sqlite
[ "$out" = "$first" ] || fail "in two parts: $out instead of $first"
succeeds run slim2023 "${small[@]}" --set seed=2 --no-report --out seed-2
succeeds fingerprint seed-2/store.sqlite
[ "$out" != "$first" ] || fail "the same fingerprint with another seed"

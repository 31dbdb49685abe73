#!/usr/bin/env bash
# Every command explains itself, with an example.
source "$(dirname "$0")/common.sh"

succeeds --help
has "$out" "Examples:"
has "$out" "Exit codes:"
has "$out" "1 a mistake in the request or a damaged store, 2 a failure of the program or the system"
has "$out" "5 more runs are needed (compare --sequential) or solves are missing (merge, status)"
has "$out" "6 the status of the answer is not ok (solve)"
all=$out
for command in reproduce run merge submit status report stats audit compare multiverse list robot solve export import fingerprint check-solver; do
  has "$all" "  $command "
  succeeds "$command" --help
  has "$out" "Examples:"
  has "$out" "ikbench $command"
  [ -z "$err" ] || fail "$command --help wrote to the standard error: $err"
  quiet
done

succeeds host --help # which a study starts
has "$out" "ikbench host ./libmine.so"
has_no "$all" "  host "

succeeds --version
[[ $out =~ ^ikbench\ [0-9]+\.[0-9]+\.[0-9]+\ \(.+\)$ ]] || fail "--version says: $out"
[[ $out != *$'\n'* ]] || fail "--version says more than a line: $out"

run_it
[ "$code" = 1 ] || fail "without a command: exit code $code"
has "$err" "--help"

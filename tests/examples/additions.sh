#!/usr/bin/env bash
# The examples of docs/adding-anything.md in the program: a command, an export format, a table and a figure.
source "$(dirname "$0")/../cli/common.sh"

succeeds --help
has "$out" "  count  "
study mine
succeeds run mine.toml --no-figures --out made
store=made/store.sqlite
succeeds count $store
[ "$out" = "16 mine" ] || fail "two runs of eight points are 16 solves, not $out"
run_it count none.sqlite
[ "$code" = 1 ] || fail "exit code $code without a store"

succeeds export --help
has "$out" "answers: a line of JSON for each solve"
succeeds export $store --format answers
[ "$(wc -l <.out)" = 16 ] || fail "not a line for each solve: $out"
[[ $(head -1 .out) =~ ^\{\"solver\":\"DLS\",\"run\":1,\"point\":1,\"answer_rad\":\[[-0-9.,e]+\]\}$ ]] || fail "$out"

succeeds list pieces
has "$out" "worst "
has "$out" "the error of every solve against its evaluations"
report=$(<made/report.md)
[[ $report == *$'\n## Analysis of variance\n'*$'\n## Worst solves\n'*"The solve with the largest error"*"Error of every solve against its evaluations"*$'\n## '* ]] ||
  fail "table and figure are not under their heading: $report"
largest=$(column $store position_error_cm DLS | sort -g | tail -1)
has "$(sed -n 2p made/tables/worst.csv)" ",$largest"
[ "$(grep -c '^[0-9]' made/figures/effort.dat)" = 16 ] || fail "not every solve is in the figure"

# The figure is drawn.
command -v gnuplot >/dev/null || exit 0
succeeds report $store --out drawn
has_no "$err" "not drawn"
[ -s drawn/figures/effort.svg ] || fail "the figure was not drawn: $(ls drawn/figures)"

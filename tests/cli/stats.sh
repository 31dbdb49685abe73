#!/usr/bin/env bash
# The command stats: a CSV from anywhere is judged, or refused in one sentence that says what to do.
source "$(dirname "$0")/common.sh"
root=$(realpath "$scripts/../..")
data=$root/tests/data/csv

# A file with one column of numbers and one of labels needs no options.
succeeds stats "$data/runmeans.csv"
quiet
has "$out" "A is better than B"
[ "$(wc -l <.out)" -le 20 ] || fail "more than 20 lines: $out"
[ ! -e out ] || fail "a report that nobody asked for"
"$program" stats - <"$data/runmeans.csv" >.from_input || fail "standard input"
cmp -s .from_input .out || fail "standard input gives another answer: $(<.from_input)"

# Options.
succeeds stats "$data/ten.csv" --block problem
has "$out" "A is better than B"
succeeds stats "$data/drift.csv" --margin 1
has "$(head -n 1 .out)" "20 of 20 values of drift are negative"
has "$out" "same within 1"
refused "means nothing" stats "$data/drift.csv" --margin 5%
succeeds stats "$data/mixed-metrics.csv" --value value --where metric=error
refused "--where 'metric=error'" stats "$data/mixed-metrics.csv" --value value --run seed
succeeds stats "$data/stray-label.csv"
has "$out" "4 of 12 rows have no label"
succeeds stats "$data/zero.csv" --control B
has "$out" "Against B"
printf 'wer;wert\nA;0,5\nA;0,6\nA;0,55\nA;0,52\nB;0,7\nB;0,8\nB;0,75\nB;0,72\n' >comma.csv
succeeds stats comma.csv
smaller=$out
has "$out" "A is better than B"
succeeds stats comma.csv --larger --separator ';' --decimal ,
has "$out" "B is better than A"
succeeds stats --summaries "$root/results/published/slim2023/table-3.csv"
has "$out" "IK-BA is best"
has "$out" "its mean error is 0.0019 cm"

# A report, and the same answer as data.
succeeds stats comma.csv --out new/report
has "$out" "Report: new/report/report.html"
[ "$(head -n -1 .out)" = "$smaller" ] || fail "another answer with a report: $out"
for file in report.html report.md results.json tables/pairs.csv tables/descriptives.tex; do
  [ -s "new/report/$file" ] || fail "no $file"
done
[ ! -e new/report/solves.csv ] || fail "solves of a file that has none"

# What an export says, and what it lacks.
"$program" list studies slim2023 | sed 's/^name = .*/name = "mine"/; /^published = /d' >mine.toml
succeeds run mine.toml --set runs=4 --set path.points=3 --set stop.iterations=5 --no-report --out mine
"$program" export mine/store.sqlite >solves.csv
refused "--run run" stats solves.csv --value position_error_cm
refused "how busy the machine was" stats solves.csv --value seconds --run run
succeeds stats solves.csv --value position_error_cm --value evaluations --run run

# Mistakes.
refused "cannot read none.csv" stats none.csv
refused "cannot read mine" stats mine
refused "several" stats solves.csv --value position_error_cm --block point
refused 'did you mean "wert"' stats comma.csv --value wrt
refused "--test" stats comma.csv --test bootstrap
refused "comma.csv:2:2: '0,5'" stats comma.csv --decimal .
printf 's,v\n"\e[31mred\n",x1\n' >hostile.csv
refused "hostile.csv:2:2: 'x1'" stats hostile.csv --value v
printf 's,v\n"\e[31mred<b>",1\nB,2\n' >hostile.csv
succeeds stats hostile.csv --out hostile
[[ $out != *$'\e'* ]] || fail "a label that colours the terminal"
has_no "$(<hostile/report.html)" "red<b>"

command -v python3 >/dev/null || exit 77
"$program" stats comma.csv --json --out new/report | python3 -c '
import json, sys
of = json.load(sys.stdin)
assert set(of) >= {"groups", "tests", "findings", "doubts", "files"}, of.keys()
finding, = of["findings"]
assert finding["verdict"] == "better" and finding["first"] == "A" and 0 < finding["p"] < 0.05, finding
assert len(of["groups"]) == 2 and "report.html" in of["files"], of' || fail "--json"

#!/usr/bin/env bash
# Somebody else's solves beside those of a study: verified where they have answers, told where they have not.
source "$(dirname "$0")/common.sh"

cat >study.toml <<'TOML'
name = "arms"
robot = "planar_2"
search = "all_joints"
start = "middle"
runs = 3
repeats = 1
[path]
kind = "random"
points = 2
[stop]
iterations = 20
tolerance_cm = 1
[[solvers]]
solver = "random_search"
[[solvers]]
label = "DLS"
solver = "damped_least_squares"
TOML
refused 'ikbench run STUDY --out nothing' import any.csv --out nothing
[ ! -e nothing ] || fail "a store was made by an import"
succeeds run study.toml --no-report --out made
numbers made/store.sqlite >before

# The answers of DLS as somebody else's, all digits: verified, with the same errors.
"$program" export made/store.sqlite >all.csv
columns() { awk -F, -v want="$1" 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; n = split(want, w, " ") }
  NR == 1 || $at["solver"] == "DLS" { for (k = 1; k <= n; ++k) printf "%s%s", $at[w[k]], k < n ? "," : "\n" }' all.csv; }
columns "run point answer_rad_1 answer_rad_2 target_position_m_1 target_position_m_2 target_position_m_3 reached_position_m_1" >mine.csv
succeeds import mine.csv --out made --no-report
has "$out" "mine: 6 solves; 6 verified, 0 not verified"
has "$err" "not imported: reached_position_m_1"
numbers made/store.sqlite >after
cmp <(grep -v ',mine,' after) before || fail "an import changes the numbers of others"
[ "$(grep -c ',mine,' after)" = 6 ] || fail "not 6 solves of mine: $(<after)"
"$program" export made/store.sqlite >all.csv
of() { awk -F, -v who="$1" -v want="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; n = split(want, w, " ") }
  NR > 1 && $at["solver"] == who { for (k = 1; k <= n; ++k) printf "%s ", $at[w[k]]; print "" }' all.csv; }
same="run point position_error_cm variation_deg status"
cmp <(of DLS "$same") <(of mine "$same") || fail "the same answers are judged in another way: $(of mine "$same")"
[ "$(of mine "evaluations seconds timing counted_by" | sort -u)" = " NaN imported nobody " ] ||
  fail "what the file does not say is known: $(of mine "evaluations seconds timing counted_by")"

# Again: nothing is added. An edited file replaces it; a run keeps it.
succeeds import mine.csv --out made --no-report
has "$out" "which were in the store already"
awk -F, 'BEGIN { OFS = "," } NR == 2 { $3 = ""; $4 = "" } { print }' mine.csv >edited.csv
succeeds import edited.csv --label mine --out made --no-report
has "$out" "mine: 6 solves; 5 verified, 0 not verified, 1 without an answer"
succeeds run study.toml --no-report --out made
[ "$("$program" export made/store.sqlite | grep -c ',mine,')" = 6 ] || fail "a run loses what was imported"

# Errors alone, in centimetres; in a report both are told as what they are.
{ echo "solver,run,point,position_error_cm,evaluations,seconds"
  for run in 1 2 3; do for point in 1 2; do echo "theirs,$run,$point,0.0$run$point,100,0.00$point"; done; done; } >theirs.csv
succeeds import theirs.csv --no-figures --out made
has "$out" "theirs: 6 solves; 0 verified, 6 not verified"
has_no "$err$out" "Damaged"
has "$err" "theirs was imported from theirs.csv: its errors are not verified"
has "$err" "mine was imported from edited.csv: its answers are verified"
has "$err" "Times are not comparable"
grep -q 'theirs' made/report.md && grep -q 'not verified' made/report.md || fail "the report does not name it"
has_no "$(<made/report.md)" "There are no blocks" # the targets are those of all, whatever the starts were
"$program" export made/store.sqlite >all.csv
[ "$(of theirs "status evaluations counted_by position_error_cm" | head -n 1)" = "not_verified 100 solver 0.011 " ] ||
  fail "errors alone are: $(of theirs "status evaluations counted_by position_error_cm")"

# Solves of fewer runs than the study has are no missing solves: nothing here makes them.
awk -F, '$1 != 3' mine.csv >fewer.csv
succeeds run study.toml --no-report --out few
succeeds import fewer.csv --label fewer --out few --no-report
has "$out" "fewer: 4 solves; 4 verified"
succeeds status few
has "$out" "Merged: 12 of 12 solves"
succeeds report few/store.sqlite --no-figures
has "$(<few/report.md)" "Not comparable: imported, fewer has 4 of 6 solves"
has "$(<few/report.md)" "Left out: fewer, imported without runs that the others have."
has_no "$(<few/report.md)" "Left out: 1 of 3 runs"
succeeds merge merged few
has_no "$out$err" "lacks"
succeeds status merged
has "$out" "Merged: 12 of 12 solves"

# Mistakes, by line and column; what is no file has no end.
refused "zero:1: a NUL byte" import /dev/zero --out made --no-report
mistake() { # mistake WORDS, with the CSV on the standard input
  cat >wrong.csv
  refused "$1" import wrong.csv --out made --no-report
}
mistake "wrong.csv:1: no column 'answer_rad_2'" <<<$'run,point,answer_rad_1\n1,1,0'
mistake 'wrong.csv:1: unknown column "evaluation"; did you mean "evaluations"?' <<<$'run,point,evaluation\n1,1,0'
mistake "wrong.csv:1: neither answers nor errors" <<<$'run,point,seconds\n1,1,0'
mistake "the arm has 2 joints" <<<$'run,point,answer_rad_1,answer_rad_2,answer_rad_3\n1,1,0,0,0'
mistake "wrong.csv:4: answer_deg_2 is 'x'; expected a number" <<<$'run,point,answer_deg_1,answer_deg_2\n1,1,0,0\n\n1,2,0,x'
mistake "wrong.csv:2: point is '0'; expected a whole number" <<<$'run,point,position_error_cm\n1,0,1'
mistake "wrong.csv:2: position_error_cm is '-1'" <<<$'run,point,position_error_cm\n1,1,-1'
mistake "wrong.csv:2: run 7, point 1 is not among the solves" <<<$'run,point,position_error_cm\n7,1,1'
mistake "run 1 of wrong has no point 2" <<<$'run,point,position_error_cm\n1,1,1'
mistake "is there already (wrong.csv:2)" <<<$'run,point,position_error_cm\n1,1,1\n1,1,1'
mistake "expected the name of a solver" <<<$'solver,run,point,position_error_cm\nC\xc2\x9b1,1,1,1'
mistake "a solver named 'DLS' of its own" <<<$'solver,run,point,position_error_cm\nDLS,1,1,1\nDLS,1,2,1'
mistake "expected solves of this study's targets" <<<$'run,point,position_error_cm,target_position_m_1,target_position_m_2,target_position_m_3\n1,1,1,9,9,9\n1,2,1,9,9,9'
mistake "neither an answer nor an error" <<<$'run,point,position_error_cm\n1,1,1\n1,2,'
numbers made/store.sqlite | grep -v ',mine,\|,theirs,' | cmp - before || fail "a mistake changes a store"

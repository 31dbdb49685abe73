#!/usr/bin/env bash
# The statistics of data from anywhere: right where they can be, refused in one sentence where not, and text stays text.
source "$(dirname "$0")/common.sh"
published=$(realpath "$scripts/../../results/published/slim2023/table-3.csv")

# has_valid_json FILE: strict JSON, without NaN and Infinity.
has_valid_json() {
  command -v python3 >/dev/null || return 0
  python3 -c '
import json, sys
def strict(constant):
    raise ValueError(constant)
json.load(open(sys.argv[1], encoding="utf-8"), parse_constant=strict)' "$1" || fail "$1 is not JSON"
}

# has_outputs FOLDER NAME PARTS...: the page, the report, the numbers and the tables of one quantity.
has_outputs() {
  local folder=$1 name=$2 part type
  shift 2
  for part in report.html report.md statistics.json; do [ -s "$folder/$part" ] || fail "no $folder/$part"; done
  has_valid_json "$folder/statistics.json"
  for part in "$@"; do
    for type in md csv tex; do
      [ -s "$folder/tables/statistics-$name-$part.$type" ] || fail "no table $part.$type of $name in $folder"
    done
  done
}

has_figures() {
  local folder=$1 name=$2 part type types="gp dat"
  shift 2
  if command -v gnuplot >/dev/null; then types+=" svg pdf png"; fi
  for part in "$@"; do
    for type in $types; do
      [ -s "$folder/figures/statistics-$name-$part.$type" ] || fail "no figure $part.$type of $name in $folder"
    done
  done
}

# rows NAME VALUES... [NAME VALUES...]: a CSV with the columns solver and error; values of one name are one word.
rows() {
  echo solver,error
  for ((; $# > 0; )); do
    for value in $2; do echo "$1,$value"; done
    shift 2
  done
}

### What users have.

# pandas' to_csv: an index column, NaN, an empty cell.
printf ',solver,error\n0,A,1.0\n1,A,1.2\n2,A,NaN\n3,A,1.1\n4,B,2.0\n5,B,2.5\n6,B,2.25\n7,B,\n' >pandas.csv
succeeds stats --verbose pandas.csv --value error
quiet
has "$out" "smaller is better; 2 groups (A and B) with 3 observations each"
has "$out" "Values are missing: 1 of 4 values of A, 1 of 4 of B. "
has "$out" "In short: A is better than B: mean 1.1 vs 2.25, by " # by hand: (1 + 1.2 + 1.1) / 3, (2 + 2.5 + 2.25) / 3
[ "$(tail -n 1 .out)" = "Report: out/stats-pandas/report.html" ] || fail "the last line is: $(tail -n 1 .out)"
has_outputs out/stats-pandas error groups tests contrasts
has_figures out/stats-pandas error observations differences
[ "$(ls)" = $'out\npandas.csv' ] || fail "something beside out/ was written: $(ls)"
has "$(<out/stats-pandas/report.md)" "ikbench stats --verbose pandas.csv --value error"
# The page has no heading without anything below it.
for words in '>Verdict<' '>Everything else<' 'store alone'; do has_no "$(<out/stats-pandas/report.html)" "$words"; done

# R's write.csv: everything quoted, row names, NA.
printf '"","solver","error"\r\n"1","A",1.0\r\n"2","A",NA\r\n"3","A",1.5\r\n"4","B",2\r\n"5","B",2.5\r\n' >r.csv
succeeds stats --verbose r.csv --value error --larger-is-better --no-figures --out r
has "$out" "larger is better; 2 groups (A and B) with 2 observations each"
has_outputs r error groups tests contrasts
[ -z "$(find r -name '*.svg' -o -name '*.png' -o -name '*.pdf')" ] || fail "--no-figures drew figures"
[ "$(ls out)" = stats-pandas ] || fail "--out wrote elsewhere: $(ls out)"

# A column a group; the same with its rows as blocks.
printf 'A,B,C\n1,2,3\n2,3,4\n1.5,2.5,3.25\n1.75,2,3.5\n' >wide.csv
succeeds stats --verbose wide.csv --wide --no-figures --out wide
has "$out" "; 3 groups (A, B and C) with 4 observations each"
has "$out" "Methods: Studentized bootstrap of the means decides"
succeeds stats --verbose wide.csv --wide --rows-are-blocks --value AUC --larger-is-better --out blocks
has "$out" "All groups share 4 blocks"
has "$out" "Methods: Studentized bootstrap of the differences within blocks decides"
has "$out" "Caution: no pair can differ by this test. It takes at least 5 blocks, and here are 4." # 5^-4 is below 0.025 / 3
has_outputs blocks auc groups tests contrasts
has_figures blocks auc observations differences

# Blocks in a column.
printf 'problem,solver,error\np1,A,1\np1,B,2\np2,A,2\np2,B,3\np3,A,1\np3,B,1.5\np4,A,1\n' >blocks.csv
succeeds stats --verbose blocks.csv --value error --block problem --test tamhane --no-figures --out blocked
has "$out" "All groups share 3 blocks"
has "$out" "Values are missing: 1 of 4 blocks of B; these blocks are left out for all groups. "

# Geometric means, of runs too.
printf 'solver,run,error\nA,1,1\nA,1,100\nA,2,10\nA,2,10\nB,1,2\nB,1,2\nB,2,2\nB,2,3\n' >decades.csv
succeeds stats --verbose decades.csv --value error --run run --estimand typical --no-figures --out decades
quiet
has "$out" "Statistics: typical error"
has "$(<decades/tables/statistics-typical-error-groups.csv)" "geometric mean"
has "$(<decades/tables/statistics-typical-error-groups.csv)" "A,2,,10,"
sed 's/100/0/' decades.csv >zero.csv
refused "zero.csv: row 2 below the header: 0 has no logarithm" stats zero.csv --value error --estimand typical
refused "--estimand is typical; expected mean" stats --summaries "$published" --estimand typical

# Problems of any scale, three seeds each: B crashes in the worst seed of the hardest, its row is not there.
{
  echo problem,seed,solver,error
  for seed in 1 2 3; do
    for problem in 0.01 0.1 1 10 100; do
      for solver in A B; do
        [ $seed$problem$solver = 3100B ] || echo "$problem,$seed,$solver,$(awk "BEGIN { print $problem * (1 + $seed / 100) }")"
      done
    done
  done
} >crashes.csv
refused "5 rows share seed 1 of A, and are not replicates; " stats crashes.csv --value error
succeeds stats --verbose crashes.csv --value error --block problem --run seed --no-figures --out crashes
[[ $(sed -n 2p .out) == "Flawed: Values are missing: 1 of 5 blocks of B; "* ]] ||
  fail "the first lines do not warn of what B lacks: $out"
has "$err" "warning: Values are missing: 1 of 5 blocks of B"
has "$out" "with 4 observations each. One observation is the mean over the 3 runs of a block"
succeeds stats --verbose crashes.csv --value error --block problem --run seed --force --no-figures --out crashes
has "$out" "One observation is the mean over the 2 to 3 runs of a block"
has "$out" "Flawed: Fewer values than the fullest have 1 of 5 blocks of B. "

# Twenty runs of two rows each, of which B crashed on five altogether: they are not there.
{
  echo solver,run,error
  for run in {1..20}; do
    echo "A,$run,$run" && echo "A,$run,$((run + 2))"
    [ $run -gt 15 ] || { echo "B,$run,$run" && echo "B,$run,$((run + 1))"; }
  done
} >absent.csv
succeeds stats --verbose absent.csv --value error --run run --no-figures --out absent
[[ $(sed -n 2p .out) == "Flawed: Values are missing: 5 of 20 runs of B. A group that failed there looks better"* ]] ||
  fail "the first lines do not warn of runs that B lacks: $out"
has "$err" "warning: Values are missing: 5 of 20 runs of B"
{ cat absent.csv && echo A,1,1; } >doubled.csv
refused "only 1 of 35 runs have 3 rows; a row may be duplicated, or rows may be missing; --force averages them as they are" \
  stats doubled.csv --value error --run run

# Two columns that are one name for a file, one of them without a Latin letter.
printf 'solver,a b,a-b,誤差,плечо\nA,1,2,3,1\nA,2,3,5,1.5\nB,2,2,8,2\nB,2.5,1,3,3\n' >names.csv
succeeds stats --verbose names.csv --value 'a b' --value a-b --value 誤差 --value плечо --no-figures --out names
has_outputs names a-b groups
has_outputs names a-b-2 groups
has_outputs names value groups
has_outputs names value-2 groups
has "$(<names/tables/statistics-value-2-groups.md)" "плечо"

# Standard input.
"$program" stats - --value error --no-figures --out piped <pandas.csv >.out 2>.err || fail "standard input: $(<.err)"
has_outputs piped error groups

# A margin in cm, of what is in cm.
succeeds stats --verbose pandas.csv --value error --quantity 'error [cm]' --margin-cm 3 --no-figures --out cm
has "$out" "In short: A is better than B: mean 1.1 vs 2.25, by "
has "$out" "less than 3 cm (p = "

# For values that may be negative, a share is no margin.
printf 'solver,t\n' >cold.csv
for i in 1 2 3 4 5 6 7 8 9 10; do printf 'A,-0.%d\nB,0.%d\nC,-0.%d1\n' $i $i $i; done >>cold.csv
refused 't has negative values, and 5 % of a mean that may be 0 means nothing; expected --margin-absolute DIFFERENCE' stats cold.csv --value t
refused '--margin excludes --margin-absolute' stats cold.csv --value t --margin-absolute 3 --margin 5%
succeeds stats --verbose cold.csv --value t --margin-absolute 3 --no-figures --out cold
has "$out" "C and A are the same within 3 ("
has "$out" "differences below 3 do not matter"
for margin in 0.0 -0 0% 0; do succeeds stats --verbose cold.csv --value t --margin=$margin --no-figures --out cold; done
printf 'name,mean,sd,n\nA,-1,2,9\nB,1,2,9\n' >cold.csv
refused 'has negative values' stats --summaries cold.csv

### What was published: Table 3 of the paper.

succeeds stats --verbose --summaries "$published" --out published
for name in position-error-cm variation-deg seconds; do
  has_outputs published $name groups tests contrasts
  has_figures published $name differences
done
of_quantity() { awk -v name="Statistics: $1" '/^Statistics: / { is_it = index($0, name) == 1 } is_it' .out; }
error=$(of_quantity position_error_cm) variation=$(of_quantity variation_deg) seconds=$(of_quantity seconds)
# R 4.2.2, aov and oneway.test on the printed means and standard deviations.
has "$(<published/tables/statistics-position-error-cm-tests.csv)" "One-way ANOVA,F,40.77"
has "$out" "Welch's ANOVA: F(5, 44.3) = 141.8"
has "$error" "IK-BA is better than K-ABC, DE, MO-PSO, PSO and BA"
has "$variation" "IK-BA against MO-PSO is undecided (p > 0.999;"
has_no "$variation" "IK-BA is better than MO-PSO"
has "$seconds" "PSO is better than IK-BA, "
has "$seconds" "Against IK-BA, the best of these: mean 0.207 vs 0.244"
grep -q '^IK-BA,PSO,PSO is better by ' published/tables/statistics-seconds-contrasts.csv ||
  fail "the table does not say that PSO is better in seconds"

# Without a column of quantities.
printf 'name,mean,sd,n\nA,1,0.1,20\nB,2,0.2,20\nC,7,,1\n' >summaries.csv
succeeds stats --verbose --summaries summaries.csv --quantity 'position error [cm]' --no-figures --out summaries
has "$out" "Statistics: position error [cm]"
has "$out" "C has a single value, so it has no spread"

### Points of one run are no replicates.

succeeds run slim2023 "${small[@]}" --set runs=3 --no-report --out made
"$program" export made/store.sqlite >solves.csv || fail "cannot export"
from_store() { # ARGUMENTS...: as `ikbench export STORE | ikbench stats - ...`
  "$program" stats - --value position_error_cm --group solver "$@" <solves.csv >.out 2>.err
  code=$? out=$(<.out) err=$(<.err)
}
from_store --no-figures --out dependent
[ "$code" = 1 ] || fail "points of one run were taken as replicates: $out"
[ -z "$out" ] && [ "$(grep -vc '^  ' .err)" = 1 ] || fail "not one sentence: $out $err"
has "$err" "share run 1 of IK-BA, and are not replicates; average rows that depend on each other, such as points of a path, with --run run; compare problems that were solved separately within blocks with --block COLUMN --run run; or use --force"
[ ! -e dependent ] || fail "a refused report was written"
from_store --verbose --run run --no-figures --out means
[ "$code" = 0 ] || fail "--run run: $err"
has "$out" "with 3 observations each. One observation is the mean of a run over its 3 rows of standard input."
has_no "$out$err" "Flawed"
from_store --force --no-figures --out forced
[ "$code" = 0 ] || fail "--force: $err"
has "$out" "Flawed: "
has "$err" "warning: 3 rows share run 1 of IK-BA"
for part in groups tests contrasts; do
  for type in md tex; do
    has "$(<forced/tables/statistics-position-error-cm-$part.$type)" "Flawed: "
  done
done
has "$(sed '/^## Statistics/q' forced/report.md)" "points of one run depend on each other" # at its top
has "$(<forced/report.html)" "points of one run depend on each other"
has "$(<forced/statistics.json)" '"flaw": "3 rows share run 1 of IK-BA'

### Mistakes.

before=$(ls)
refused 'cannot read none.csv' stats none.csv --value error
refused 'made is a folder' stats made --value error
: >empty.csv
refused 'empty.csv:1: the file is empty' stats empty.csv --value error
refused 'standard input:1: the file is empty' stats - --value error
refused "no column 'eror'; expected one of: (empty), solver, error; did you mean \"error\"?" stats pandas.csv --value eror
refused "no column 'slover'; expected one of:" stats pandas.csv --value error --group slover
refused "no column 'problem'; expected one of:" stats pandas.csv --value error --block problem
refused 'no column of groups; name one with --group: problem, error' stats <(printf 'problem,error\n1,2\n') --value error
printf 'solver,error\nA,"1,5"\n' >decimal.csv
refused "'1,5', expected a number with a decimal point" stats decimal.csv --value error
printf 'solver;error\nA;1,5\n' >semicolons.csv
refused 'no commas between the columns' stats semicolons.csv --value error
refused 'expected --value COLUMN' stats pandas.csv
refused 'either a CSV file of observations or --summaries' stats
refused 'either a CSV file of observations or --summaries' stats pandas.csv --summaries summaries.csv
refused '--summaries has its own columns' stats --summaries summaries.csv --value mean
refused '--value names a column twice' stats pandas.csv --value error --value error
refused '--quantity names one quantity' stats names.csv --value 'a b' --value a-b --quantity 'error [cm]'
refused '--quantity names one quantity' stats --summaries "$published" --quantity 'error [cm]'
refused "no group 'Z' for the control; expected one of: A, B" stats pandas.csv --value error --control Z
refused "the kruskal_wallis test needs single values; expected one of these for summaries: tamhane" stats --summaries summaries.csv --test kruskal_wallis
refused '--test: welsh is not one of by_design, bootstrap, tamhane, kruskal_wallis' stats pandas.csv --value error --test welsh
refused '--test: 2 is not one of' stats pandas.csv --value error --test 2
for margin in 5 1 99.5% -1% nan% 150% inf% % 5%% 0x1p-3 1e-400%; do
  refused "--margin: $margin is not a share from 0 % to 99 %; expected for example 5% or 0.05" stats pandas.csv --value error --margin=$margin
done
for significance in 0 nan 0.3 2 -1 0.05x; do
  refused "--significance: $significance is not a number from 0.0001 to 0.2" \
    stats pandas.csv --value error --significance=$significance
done
refused '--margin-cm: -1 is not a number from 0 to 1000' stats pandas.csv --value error --margin-cm=-1
refused '--margin-cm: no quantity is in cm; expected a column whose name ends in _cm' stats pandas.csv --value error --margin-cm 0.01
refused '--quartiles' stats pandas.csv --value error --quartiles 10
printf 'solver,error\nA,1\0\n' >nul.csv
refused 'nul.csv:2: a NUL byte; expected text in UTF-8' stats nul.csv --value error
head -c 3000000 /dev/zero | tr '\0' x >line.csv
refused 'line.csv: no rows below the header' stats line.csv --value error
{ printf 'solver,error\n' && cat line.csv && printf ',1\nB,2\n'; } >endless.csv
refused '3000000 bytes; expected a name of at most 1000' stats endless.csv --value error
{ cat line.csv && printf ',error\nA,1\n'; } >header.csv
refused "no column 'value'; expected one of: xxx" stats header.csv --value value
[ "$(wc -c <.err)" -lt 1000 ] || fail "a message of $(wc -c <.err) bytes"
{ echo solver,error && seq 1001 | sed 's/.*/g&,&/'; } >many.csv
refused "more than 1000 groups, the last 'g1001'" stats many.csv --value error
echo "a file" >file
refused 'file' stats pandas.csv --value error --no-figures --out file
[ "$(<file)" = "a file" ] || fail "the file was changed"
rm empty.csv decimal.csv semicolons.csv nul.csv line.csv endless.csv header.csv many.csv file
[ "$(ls)" = "$before" ] || fail "a mistake wrote: $(ls)"

### Names are text.

hostile=('"quoted", '"'single'" '<script>alert(1)</script>' '$(touch pwned)`touch pwned`' $'line\nbreak' 'a|b'
  '100 % {} {0} %s %n' 'Gelenkkörper плечо' '../../x' $'\e[31mred\a' '@{/Symbol a} \input{/etc/passwd}' '=1+1'
  "'.system('touch pwned').'" '[link](http://x) ![i](y)' $'\u202egnp.exe' '-x' '\\ \end{table}' '# A'
  "$(printf 'x%.0s' {1..1000})")
column='err<b>or</b> $x$ `touch pwned`'
{
  echo "solver,\"$column\""
  for i in "${!hostile[@]}"; do
    for value in 1 2 4; do echo "\"${hostile[i]//\"/\"\"}\",$((i + value))"; done
  done
} >hostile.csv
mkdir -p deep/here
(
  cd deep/here || exit 1
  succeeds stats --verbose ../../hostile.csv --value "$column" --out report
  quiet
  ! LC_ALL=C.UTF-8 grep -q $'\u202e' "$work/.out" || fail "a name turned the direction of writing"
  [ "$(ls -A)" = report ] || fail "something beside --out was written: $(ls -A)"
  [ "$(ls report | tr '\n' ' ')" = "figures report.html report.md statistics.json tables " ] ||
    fail "the folder has: $(ls report)"
  name=err-b-or-b-x-touch-pwned
  [ -z "$(find report/tables report/figures -type f ! -name "statistics-$name-*" ! -name style.gp)" ] ||
    fail "other files: $(find report -type f)"
  has_outputs report $name groups tests contrasts
  has_figures report $name observations
  # The page has scripts of its own, on lines that begin with them.
  ! sed 's/^<script>//' report/report.html | grep '<script>\|<b>or' >/dev/null || fail "the page has HTML of the user's making"
  # In Markdown the command is an indented block, which has no markup.
  ! cat report/report.md report/tables/*.md | grep -v '^    ' | grep '<script>\|<b>\|[^\\]\](http\|[^\\]\](y' >/dev/null ||
    fail "Markdown or HTML of the user's making"
  ! sed 's/\\textbackslash{}//g' report/tables/*.tex | grep '\\input\|\\end{table}.' >/dev/null || fail "LaTeX of the user's making"
  ! grep -q '<script>\|<b>or' report/figures/*.svg 2>/dev/null || fail "a figure has HTML of the user's making"
  for file in report/report.* report/statistics.json report/tables/*.md report/tables/*.tex report/figures/*.gp; do
    ! LC_ALL=C grep -q $'[\001-\010\013-\037\177]' "$file" || fail "control characters in $file"
  done
  # Each group is one row, with its whole name in what other programs read.
  rows=$(awk '/^group  /{ on = 1; next } /^$/{ on = 0 } on' "$work/.out" | wc -l)
  [ "$rows" = ${#hostile[@]} ] || fail "$rows rows on the terminal, expected ${#hostile[@]}"
  if command -v python3 >/dev/null; then
    printf '%s\0' "${hostile[@]}" | python3 -c '
import csv, json, sys
names = sys.stdin.read().split("\0")[:-1]
quantity = sys.argv[1]
[assessment] = json.load(open("report/statistics.json", encoding="utf-8"))
rows = list(csv.DictReader(open(f"report/tables/statistics-{sys.argv[2]}-groups.csv", newline="", encoding="utf-8")))
assert assessment["quantity"] == quantity, assessment["quantity"]
assert [group["name"] for group in assessment["groups"]] == names
assert [row["group"] for row in rows] == names
assert all(abs(float(row["mean"]) - (i + 7 / 3)) < 1e-12 for i, row in enumerate(rows))
' "$column" $name || fail "names are not intact in JSON or CSV"
  fi
) || exit 1
[ -z "$(find . -name 'pwned*' -o -name x)" ] || fail "a name was run, or was a path"
# Names of files and quantities, too.
odd=$'odd $(touch pwned) <b>\e[2J.csv'
cp pandas.csv "$odd"
succeeds stats --verbose "$odd" --value error --no-figures --quantity $'two\nlines <b>'
quiet
has "$out" "Statistics: two lines <b>"
folder=$(find out -mindepth 1 -maxdepth 1 -name 'stats-odd*')
[[ $(basename "$folder") =~ ^[A-Za-z0-9._-]+$ ]] || fail "the folder is named $(basename "$folder")"
! grep -v '^    ' "$folder/report.md" | grep '<b>' >/dev/null || fail "the report has HTML of a file's name"
[ -z "$(find . -name 'pwned*')" ] || fail "a name was run"

### Degenerate data: described, explained, and no number where there is none.

degenerate() { # WORDS CSV...: a report that has the words, whose numbers are JSON
  local words=$1 margin=5%
  shift
  rows "$@" >degenerate.csv
  [[ $* != *-1* ]] || margin=0 # a negative value
  succeeds stats --verbose degenerate.csv --value error --margin $margin --out degenerate
  has_outputs degenerate error groups
  has "$out" "$words"
  has_no "$out" " nan"
  has_no "$out" "inf "
  if command -v gnuplot >/dev/null; then has_no "$err" "not drawn"; fi
  has_no "$out" "group 1"
}
degenerate "There is only one group" A "1 2 3"
degenerate "; 1 group (A) with 1 observation each" A 1
degenerate "nothing can be judged, because no group has more than one observation" A 1 B 2 C 3
degenerate "A cannot be judged against B (A has fewer than 3 values, of which the bootstrap learns too little)" A 1 B "2 3"
degenerate "Equal rows are one observation: all rows of A (5), B (5) have the same value" A "1 1 1 1 1" B "2 2 2 2 2"
degenerate "A and B are the same within 5 %." A "7 7 7 7" B "7 7 7 7"
degenerate "A and B are the same within 5 %." A "1 1 1 1 1 1" B "1 1 1 1 1 1" C "1.9 2.1 1.8 2.2 2.3 1.7" # no shares: values above 1
degenerate "A against B is undecided (p > 0.999; difference between -0.527 and 0.527)" A "1 1 1 1" B "1 1 1 1" # 1 - 0.05^(1 / 4)
degenerate "A against B is undecided (all observations are equal, but there are too few to call the groups the same)" A "1 1 1" B "1 1 1"
degenerate "Other pairs that differ (1 of 1; the better first): B vs C." A "1 2 3 1 2 3" B "2 2 2 2 2 2" C "3 3 3 3 3 3"
degenerate "A has values that are not finite" A "1 2 Inf" B "2 3 4"
degenerate "A has values that are not finite" A "Inf Inf" B "2 Inf"
degenerate "cannot be judged against B" A "Inf Inf" B "Inf Inf"
degenerate "B against A is undecided (p = 0.318)." A "1e308 1.1e308 1.2e308" B "-1e308 -1.1e308 1e307"
degenerate "A has values too far apart for double precision" A "0.5 1e300 1 2" B "0.1 0.2 5 2"
degenerate "the sums of squares are too large for double precision" A "1.7e308 -1.7e308 1.7e308" B "1.7e308 -1.7e308 1"
has_no "$out" "not finite"
degenerate "A has no values" A "NaN NaN" B "1 2" C "2 3"
degenerate "A against B is undecided" A "1e-320 2e-320 3e-320" B "5e-324 1e-323 9e-320"
degenerate "; 2 groups" A "-0 0 0" B "0 0 1"

# One block that is complete: ranks, and no test of them.
printf 'A,B,C\n1,2,3\n' >block.csv
succeeds stats --verbose block.csv --wide --rows-are-blocks --out block
has "$out" "nothing can be judged, because no group has more than one observation"
printf 'A,B,C\n1,2,3\n4,,5\n' >block.csv
succeeds stats --verbose block.csv --wide --rows-are-blocks --no-figures --out block
has "$out" "Values are missing: 1 of 2 blocks of B; these blocks are left out"
has "$out" "nothing can be judged, because no group has more than one observation"

# Two hundred groups: the pairs with the best alone.
{ echo solver,error && for i in {1..200}; do printf 'g%d,%d\ng%d,%d\ng%d,%d\n' $i $i $i $((i + 1)) $i $((i + 3)); done; } >many.csv
succeeds stats --verbose many.csv --value error --no-figures --out many
has "$out" "g1 is better than "
has_outputs many error groups tests contrasts
[ "$(wc -l <many/tables/statistics-error-contrasts.csv)" = 200 ] || fail "not the 199 pairs with the best"
[ "$(awk '{ print length }' .out | sort -n | tail -n 1)" -lt 3000 ] || fail "a sentence names two hundred groups"
exit 0

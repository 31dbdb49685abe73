#!/usr/bin/env bash
# What docs/statistics.md quotes is what the program prints, word for word.
source "$(dirname "$0")/common.sh"
root=$(realpath "$scripts/../..")
docs=$root/docs/statistics.md
ln -s "$root/results" results # the commands are said from the root of the project

# section TITLE: its lines, with those of the sections in it.
section() {
  awk -v title="$1" '
    /^```/ { fenced = !fenced }
    !fenced && /^#+ / {
      level = index($0, " ") - 1
      if (inside && level <= depth) inside = 0
      if (substr($0, level + 2) == title) { inside = 1; depth = level }
    }
    inside' "$docs"
}

# quotations: of the lines given, each quotation as one line; at "[...]" it is two.
quotations() {
  awk '
    function flush() { if (text != "") print text; text = "" }
    /^> / { text = text (text == "" ? "" : " ") substr($0, 3); next }
    { flush() }
    END { flush() }' | sed 's/ *\[\.\.\.] */\n/g' | sed '/^$/d'
}

quoted=0 # lines
# prints TITLE COMMAND: what the section quotes, by the command that it says.
prints() {
  local title=$1 command=$2 count=0 quotation arguments
  section "$title" >section.md
  grep -qxF "$command" section.md || fail "the section '$title' does not say the command: $command"
  eval "arguments=(${command#ikbench })"
  succeeds "${arguments[@]}" --no-figures --out out
  while IFS= read -r quotation; do
    grep -qF -e "$quotation" .out || fail "$command does not print what '$title' quotes: $quotation"
    count=$((count + 1))
  done < <(quotations <section.md)
  [ $count -gt 0 ] || fail "the section '$title' quotes nothing"
  quoted=$((quoted + $(grep -c '^> ' section.md)))
}

prints "How to read a section, line by line" "ikbench stats --summaries results/published/slim2023/table-3.csv"

section "With blocks" | sed -n '/^data set,/,/^```/p' | sed '$d' >demsar.csv
[ "$(wc -l <demsar.csv)" = 15 ] || fail "Demsar's table has $(wc -l <demsar.csv) lines, expected a header and 14 data sets"
prints "With blocks" 'ikbench stats demsar.csv --wide --block "data set" --larger-is-better --quantity AUC'

section "Several problems, several seeds" | sed -n '/^problem,seed,/,/^```/p' | sed '$d' >problems.csv
[ "$(wc -l <problems.csv)" = 16 ] || fail "the table of problems has $(wc -l <problems.csv) lines, expected a header and 15 rows"
prints "Several problems, several seeds" 'ikbench stats problems.csv --wide --block problem --run seed --quantity error'

# answers REQUEST ARGUMENTS...: what the table of refusals says of the request, from its first word on.
section "What is refused, and why" >section.md
answers() {
  local answer
  answer=$(awk -F' [|] ' -v request="| $1" '$1 == request { print $2 }' section.md | sed 's/^`//; s/` |$//')
  [ -n "$answer" ] || fail "the table of refusals has no request: $1"
  shift
  refused "ikbench: $answer" stats "$@"
}
{
  echo solver,run,point,error
  for solver in A B; do for run in 1 2 3; do for point in 1 2; do echo "$solver,$run,$point,0.$run$point"; done; done; done
} >all.csv
with() { sed "$1" all.csv >results.csv; } # what differs
with ''
answers '`--value error`' results.csv --value error
answers '`--value error --block point`' results.csv --value error --block point
answers '`--value eror`' results.csv --value eror
with '1s/point/problem/'
answers 'the same with `problem` for `point`' results.csv --value error
cut -d, -f1,2,4 all.csv >results.csv
answers 'the same without the column `point`' results.csv --value error
with '$p'
answers '`--value error --run run`, where the last row is duplicated' results.csv --value error --run run
with '2s/0.11/"0,1"/'
answers 'a cell `0,1`' results.csv --value error --run run
with 's/,/;/g'
answers 'columns separated by semicolons' results.csv --value error
published=results/published/slim2023/table-3.csv
answers 'summaries and `--test kruskal_wallis`' --summaries $published --test kruskal_wallis
answers 'summaries with `--control X`' --summaries $published --control X
printf 'name,mean,sd,n\nA,1,0.1,5\nB,2,,5\n' >table.csv
answers 'summaries without an `sd`' --summaries table.csv
[ "$(grep -c '^| .* | `' section.md)" = 11 ] || fail "the table of refusals has rows that nothing checks"

all=$(grep -c '^> ' "$docs")
[ "$quoted" = "$all" ] || fail "$((all - quoted)) quoted lines are in sections of which this script knows no command"

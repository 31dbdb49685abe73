#!/usr/bin/env bash
# The pages on statistics quote the program word for word: every command of `ikbench stats` runs on the files that the
# page shows (```csv NAME), and its output contains what is quoted below it. "[...]" is left out.
source "$(dirname "$0")/common.sh"
root=$(realpath "$scripts/../..")
ln -s "$root/results" results # the commands are said from the root of the project

# check_quotation TEXT: each part is printed by the last command.
check_quotation() {
  local part
  while IFS= read -r part; do
    has "$out" "$part"
  done < <(sed 's/ *\[\.\.\.\] */\n/g' <<<"$1" | sed '/^$/d')
  quoted=$((quoted + 1))
}

# check_page FILE: its commands and quotations are counted in $commands and $quoted.
check_page() {
  local page=$1 line block="" text="" command="" arguments
  commands=0 quoted=0
  while IFS= read -r line; do
    if [[ $line == "> "* ]]; then
      text+="${text:+ }${line#> }"
      continue
    fi
    [ -z "$text" ] || check_quotation "$text"
    text=""
    if [[ $line == '```'* ]]; then
      [ -z "$block" ] && block=${line#'```'} || block=""
      [[ $block != "csv "* ]] || : >"${block#csv }"
    elif [[ $block == "csv "* ]]; then
      printf '%s\n' "$line" >>"${block#csv }"
    elif [[ $block == sh && $line == "ikbench stats "* ]]; then
      command=$line commands=$((commands + 1))
      eval "arguments=(${command#ikbench })"
      succeeds "${arguments[@]}" --verbose --no-figures --out out
    fi
  done < <(cat "$root/docs/$page"; echo)
}

check_page reading-a-report.md
[ "$commands $quoted" = "1 3" ] || fail "reading-a-report.md has $commands commands and $quoted quotations, expected 1 and 3"
check_page your-own-csv.md
[ "$commands $quoted" = "10 11" ] || fail "your-own-csv.md has $commands commands and $quoted quotations, expected 10 and 11"
[ "$(wc -l <demsar.csv) $(wc -l <problems.csv)" = "15 16" ] || fail "the files of your-own-csv.md are not whole"

# The refusals of the same page: a row is the options and the answer.
refusals=0
while IFS='`' read -r _ options _ answer _; do
  eval "arguments=($options)"
  refused "ikbench: $answer" stats results.csv "${arguments[@]}"
  refusals=$((refusals + 1))
done < <(grep '^| `--value .* | `results.csv: ' "$root/docs/your-own-csv.md")
[ $refusals = 2 ] || fail "your-own-csv.md shows $refusals refusals, expected 2"

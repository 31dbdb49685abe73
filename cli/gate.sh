#!/usr/bin/env bash
# Runs a study, and decides whether solvers reach a share or became worse than a baseline. action.yml calls it; so can you:
#
#   STUDY=my.toml BASELINE=old.sqlite cli/gate.sh
#
# STUDY        the study
# BASELINE     the store to compare with; if it is missing, the gate passes, and says which store to keep. Without the name
#              of one, [require] of the study decides alone
# REQUIRE      shares that your own solvers must reach, one per line, such as solved=95%; default: [require] of the study.
#              An inconclusive one fails. With REQUIRE, no BASELINE is needed
# OLD          an older ikbench, in place of BASELINE: both solve the study in turn, so that times decide, too
# ROUNDS       with OLD, the number of rounds, at most the number of the study's runs or targets; default: 20
# TIME_MARGIN  with OLD, the smallest relative difference of times that matters; default: 10%
# MARGIN       the smallest relative difference that matters, such as 5%; default: that of the study's plan
# METRIC       which metrics decide, such as solved,evaluations; default: all that the plan names
# STRICT       true: an inconclusive comparison fails, too
# OUT          the folder of the new store.sqlite and of verdict.md; default: ikbench-gate
# IKBENCH      the program; default: ikbench
#
# The exit code is 0 if the gate passes, also without a baseline; otherwise it is that of ikbench run or compare.
set -uo pipefail
program=${IKBENCH:-ikbench} study=${STUDY:-} baseline=${BASELINE:-} out=${OUT:-ikbench-gate}
[[ $baseline != -* ]] || baseline=./$baseline
[[ $out != -* ]] || out=./$out
[[ $study != -* ]] || study=./$study

if [[ -n ${GITHUB_ACTIONS:-} ]]; then  # a label such as ::error is not a command to the forge
  token=$(od -An -N16 -tx1 /dev/urandom | tr -d ' \n')
  echo "::stop-commands::$token"
  trap 'echo "::$token::"' EXIT
fi
ended() {  # ended OUTCOME CODE
  [[ -z ${GITHUB_OUTPUT:-} ]] || printf '%s\n' "outcome=$1" "store=$out/store.sqlite" >>"$GITHUB_OUTPUT"
  exit "$2"
}
refuse() { echo "gate: $1" >&2; ended failed 1; }
[[ -n $study ]] || refuse "STUDY is not set; expected a study, such as STUDY=my.toml"
old=${OLD:-} rounds=${ROUNDS:-20} time_margin=
[[ -z $old ]] || baseline=$out/before/store.sqlite time_margin=${TIME_MARGIN:-10%}
[[ -z ${TURNS:-} ]] || refuse "TURNS is now called ROUNDS"
[[ $rounds =~ ^[1-9][0-9]{0,3}$ ]] || refuse "ROUNDS is $rounds; expected a number from 1 to 9999"
[[ -z $time_margin || $time_margin =~ ^[0-9]+(\.[0-9]+)?%$ ]] || refuse "TIME_MARGIN is $time_margin; expected a percentage, such as 10%"
[[ ${STRICT:-false} =~ ^(true|false)$ ]] || refuse "STRICT is $STRICT; expected true or false"
differ() { [[ ! $baseline -ef $out/store.sqlite ]] || refuse "BASELINE is the store that this call writes; choose another OUT"; }
differ
solve() {
  "$1" run "$study" --shard "$i/$rounds" --out="$2/shards/$i" && return
  local code=$?
  echo "gate: this failed in round $i of ROUNDS=$rounds, run by $1" >&2
  ended failed $code
}
requirements=(--strict)
while IFS=$' \t\r' read -r line; do [[ -z $line ]] || requirements+=(--require="$line"); done <<<"${REQUIRE:-}"
if [[ -z $old ]]; then
  judge=("$program" run "$study" --no-report --out="$out")
else  # who begins a round alternates
  [[ ! -e $out || -e $out/.in-turn ]] || refuse "OUT is $out, a folder that no call with OLD made; choose a new one"
  mkdir -p -- "$out" && : >"$out/.in-turn" || ended failed 2
  rm -rf -- "$out"/{before,shards,store.sqlite}
  for ((i = 1; i <= rounds; i++)); do
    ((i % 2)) && solve "$old" "$out/before"
    solve "$program" "$out"
    ((i % 2)) || solve "$old" "$out/before"
  done >/dev/null
  for each in "$out/before" "$out"; do "$program" merge "$each" "$each/shards" || ended failed $?; done
  judge=("$program" report "$out/store.sqlite" --figures none)
fi
text=$("${judge[@]}" "${requirements[@]}")
required=$?
printf '%s\n' "$text"
[[ $required =~ ^[034]$ ]] || ended failed $required
[[ -z ${GITHUB_STEP_SUMMARY:-} || -z $text ]] || printf '```\n%s\n```\n' "$text" >>"$GITHUB_STEP_SUMMARY"
rm -f -- "$out/verdict.md"  # of an earlier call
[[ -z $text ]] || printf '%s\n' "$text" >"$out/verdict.md"  # in place of which a comparison writes its own
# Code 3 also stands for a program that gave no answer in any solve, which the data name.
is_without_answer() { grep -q '"without_answer"' < <("${judge[@]}" --json 2>/dev/null); }
end_by_requirements() {
  case $required in
    0) ended "$1" 0 ;;
    3) is_without_answer && ended failed 3; ended unmet 3 ;;
    *) ended inconclusive 4 ;;
  esac
}
# Whether the study has a [require].
has_requirements() { grep -q '"requirements": \[$' < <("${judge[@]}" --json 2>/dev/null); }
[[ -n $baseline || -z ${REQUIRE:-} ]] || end_by_requirements passed
[[ -n $baseline ]] || {
  ! has_requirements || end_by_requirements passed
  echo "Nothing was compared: set REQUIRE=solved=95%, OLD, or BASELINE, such as a copy of $out/store.sqlite."
  end_by_requirements no-baseline
}
[[ -e $baseline || -L $baseline ]] || { echo "There is no baseline yet; keep $out/store.sqlite as $baseline."; end_by_requirements no-baseline; }
differ  # of files that were not there
options=(${MARGIN:+--margin="$MARGIN"} ${time_margin:+--time-margin="$time_margin"} ${METRIC:+--metric="$METRIC"})
[[ ${STRICT:-} != true ]] || options+=(--strict)
"$program" compare "$baseline" "$out/store.sqlite" -o "$out/verdict.md" "${options[@]}"
code=$?
[[ -z ${GITHUB_STEP_SUMMARY:-} || ! -e $out/verdict.md ]] || cat "$out/verdict.md" >>"$GITHUB_STEP_SUMMARY"
case $code in 0) end_by_requirements passed ;; 3) ended worse 3 ;; 4) ended inconclusive 4 ;; *) ended failed $code ;; esac

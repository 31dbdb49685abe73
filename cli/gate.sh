#!/usr/bin/env bash
# Runs a study and compares its store with a baseline, as action.yml does: STUDY=my.toml BASELINE=old.sqlite cli/gate.sh
# MARGIN (5%; default: the plan's), STRICT (true: not decided fails too), OUT (ikbench-gate), IKBENCH (the program).
# Writes OUT/store.sqlite and OUT/verdict.md. Exit code 0: passed or no baseline; else that of ikbench run or compare.
set -uo pipefail
program=${IKBENCH:-ikbench} study=${STUDY:-} baseline=${BASELINE:-} out=${OUT:-ikbench-gate}
[[ $baseline != -* ]] || baseline=./$baseline
[[ $out != -* ]] || out=./$out

if [[ -n ${GITHUB_ACTIONS:-} ]]; then  # a label such as ::error is no command to the forge
  token=$(od -An -N16 -tx1 /dev/urandom | tr -d ' \n')
  echo "::stop-commands::$token"
  trap 'echo "::$token::"' EXIT
fi
ended() {  # ended OUTCOME CODE
  [[ -z ${GITHUB_OUTPUT:-} ]] || printf '%s\n' "outcome=$1" "store=$out/store.sqlite" >>"$GITHUB_OUTPUT"
  exit "$2"
}
refuse() { echo "gate: $1" >&2; ended failed 1; }
[[ -n $study ]] || refuse "STUDY is not set; expected the study"
[[ -n $baseline ]] || refuse "BASELINE is not set; expected the store of the baseline"
[[ ${STRICT:-false} =~ ^(true|false)$ ]] || refuse "STRICT is $STRICT; expected true or false"
[[ $(realpath -m "$baseline") != "$(realpath -m "$out/store.sqlite")" ]] || refuse "BASELINE is the new store; choose another OUT"
rm -f -- "$out/verdict.md"  # of an earlier call
"$program" run "$study" --no-report --out="$out" || ended failed $?
[[ -e $baseline || -L $baseline ]] || { echo "No baseline: keep $out/store.sqlite as $baseline."; ended no-baseline 0; }
options=(${MARGIN:+--margin="$MARGIN"})
[[ ${STRICT:-} != true ]] || options+=(--strict)
"$program" compare "$baseline" "$out/store.sqlite" -o "$out/verdict.md" "${options[@]}"
code=$?
[[ -z ${GITHUB_STEP_SUMMARY:-} || ! -e $out/verdict.md ]] || cat "$out/verdict.md" >>"$GITHUB_STEP_SUMMARY"
case $code in 0) ended passed 0 ;; 3) ended worse 3 ;; 4) ended undecided 4 ;; *) ended failed $code ;; esac

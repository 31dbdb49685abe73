#!/usr/bin/env bash
# Runs a study and compares its store with a baseline: what action.yml does, and any other CI can.
#
#   STUDY=my.toml BASELINE=baseline.sqlite cli/gate.sh
#
# MARGIN (default: that of the study's plan), METRICS (names separated by spaces; default: those that are the same on
# every runner), STRICT (true: undecided fails too), OUT (ikbench-gate), IKBENCH (the program). Writes OUT/store.sqlite,
# OUT/verdict.md and OUT/verdict.json. Adds the verdict to the job's summary where there is one.
# Exit codes: 0 passed or no baseline, 3 worse, 4 undecided with STRICT, otherwise that of the command that failed.
set -euo pipefail
program=${IKBENCH:-ikbench} out=${OUT:-ikbench-gate} baseline=${BASELINE:?the store of the baseline}
study=${STUDY:?the study, a TOML file or the name of a built-in one}

told() { [[ -z ${GITHUB_OUTPUT:-} ]] || printf '%s\n' "outcome=$1" "store=$out/store.sqlite" >>"$GITHUB_OUTPUT"; }
# failed COMMAND CODE: red for no solver's sake.
failed() {
  echo "Nothing was compared: ikbench $1 failed with exit code $2." >&2
  told failed
  exit "$2"
}

[[ ${STRICT:-false} =~ ^(true|false)$ ]] || { echo "STRICT is $STRICT; expected true or false" >&2; exit 1; }
for value in "$study" "$out" "$baseline"; do
  [[ $value != -* && $value != *$'\n'* ]] || { echo "$value: expected a path or a name" >&2; exit 1; }
done
"$program" run "$study" --no-report --out "$out" >/dev/null || failed run $?
if [[ ! -e $baseline ]]; then
  printf '%s\n' "There is no baseline $baseline." "Keep $out/store.sqlite as the baseline: commit it, or store it as an artifact."
  told no-baseline
  exit 0
fi
options=(-o "$out/verdict.md" -o "$out/verdict.json")
[[ -z ${MARGIN:-} ]] || options+=(--margin "$MARGIN")
read -ra metrics <<<"${METRICS:-}"
for metric in "${metrics[@]}"; do options+=(--metric "$metric"); done
[[ ${STRICT:-} != true ]] || options+=(--strict)
code=0
"$program" compare "$baseline" "$out/store.sqlite" "${options[@]}" || code=$?
[[ -z ${GITHUB_STEP_SUMMARY:-} || ! -e $out/verdict.md ]] || cat "$out/verdict.md" >>"$GITHUB_STEP_SUMMARY"
case $code in
  0) told passed ;;
  3) told worse ;;
  4) told undecided ;;
  *) failed compare $code ;;
esac
exit "$code"

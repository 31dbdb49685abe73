#!/usr/bin/env bash
# Whether ./check runs both of its stages, also where one of them fails: check.sh CHECK
# Its copy is run in a folder where ./setup and ctest only write down that they were called, and with what.
set -euo pipefail
export LC_ALL=C.UTF-8
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$1" "$work/check"
for name in setup ctest; do
  printf '#!/bin/sh\necho "%s $*" >>"%s/calls"\ncase "%s $*" in *"$FAILING"*) exit 1 ;; esac\n' "$name" "$work" "$name" >"$work/$name"
  chmod +x "$work/$name"
done

# stages FAILING EXPECTED_CODE EXPECTED_CALLS...: of a check in which the calls that have FAILING in them fail.
stages() {
  local failing=$1 expected=$2 code=0 call
  shift 2
  : >"$work/calls"
  FAILING=$failing PATH=$work:$PATH bash "$work/check" -R anova >"$work/said" 2>&1 || code=$?
  [ "$code" = "$expected" ] || { echo "FAILED: '$failing' fails: exit code $code, expected $expected"; exit 1; }
  for call in "$@"; do
    grep -qF "$call" "$work/calls" || { echo "FAILED: '$failing' fails: no call of $call in:"; cat "$work/calls"; exit 1; }
  done
}

both=("setup dev" "ctest --preset dev" "setup release" "ctest --preset release")
stages "nothing" 0 "${both[@]}"
stages "ctest --preset dev" 1 "${both[@]}"
stages "ctest --preset release" 1 "${both[@]}"
stages "setup dev" 1 "setup dev" "ctest --preset release"
grep -qxF "check: failed with dev" "$work/said" || { echo "FAILED: it does not say what failed:"; cat "$work/said"; exit 1; }
! grep -qF "ctest --preset dev" "$work/calls" || { echo "FAILED: tests what was not built"; exit 1; }
grep -qF -- "-R anova" "$work/calls" || { echo "FAILED: its arguments do not reach ctest"; exit 1; }

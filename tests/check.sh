#!/usr/bin/env bash
# ./check runs all of its stages, even if one of them fails: check.sh CHECK
# Its copy runs in a folder where the programs that it calls only record their calls.
set -euo pipefail
export LC_ALL=C.UTF-8
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$1" "$work/check"
for name in setup ctest clang-format run-clang-tidy; do
  printf '#!/bin/sh\necho "%s $*" >>"%s/calls"\ncase "%s $*" in *"$FAILING"*) exit 1 ;; esac\n' "$name" "$work" "$name" >"$work/$name"
  chmod +x "$work/$name"
done

printf '#!/bin/sh\necho a.cpp\n' >"$work/git"
chmod +x "$work/git"

# stages FAILING EXPECTED_CODE EXPECTED_CALLS...: checks a run in which the calls that contain FAILING fail.
stages() {
  local failing=$1 expected=$2 code=0 call
  shift 2
  : >"$work/calls"
  FAILING=$failing PATH=$work:$PATH bash "$work/check" "${arguments[@]}" >"$work/said" 2>&1 || code=$?
  [ "$code" = "$expected" ] || { echo "FAILED: '$failing' fails: exit code $code, expected $expected"; exit 1; }
  for call in "$@"; do
    grep -qF "$call" "$work/calls" || { echo "FAILED: '$failing' fails: no call of $call in:"; cat "$work/calls"; exit 1; }
  done
}

# said LINE: the last check said it.
said() {
  grep -qxF "$1" "$work/said" || { echo "FAILED: it does not say '$1' but:"; cat "$work/said"; exit 1; }
}

arguments=(-R anova)
all=("setup check" "ctest --preset check -j $(($(nproc) + 3)) -R anova" "clang-format --dry-run -Werror a.cpp")
stages "nothing" 0 "${all[@]}"
stages "ctest --preset check" 1 "${all[@]}"
stages "clang-format" 1 "${all[@]}"
said "check: failed with format"
said "check: some files are not formatted; run: git ls-files '*.cpp' '*.hpp' | xargs clang-format -i"
stages "setup check" 1 "setup check" "clang-format"
said "check: failed with check"
! grep -qF "ctest" "$work/calls" || { echo "FAILED: tests what was not built"; exit 1; }

arguments=(--sanitized -R anova)
stages "nothing" 0 "setup dev" "ctest --preset dev -j $(($(nproc) + 3)) -R anova" "clang-format"
stages "ctest --preset dev" 1
said "check: failed with dev"

arguments=(--lint)
stages "nothing" 0 "setup --with-lint lint ikbench" "run-clang-tidy -quiet -p build/lint"
! grep -q ctest "$work/calls" || { echo "FAILED: --lint runs tests"; exit 1; }
stages "run-clang-tidy" 1 "run-clang-tidy"

mkdir "$work/tests"
cp "$work/setup" "$work/tests/alone.sh"
sed -i 's/setup /alone.sh /g' "$work/tests/alone.sh"
arguments=(--alone)
stages "nothing" 0 "setup check ikbench" "alone.sh build/check"
! grep -q ctest "$work/calls" || { echo "FAILED: --alone runs tests"; exit 1; }
stages "alone.sh" 1 "alone.sh build/check"
stages "setup" 1 "setup check ikbench"

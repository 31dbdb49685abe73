#!/usr/bin/env bash
# With BUILD_TESTING=OFF the project needs no Catch2 and builds nothing of tests/: without_tests.sh CMAKE GENERATOR
# COMPILER
set -uo pipefail
export LC_ALL=C.UTF-8
cmake=$1 generator=$2 compiler=$3
source=$(realpath "$(dirname "$0")/..")
build=$(mktemp -d)
trap 'rm -rf "$build"' EXIT

fail() {
  echo "FAILED: $*" >&2
  exit 1
}
# configure ON|OFF: where Catch2 is not to be found.
configure() {
  "$cmake" -S "$source" -B "$build" -G "$generator" -DCMAKE_CXX_COMPILER="$compiler" -DBUILD_TESTING="$1" \
    -DCMAKE_DISABLE_FIND_PACKAGE_Catch2=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >"$build/log" 2>&1
}

configure OFF || fail "$(<"$build/log")"
grep -qF "$source/cli/" "$build/compile_commands.json" || fail "the program is not compiled"
! grep -F "\"file\": \"$source/tests/" "$build/compile_commands.json" || fail "the above is compiled without tests"
configure ON && fail "Catch2 was found although it is hidden"
grep -q Catch2 "$build/log" || fail "tests without Catch2 end with: $(<"$build/log")"

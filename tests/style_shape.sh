#!/usr/bin/env bash
# tests/tools/style-shape finds what is packed, and nothing in strings, comments and declarations; and its numbers only fall.
set -euo pipefail
export LC_ALL=C.UTF-8
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"/..
tool=tests/tools/style-shape
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "style_shape.sh: $*" >&2; exit 1; }

# Each marked line of the sample, and no other.
grep -n '//! ' tests/data/packed.txt | sed -E 's#^([0-9]+):.*//! (.*)#\1: \2#' >"$scratch/expected"
"$tool" --list tests/data/packed.txt | sed -E 's/^[^:]*:([0-9]+): ([a-z]+).*/\1: \2/' >"$scratch/found"
diff "$scratch/expected" "$scratch/found" || fail "the sample has other places (< expected, > found)"
(($(wc -l <"$scratch/found") > 15)) || fail "the sample has too few places"

# Lengths, and names of a header.
body() { echo "void f() {"; seq -f '  g(%.0f);' "$1"; echo "}"; }
body 58 >"$scratch/short.cpp"
body 59 >"$scratch/long.cpp"
[[ $("$tool" --list "$scratch/short.cpp" "$scratch/long.cpp") == "$scratch/long.cpp:1: function of more than 60 lines" ]] ||
  fail "61 lines are one too many for a function"
names() { echo "#pragma once"; echo "namespace a {"; seq -f 'int f_%.0f(int a, int b);' "$1"; echo "void f_1();"; echo "}"; }
names 30 >"$scratch/few.hpp"
names 31 >"$scratch/many.hpp"
[[ $("$tool" --list "$scratch/few.hpp" "$scratch/many.hpp") == "$scratch/many.hpp:1: header of more than 30 public names" ]] ||
  fail "31 names are one too many for a header; overloads are one"

# A number only falls: one more place than it fails, and names the number to lower to where there are fewer.
mkdir -p "$scratch/tree/base"
cp tests/data/packed.txt "$scratch/tree/base/packed.cpp"
for kind in conditional statements assignment more comment; do
  there=$(grep -c ": $kind" "$scratch/expected")
  with() {
    sed -E 's/^    "(.*)": [0-9]+,$/    "\1": 99,/; s/^    "('"$kind"'.*)": 99,$/    "\1": '"$1"',/' "$tool" >"$scratch/tool"
    python3 "$scratch/tool" "$scratch/tree" >"$scratch/out" 2>"$scratch/errors"
  }
  with "$there" || fail "$kind: $there of at most $there fail"
  grep -q "^$kind.*lower" "$scratch/out" && fail "$kind: asks to lower a number that is right"
  with $((there + 1)) || fail "$kind: fewer than the number fail"
  grep -q "^$kind.*: lower the number to $there " "$scratch/out" || fail "$kind: does not ask to lower the number"
  with $((there - 1)) && fail "$kind: one more than the number does not fail"
  grep -q "^$kind.*: $there, but at most $((there - 1));" "$scratch/errors" || fail "$kind: does not say how many there are"
done

#!/usr/bin/env bash
# A file that is added to an embedded folder, changed or removed is so in the next build: embed.sh CMAKE GENERATOR
set -uo pipefail
export LC_ALL=C.UTF-8
cmake=$1 generator=$2
source=$(realpath "$(dirname "$0")/..")
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
cp "$source/embed.cmake" "$tree" && cd "$tree" || exit 1

fail() {
  echo "FAILED: $*" >&2
  exit 1
}
# expect LINES: what is embedded after the next build.
expect() {
  "$cmake" --build build >.log 2>&1 || fail "$(<.log)"
  [ "$(<build/all.inc)" = "$1" ] || fail "embedded: $(<build/all.inc); expected: $1"
}

cat >CMakeLists.txt <<'END'
cmake_minimum_required(VERSION 3.25)
project(embedding LANGUAGES NONE)
include(embed.cmake)
ikbench_embed(all.inc studies *.toml)
add_custom_target(all_embedded ALL DEPENDS ${CMAKE_CURRENT_BINARY_DIR}/all.inc)
END
mkdir studies
echo 'name = "b"; x = [1; "\${y}"]' >studies/b.toml
echo 'of another kind' >studies/README
"$cmake" -S . -B build -G "$generator" >.log 2>&1 || fail "$(<.log)"
b='{"b.toml", R"embedded(name = "b"; x = [1; "\${y}"]
)embedded"},'
expect "$b"
echo 'name = "a"' >studies/a.toml
expect '{"a.toml", R"embedded(name = "a"
)embedded"},
'"$b"
touch -d tomorrow studies/a.toml && echo 'name = "c"' >studies/a.toml && touch -d tomorrow studies/a.toml
expect '{"a.toml", R"embedded(name = "c"
)embedded"},
'"$b"
rm studies/a.toml
expect "$b"

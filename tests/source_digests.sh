#!/usr/bin/env bash
# When the build makes the digests of the sources anew, and which of them a change to the sources changes, in a copy of
# the tree: source_digests.sh CMAKE GENERATOR COMPILER
set -uo pipefail
export LC_ALL=C.UTF-8
cmake=$1 generator=$2 compiler=$3
source=$(realpath "$(dirname "$0")/..")
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
(cd "$source" && cp -r CMakeLists.txt embed.cmake ikbenchConfig.cmake.in analysis cli experiments numerics results robots solvers tests "$tree") || exit 1
cd "$tree" || exit 1
digests=build/experiments/source_digests.inc

fail() {
  echo "FAILED: $*" >&2
  exit 1
}
build() { "$cmake" --build build --target ikbench_source_digests >.log 2>&1 || fail "$(<.log)"; }
# changed: the names whose digests the build changes, in their order.
changed() {
  cp "$digests" .before
  build
  diff .before "$digests" | sed -nE 's/^> .*(shared|"([a-z_]+)", ).*/\1/p' | tr -d '",' | tr '\n' ' ' | sed 's/  */ /g; s/ $//'
}
# expect NAMES WHAT: what the build has to change now.
expect() {
  local names
  names=$(changed)
  [ "$names" = "$1" ] || fail "$2 changed the digests of '$names', expected '$1'"
}

"$cmake" -S . -B build -G "$generator" -DCMAKE_CXX_COMPILER="$compiler" >.log 2>&1 || fail "$(<.log)"
build
[ "$(grep -c '^    {"[a-z_]*", "[0-9a-f]\{16\}"},$' "$digests")" = "$(grep -c -E '^(SOLVER|PEER)' solvers/registry.inc)" ] ||
  fail "not one digest a solver: $(<"$digests")"
[ "$(grep -o '"[0-9a-f]\{16\}"' "$digests" | sort | uniq -d)" = "" ] || fail "two digests are equal: $(<"$digests")"

# Comments and white space, in a solver and in what is shared: the file stays as it is, and nothing is compiled anew.
touch -d yesterday "$digests"
touch .mark
sed -i 's|^  void step(.*|// a comment with "one quote; [\n/* and\n another */   &|' solvers/bat.cpp
sed -i '/\/\//! s/ = \([a-z0-9.]*\);$/=\n\t\1 ;\r/; s/^  /      /' solvers/particle_swarm.cpp robots/chain.cpp
[ "$(grep -c $'\r' solvers/particle_swarm.cpp)" -gt 2 ] || fail "nothing to format in particle_swarm.cpp"
expect "" "formatting"
[ "$digests" -ot .mark ] || fail "unchanged digests were written anew"

# The readers of studies, and the studies themselves, decide no number.
sed -i 's/^title = .*/title = "Another title"/' experiments/studies/*.toml
echo 'constexpr int another = 1;' >>experiments/study_reader.cpp
expect "" "a title"

# A number counts for that solver alone, or for all that share it.
sed -i '0,/0\.5/s//0.25/' solvers/bat.cpp
expect bat "a number in bat.cpp"
for file in solvers/kernels.cpp numerics/lanes.hpp solvers/objective.hpp solvers/solve.cpp numerics/random.cpp robots/spherical_wrist.cpp \
  experiments/path.cpp experiments/paths/random.cpp experiments/verifier.cpp experiments/solve_runner.cpp experiments/runner.cpp; do
  echo 'constexpr int another = 1;' >>$file
  expect shared $file
done
echo 'constexpr int another = 1;' >robots/another.hpp
expect shared "a new header"
sed -i 's/another = 1/another = 1 + +1/' robots/another.hpp
expect shared "a sum"
sed -i 's/+ +1/++1/' robots/another.hpp
expect shared "an increment"

# A peer, or a header that peers share.
echo 'constexpr int another = 1;' >>solvers/peers/nlopt.cpp
expect nlopt "a number in peers/nlopt.cpp"
echo 'constexpr int another = 1;' >>solvers/peers/kdl.hpp
expect "$(sed -nE 's/^PEER\(([a-z_]+),.*/\1/p' solvers/registry.inc | tr '\n' ' ' | sed 's/ $//')" "a header of peers"

# Quoted text counts as it is written, even if it looks like a comment.
echo 'const char* another = "a // b;";' >>solvers/random_search.cpp
expect random_search "a text"
sed -i 's|a // b;|a // c;|' solvers/random_search.cpp
expect random_search "the end of a text"
sed -i 's|a // c;|a //  c;|' solvers/random_search.cpp
expect random_search "a space in a text"
echo 'const char* raw = R"(one)";' >>solvers/random_search.cpp
expect random_search "a raw text"

# These files decide no number.
for file in experiments/environment.cpp experiments/study_reader.cpp experiments/workers.cpp results/store.cpp analysis/inference/study.cpp; do
  echo 'constexpr int another = 1;' >>$file
  expect "" $file
done
# A new solver changes no other's.
cp solvers/random_search.cpp solvers/another.cpp
sed -i 's/random_search/another/' solvers/another.cpp
echo 'SOLVER(another)' >>solvers/registry.inc
expect another "a new solver"

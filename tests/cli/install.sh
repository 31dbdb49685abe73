#!/usr/bin/env bash
# `cmake --install` gives a program that needs neither the source nor the build, and libraries that build anybody's
# project (tests/install).
# install.sh PROGRAM CMAKE SOURCE COMPILER SANITIZERS
source "$(dirname "$0")/common.sh"
cmake=$2 tree=$(realpath "$3") compiler=$4 sanitizers=${5:-}
build=$(dirname "$program")

"$cmake" --install "$build" --prefix "$work/prefix" >.log 2>&1 || fail "cannot install: $(<.log)"
files=$(cd prefix && find . -type f ! -path './lib*' ! -path './include/ikbench/*' ! -path './share/doc/*' | LC_ALL=C sort | tr '\n' ' ')
expected='./bin/ikbench '
[ "$files" = "$(tr -s ' \n' ' ' <<<"$expected")" ] || fail "installed are: $files"
for file in copyright README.md CITATION.cff docs/library.md docs/examples/pso.py cli/gate.sh; do
  [ -s "prefix/share/doc/ikbench/$file" ] || fail "not installed: $file"
done
! grep -rlF "$tree" prefix/lib*/cmake prefix/lib*/*/cmake 2>/dev/null || fail "the package holds the path of its source"
DESTDIR=$work/staged "$cmake" --install "$build" --prefix /opt/ikbench >.log 2>&1 || fail "cannot install: $(<.log)"
cmp staged/opt/ikbench/bin/ikbench prefix/bin/ikbench || fail "DESTDIR installs another program"

# No path of the source is in it, but for the lines that a debugger or a sanitizer tells.
if [ -z "$sanitizers" ] && command -v strip >/dev/null; then
  strip -o stripped prefix/bin/ikbench
  ! grep -qF "$tree" stripped || fail "the program holds the path of its source: $(strings stripped | grep -F "$tree" | head)"
fi

# It runs where the source and the build are not to be seen.
away=()
if unshare --map-root-user --mount true 2>/dev/null; then
  away=(unshare --map-root-user --mount bash -c 'mount -t tmpfs none "$0" && [ -z "$(ls -A "$0")" ] && exec "$@"' "$tree")
fi
installed() { "${away[@]}" "$work/prefix/bin/ikbench" "$@" >.out 2>.err || fail "ikbench $*: $(<.err)"; }
installed run slim2023 "${small[@]}" --out made
for file in store.sqlite report.md report.html tables/results.csv tables/results.md figures/style.gp; do
  [ -s "made/$file" ] || fail "no $file"
done
if command -v gnuplot >/dev/null; then
  [ -s made/figures/error-boxes.svg ] || fail "no figure"
fi
installed list studies slim2023-dobot

# A project of somebody else's. Sanitizers are asked of it by the libraries.
cp -r "$tree/tests/install" project
"$cmake" -S project -B built -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_PREFIX_PATH="$work/prefix" >.log 2>&1 ||
  fail "cannot configure a project with the package: $(<.log)"
"$cmake" --build built >.log 2>&1 || fail "cannot build a project with the package: $(<.log)"
built/mine >.out 2>.err || fail "the project's program: $(<.err)"
grep -q '^| mine |' .out && grep -q '^| random |' .out || fail "no table of both solvers: $(<.out)"
"$program" export made/store.sqlite --study mine >solves.csv || fail "ikbench cannot read the project's store"
[ "$(grep -c ',mine,' solves.csv)" -ge 12 ] || fail "not all solves of the project's solver: $(<solves.csv)"
built/first >.out 2>.err || fail "the first program: $(<.err)"
has "$(<.out)" "the tool is at ("
has "$(<.out)" "ok, "

#!/usr/bin/env bash
# `cmake --install` gives a program that needs neither the source nor the build, and libraries that build anybody's
# project (tests/install).
# install.sh PROGRAM CMAKE SOURCE COMPILER SANITIZERS
source "$(dirname "$0")/common.sh"
cmake=$2 tree=$(realpath "$3") compiler=$4 sanitizers=${5:-}

DESTDIR=$work/staged "$cmake" --install "$(dirname "$program")" --prefix "$work/prefix" >.log 2>&1 || fail "cannot install: $(<.log)"
mv "staged/$work/prefix" prefix || fail "DESTDIR is ignored"
equal installed "$(cd prefix && find . -type f ! -path './lib*' ! -path './include/ikbench/*' ! -path './share/doc/*')" ./bin/ikbench
for file in copyright README.md CITATION.cff docs/reference/api.md docs/examples/pso.py solvers/helpers/ikbench{.py,_program.hpp} cli/gate.sh; do
  [ -s "prefix/share/doc/ikbench/$file" ] || fail "not installed: $file"
done
! can readelf || looks_in '\$ORIGIN/[^:]+' prefix/bin/ikbench
! grep -rlF "$tree" prefix/lib*/cmake prefix/lib*/*/cmake 2>/dev/null || fail "the package holds the path of its source"
# No path of the source is in it, but for the lines that a debugger or a sanitizer tells.
if [ -z "$sanitizers" ] && can strip; then
  strip -o stripped prefix/bin/ikbench
  ! grep -aoE "(^|[^.[:alnum:]])$tree/.{9}" stripped || fail "the program holds the path of its source"
fi

version=$("$program" --version | cut -d' ' -f 2)
equal "version of CITATION.cff" "$(sed -n 's/^version: //p' "$tree/CITATION.cff")" "$version"
equal "first version of CHANGELOG.md" "$(sed -n 's/^## \([0-9.]*\).*/\1/p' "$tree/CHANGELOG.md" | head -n 1)" "$version"
! can git || equal "tags of this commit" "$(git -C "$tree" tag --list --points-at HEAD 'v*' 2>/dev/null | grep -vxE "v${version%%.*}|v${version%.*}|v$version" || true)" ""

# The packages, as ./setup --with-package release package makes them: the program, with the libraries that it needs.
if can dpkg-shlibdeps file; then
  for folder in again package; do
    "$(dirname "$cmake")/cpack" --config "$(dirname "$program")/CPackConfig.cmake" -B "$work/$folder" >.log 2>&1 || fail "no package: $(<.log)"
  done
  equal "packages made again" "$(cd again && sha256sum ikbench*)" "$(cd package && sha256sum ikbench*)"
  equal "packages of the version" "$(compgen -G "package/ikbench[-_]${version}[-_]*" | grep -c "\(deb\|tar.gz\|whl\)$")" 3
  dpkg-deb -x package/ikbench_*.deb unpacked
  tar -xzf package/ikbench-*.tar.gz
  for each in libfmt libnlopt liborocos-kdl libsqlite3; do
    [ ! -e /usr/share/doc/$each-dev ] || [ -s unpacked/usr/share/doc/ikbench/licenses/$each-dev ] || fail "no notice of $each"
  done
  equal "other than C's libraries" "$(dpkg-deb -f package/ikbench_*.deb Depends | tr ',' '\n' | grep -cvE ' ?(lib(c6|gcc-s1|stdc\+\+6|m6|[a-z]*san[0-9]))\b' || true)" 0
  prefixes=(unpacked/usr ikbench-*/)
  if python3 -c 'import ensurepip, venv' 2>/dev/null; then
    prefixes+=(venv)
    python3 -m venv venv && venv/bin/pip install -q --no-index --no-deps package/ikbench-*.whl >.log 2>&1 || fail "no wheel: $(<.log)"
    # The tutorial's solver finds the wheel's module, and a notebook the results, which pandas would hold.
    mkdir notebook
    cp "$tree/docs/examples/pso.py" notebook/mine.py
    (cd notebook && env -i PATH="$work/venv/bin:/usr/bin" ikbench check-solver -- python3 mine.py >../.out 2>&1) || fail "the wheel's module: $(<.out)"
    (cd notebook && ../venv/bin/ikbench run slim2023 "${small[@]}" --figures none --out made >../.out 2>&1) || fail "$(<.out)"
    printf 'import csv\ndef read_csv(file): return list(csv.DictReader(file))\nDataFrame = list\n' >notebook/pandas.py
    (cd notebook && ../venv/bin/python -c 'import ikbench
assert len(ikbench.solves("made")) == len(ikbench.solves("made/store.sqlite", "slim2023")) > 5
assert "verdict" in ikbench.results("made")[0] and ikbench.results("made", "groups")') || fail "no results in Python"
    # A function in a notebook is a solver; the wheel's ikbench_notebook.py calls it. ./check --all tries it with pandas, too.
    cells() { (cd wheel && ../venv/bin/python "$scripts/cells.py" "$tree/docs/examples/notebook.ipynb" >../.out 2>&1) || fail "the wheel's notebook: $(<.out)"; }
    mkdir wheel
    cells
    if [ -n "${IKBENCH_ALL:-}" ]; then
      venv/bin/pip install -q --only-binary :all: --require-hashes -r "$scripts/pandas.txt" >.log 2>&1 || fail "no pandas: $(<.log)"
      cells
      (cd wheel && ../venv/bin/python "$scripts/notebook.py" "$(echo "$work"/venv/lib/python3*/site-packages)" >../.out 2>&1) || fail "with pandas: $(<.out)"
      has "$(<.out)" "pandas "
    fi
    has "$(venv/bin/pip show ikbench)" "compares inverse-kinematics solvers"
  else
    echo "skipped in part: no ensurepip"
  fi
  for folder in "${prefixes[@]}"; do
    equal "program in $folder" "$(env -i "$folder/bin/ikbench" --version)" "$("$program" --version)"
    while read -r file; do
      ! can readelf || looks_in '\$ORIGIN/[^:]+' "$file"
    done < <(find "$folder/bin/ikbench" "$folder/lib/ikbench" -type f)
    ! ldd "$folder/bin/ikbench" | grep -F libfmt | grep -vF "/lib/ikbench/" || fail "$folder does not use its own libraries"
  done
fi

# It runs where the source and the build are not to be seen.
away=()
if unshare --map-root-user --mount true 2>/dev/null; then
  away=(unshare --map-root-user --mount bash -c 'mount -t tmpfs none "$0" && [ -z "$(ls -A "$0")" ] && exec "$@"' "$tree")
else
  echo "skipped in part: no unshare of what is mounted"
fi
"${away[@]}" "$work/prefix/bin/ikbench" run slim2023 "${small[@]}" --out made >.out 2>.err || fail "installed: $(<.err)"
for file in store.sqlite report.md report.html tables/results.csv figures/source/style.gp; do [ -s "made/$file" ] || fail "no $file"; done
! can gnuplot || [ -s made/figures/error-boxes.svg ] || fail "no figure"

# A project of somebody else's. Sanitizers are asked of it by the libraries.
cp -r "$tree/tests/install" project
"$cmake" -S project -B built -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_PREFIX_PATH="$work/prefix" >.log 2>&1 &&
  "$cmake" --build built >.log 2>&1 || fail "cannot build a project with the package: $(<.log)"
built/mine >.out 2>.err || fail "the project's program: $(<.err)"
grep -q mine .out && grep -q random .out || fail "no verdict: $(<.out)"
[ "$("$program" export made/store.sqlite --study mine | grep -c ',mine,')" -ge 12 ] || fail "not all solves of the project's solver"
built/first >.out 2>.err && grep -q "^ok, " .out || fail "the first program: $(<.out) $(<.err)"

# The same project with the source as a part of it, which says nothing of how that is built: as it is measured, without
# tests. One unit shows that it compiles; all take minutes.
"$cmake" -S project -B part -DCMAKE_CXX_COMPILER="$compiler" -DIKBENCH_SOURCE="$tree" -DBUILD_TESTING=ON \
  -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >.log 2>&1 &&
  "$cmake" --build part --target ikbench_numerics_portable >.log 2>&1 || fail "cannot be a part of a project: $(<.log)"
grep -qF -- "-I$tree/packaging" part/compile_commands.json || fail "a part of a project does not find ikbench.hpp"
! grep -q Catch2 part/CMakeCache.txt part/compile_commands.json || fail "a part of a project brings its tests"
equal "sources of its own without optimization" "$(grep '"command"' part/compile_commands.json | grep -v /project/ | grep -vc -e ' -O[12] ' || true)" 0

#!/usr/bin/env bash
# Whether all code within the solve clock is compiled in one way: clocked_code.sh NINJA BUILD_FOLDER OBJECT...
# The objects hold that code. All are compiled at one level of optimisation, and the program has their copies of inline
# functions that other objects have, too: the linker keeps one copy, and its map tells whose.
set -euo pipefail
export LC_ALL=C.UTF-8
ninja=$1 build=$2
shift 2
cd "$build"
command -v "${NM:=nm}" >/dev/null || { echo "skipped: no nm"; exit 77; }
commands=$("$ninja" -t commands ikbench 2>/dev/null) || { echo "skipped: not built by ninja"; exit 77; }
objects=("${@#"$PWD"/}")            # as ninja names them
objects=("${objects[@]//\/.\///}")  # A/./B is A/B
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

levels=$(for object in "${objects[@]}"; do
  command=$(grep -F -- " -o $object " <<<"$commands") || echo "not compiled for ikbench: $object"
  grep -oE -- ' -O[0-9a-z]*' <<<"$command" | tail -1
done | sort | uniq -c)
(($(wc -l <<<"$levels") == 1)) || { echo "expected one level of optimisation, found:"; echo "$levels"; exit 1; }

link=$(tail -1 <<<"$commands")
[[ $link == *" -o ikbench "* ]] || { echo "expected the command that links ikbench, found: $link"; exit 1; }
bash -c "${link/ -o ikbench / -Wl,-Map=$scratch/map -o $scratch/ikbench }"

printf '%s\n' "${objects[@]}" >"$scratch/objects"
"$NM" --defined-only --format=posix "${objects[@]}" | awk '$2 == "W" { print $1 }' >"$scratch/functions"
"$NM" --defined-only --format=posix "$scratch/ikbench" >"$scratch/addresses"
# A line of the map is a section, its address, its size and its object. A long name has a line of its own.
awk -v build="$PWD/" -v scratch="$scratch" '
  function address(hex) {
    sub(/^(0x)?0*/, "", hex)
    return hex
  }
  BEGIN {
    while ((getline < (scratch "/objects")) > 0) is_clocked[$1]
    while ((getline < (scratch "/functions")) > 0) is_of_clocked[$1]
    while ((getline < (scratch "/addresses")) > 0) if ($1 in is_of_clocked) used[".text." $1] = address($3)
  }
  /^Memory Configuration/ { is_kept = 1 }
  is_kept && $1 in used {
    section = $1
    if (NF == 1) {
      getline
      $0 = section " " $0
    }
    if (address($2) != used[section]) next  # a copy that nobody calls
    object = $4
    sub(build, "", object)
    gsub("/[.]/", "/", object)
    ++found
    if (!(object in is_clocked)) {
      ++wrong
      print section, "is that of", object
    }
  }
  END {
    print wrong + 0, "of", found + 0, "inline functions of clocked code are those of other objects"
    exit wrong > 0 || !found
  }' "$scratch/map"

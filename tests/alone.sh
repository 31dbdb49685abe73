#!/usr/bin/env bash
# Whether each source of the program includes what it uses: alone.sh BUILD_FOLDER (made by ninja).
# The build compiles a folder as one unit, so one source may live on what another includes. Here each is read by itself. The
# compiler stops at its end, before it would instantiate templates, as the build does. Headers of others that a source
# includes in any way are precompiled for it, so this does not find one that is included too late.
set -euo pipefail
export LC_ALL=C.UTF-8
root=$PWD/
cd "$1"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

units=$(ninja -t commands ikbench | grep -E -- ' -c [^ ]*/Unity/unity_[^ ]*$')
compiler=$(grep -oE '[^ ]+ -D' <<<"$units" | head -1)
options=$(grep -oE -- ' (-D|-I|-isystem |-std=|--param=)[^ ]+' <<<"$units" | grep -v FORTIFY_SOURCE | sort -u | tr -d '\n')
compile="${compiler% -D}$options"
sed 's/.* -c //' <<<"$units" | xargs sed -n 's/^#include "\(.*\)"$/\1/p' | sort >"$scratch/sources"
(($(wc -l <"$scratch/sources") > 0)) || { echo "no source is part of a unit"; exit 1; }

# A source is read after the first of these lists of which it includes everything.
lists=("CLI/CLI.hpp Eigen/Core Eigen/Geometry fmt/format.h nlohmann/json.hpp"
  "Eigen/Core Eigen/Geometry fmt/format.h nlohmann/json.hpp" "Eigen/Core Eigen/Geometry fmt/format.h"
  "Eigen/Core Eigen/Geometry" "fmt/format.h nlohmann/json.hpp" "fmt/format.h")
printf '%s\n' "${lists[@]}" >"$scratch/lists"
awk -v lists="$scratch/lists" -v root="$root" '
  function note_includes(file,    line, path, folder) {
    if (file in seen) return
    seen[file]
    folder = file
    sub(/[^\/]*$/, "", folder)
    while ((getline line < file) > 0) {
      if (line !~ /^#include [<"]/) continue
      path = line
      gsub(/^#include [<"]|[>"].*$/, "", path)
      if (line ~ /</) {
        is_included[path]
      } else {
        note_includes(root path)
        note_includes(folder path)
      }
    }
    close(file)
  }
  function first_list(    i, j, n, headers) {
    for (i = 0; i < count; ++i) {
      n = split(list[i], headers, " ")
      for (j = 1; j <= n && headers[j] in is_included; ++j) continue
      if (j > n) return i
    }
    return "none"
  }
  BEGIN { while ((getline line < lists) > 0) list[count++] = line }
  {
    split("", seen)
    split("", is_included)
    note_includes($0)
    print first_list(), $0
  }' "$scratch/sources" >"$scratch/work"

touch "$scratch/none.hpp"
for i in "${!lists[@]}"; do
  printf '#include <%s>\n' ${lists[i]} >"$scratch/$i.hpp"
  echo "$scratch/$i.hpp"
done | xargs -P "$(nproc)" -I '{}' $compile -x c++-header '{}' -o '{}.gch'

read_alone() {  # read_alone LIST SOURCE
  local said
  said=$(printf '#include "%s"\nstatic_assert(false, "the end");\n' "$2" |
    $compile -include "$scratch/$1.hpp" -fsyntax-only -Wfatal-errors -Winvalid-pch -x c++ - 2>&1) || true
  [[ $said != "<stdin>:2:"*"the end"* ]] || return 0
  printf '%s\n' "$2 does not compile by itself:" "$said"
  return 1
}
export -f read_alone
export compile scratch
xargs -a "$scratch/work" -L 1 -P "$(nproc)" bash -c 'read_alone "$@"' -

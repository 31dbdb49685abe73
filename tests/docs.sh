#!/usr/bin/env bash
# Every link of the documentation leads to a file of the repository, and to a heading in it.
set -euo pipefail
export LC_ALL=C.UTF-8
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"/..
broken=0

# anchors PAGE: those of its headings, as on the repository's web page.
anchors() {
  awk '/^```/ { code = !code } !code && /^#/' "$1" | sed 's/^#* //' | tr '[:upper:] ' '[:lower:]-' | sed 's/[][!-,./:-@\\^`{-~]//g'
}

shopt -s globstar
for page in *.md docs/**/*.md; do
  while read -r link; do
    [[ $link != *://* ]] || continue
    file=${link%%#*} heading=
    [[ $link != *#* ]] || heading=${link#*#}
    [[ -n $file ]] && file=$(dirname "$page")/$file || file=$page
    [[ -e $file ]] && { [[ -z $heading ]] || anchors "$file" | grep -qxF -- "$heading"; } && continue
    echo "$page links $link" >&2
    broken=1
  done < <(awk '/^```/ { code = !code } !code' "$page" | grep -oP '\]\(\K[^)\s]+(?=\))')
done
exit $broken

#!/usr/bin/env bash
# attach.sh PACKAGE...: attaches packages to the release of the tag that the workflow runs for (GITHUB_REF_NAME), by gh. Makes
# the release if there is none, as a draft, with what CHANGELOG.md says of the version. A tag that moves, as v2, has none.
set -euo pipefail
export LC_ALL=C.UTF-8
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"/..
version=$(sed -n 's/^project(ikbench VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
tag=${GITHUB_REF_NAME:?}
(($#)) || { echo "attach: expected packages, as build/release/ikbench*" >&2; exit 1; }
[[ $tag =~ ^v[0-9]+\.[0-9]+\.[0-9]+$ ]] || { echo "attach: '$tag' names no single version, so nothing is attached"; exit; }
[[ $tag == "v$version" ]] || { echo "attach: the tag is '$tag'; expected v$version of CMakeLists.txt" >&2; exit 1; }
if ! gh release view "$tag" >/dev/null 2>&1; then
  awk -v version="$version" '/^## / { inside = index($2, version) == 1; next } inside' CHANGELOG.md |
    gh release create "$tag" --verify-tag --draft --title "ikbench $version" --notes-file -
fi
gh release upload "$tag" "$@" --clobber

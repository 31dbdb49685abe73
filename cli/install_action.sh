#!/usr/bin/env bash
# Finds or installs what cli/gate.sh runs for action.yml, and writes the paths to GITHUB_OUTPUT as `program` and `old`.
# IKBENCH, a program that is there, is taken as it is. Without it, if a tag of this version uses the Action (ACTION_REF is v2,
# v2.0 or v2.0.0 in version 2.0.0), the package of its release is downloaded; otherwise the Action's own source is built.
# OLD is a program, or the tag of a version whose package is downloaded, too.
# A package is used only if its SHA-256 stands in PACKAGES: lines of a version, a system and the SHA-256.
set -euo pipefail
export LC_ALL=C.UTF-8
refuse() {
  printf 'gate: %s\n' "$1" >&2
  exit 1
}
quoted() { printf '%q' "${1:0:60}"; }  # on one line, so that no text is a command to the forge
# Checks a program that the workflow names.
named() {
  [[ $2 != *$'\n'* && -n $(type -P -- "$2") ]] || refuse "$1 is $(quoted "$2"); expected $3"
}

action=${GITHUB_ACTION_PATH:?} folder=${RUNNER_TEMP:?} output=${GITHUB_OUTPUT:?}
program=${IKBENCH:-} old=${OLD:-} packages=${PACKAGES:-}
ref=${ACTION_REF:-} repository=${ACTION_REPOSITORY:-} server=${GITHUB_SERVER_URL:-https://github.com}
ref=${ref#refs/tags/}
tag='^v[0-9]+(\.[0-9]+){0,2}$'
system=$(uname -sm | tr 'A-Z ' 'a-z-')  # linux-x86_64

# Prints the newest version that has a package for this system and that the tag names: 2.0.1 for v2 and v2.0.
version_of() {
  awk -v machine="$system" -v version="${1#v}" \
    '$2 == machine && $1 ~ /^[0-9]+\.[0-9]+\.[0-9]+$/ && index($1 ".", version ".") == 1 { print $1 }' <<<"$packages" | sort -V | tail -n 1
}

# Downloads the package of a version, checks and unpacks it, and prints the path of its program.
take_package() {
  local name=ikbench-$1-$system sum at
  [[ $server =~ ^https://[A-Za-z0-9.-]+(:[0-9]+)?$ ]] || refuse "GITHUB_SERVER_URL is $(quoted "$server"); expected https://github.com"
  [[ $repository =~ ^[A-Za-z0-9][A-Za-z0-9_-]*/[A-Za-z0-9_][A-Za-z0-9_.-]*$ ]] || refuse "ACTION_REPOSITORY is $(quoted "$repository"); expected OWNER/ikbench"
  sum=$(awk -v machine="$system" -v version="$1" '$2 == machine && $1 == version { print $3 }' <<<"$packages" | tail -n 1)
  [[ $1 =~ ^[0-9]+\.[0-9]+\.[0-9]+$ && $sum =~ ^[0-9a-f]{64}$ ]] ||
    refuse "PACKAGES of action.yml has $(quoted "$1 $sum"); expected a version and a SHA-256"
  at=$(mktemp -d "$folder/ikbench.XXXXXX")
  local address=$server/$repository/releases/download/v$1/$name.tar.gz
  curl --fail --silent --show-error --location --proto '=https' --proto-redir '=https' --retry 3 --max-time 300 \
    --max-filesize 200000000 --output "$at/package" -- "$address" >&2 ||
    refuse "cannot download $address; expected the release's package; or name a program that is there (ikbench: PATH)"
  sha256sum --check --status <<<"$sum  $at/package" ||
    refuse "$address has the SHA-256 $(sha256sum "$at/package" | cut -d ' ' -f 1); expected $sum of action.yml; it is not used"
  tar -xzf "$at/package" -C "$at" --no-same-owner || refuse "cannot unpack $address"
  [[ -x $at/$name/bin/ikbench ]] || refuse "$address has no $name/bin/ikbench"
  printf 'gate: takes %s\n' "$address" >&2
  printf '%s\n' "$at/$name/bin/ikbench"
}

if [[ -n $program ]]; then
  named IKBENCH "$program" "a program that is there; or leave it out, and the Action installs one"
else
  version=$(sed -n 's/^project(ikbench VERSION \([0-9.]*\).*/\1/p' "$action/CMakeLists.txt")
  if [[ ! $ref =~ $tag || $version. != "${ref#v}".* ]]; then
    reason="$(quoted "$ref") is not a tag of version $version"
  elif [[ $(version_of "v$version") != "$version" ]]; then
    reason="action.yml names no package of version $version for $system"
  else
    reason=""
  fi
  if [[ -z $reason ]]; then
    program=$(take_package "$version")
  else
    echo "gate: builds its own source: $reason" >&2
    "$action/setup" release ikbench >&2 || refuse "cannot build $action; expected a system of docs/install.md"
    program=$action/build/release/ikbench
  fi
fi
if [[ $old =~ $tag ]]; then
  version=$(version_of "$old")
  [[ -n $version ]] ||
    refuse "OLD is $old, of which action.yml names no package for $system; expected the tag of one that it names, or a program"
  old=$(take_package "$version")
elif [[ -n $old ]]; then
  named OLD "$old" "the tag of a version, such as v2.0, or a program that is there"
fi
printf '%s\n' "program=$program" "old=$old" >>"$output"

#!/usr/bin/env bash
# Keeps the SHA-256 of each release's packages in action.yml, by which cli/install_action.sh checks what it downloads.
#
#   packaging/action_packages.sh write build/release/ikbench-*.tar.gz   adds the packages of this version, before it is tagged
#   packaging/action_packages.sh check [ikbench-*.tar.gz...]            refuses a tag whose packages are missing, or are others
#
# A package names the commit that it was built from, so the commit that is tagged comes right behind that one and changes
# action.yml alone. ACTION is another action.yml, for tests.
set -euo pipefail
export LC_ALL=C.UTF-8
root=$(dirname "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")")
action=${ACTION:-$root/action.yml}
version=$(sed -n 's/^project(ikbench VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
refuse() {
  echo "action_packages: $1" >&2
  exit 1
}
# Prints the line of a package: its version, its system and its SHA-256.
line() {
  local name=${1##*/}
  [[ $name =~ ^ikbench-${version//./\\.}-(linux-[a-z0-9_]+)\.tar\.gz$ ]] ||
    refuse "$name is not an archive of version $version; expected ikbench-$version-linux-x86_64.tar.gz"
  printf '%s %s %s\n' "$version" "${BASH_REMATCH[1]}" "$(sha256sum <"$1" | cut -d ' ' -f 1)"
}
# Tells whether action.yml has a line that begins with the text.
stands() { sed -n '/PACKAGES: |/,/^ *- /s/^ *//p' "$action" | grep -q -- "^$1"; }

case ${1:-} in
  write)
    (($# > 1)) || refuse "write needs the packages; expected build/release/ikbench-*.tar.gz"
    for package in "${@:2}"; do
      text=$(line "$package")
      grep -v "^ *${text% *} " "$action" >"$action.new"
      awk -v text="$text" '/PACKAGES: \|/ { inside = 1 } inside && /^ *- / { print "          " text; inside = 0 } { print }' \
        "$action.new" >"$action"
      rm "$action.new"
      stands "$text" || refuse "$action has no PACKAGES in front of another step"
    done
    ;;
  check)
    stands "$version linux-x86_64 [0-9a-f]\{64\}$" ||
      refuse "action.yml names no package of version $version; expected what packaging/action_packages.sh write adds before a tag"
    for package in "${@:2}"; do
      text=$(line "$package")
      stands "$text" || refuse "action.yml names another package than $text; do not publish this tag"
    done
    ;;
  *) refuse "'${1:-}' is not known; expected write or check" ;;
esac

#!/usr/bin/env bash
# action.yml installs what it runs: its steps, run as a forge's runner does, with a folder in place of the forge's releases.
source "$(dirname "$0")/common.sh"
system=linux-$(uname -m)
version=$("$program" --version | cut -d ' ' -f 2)

# The Action as a runner unpacks it, with a setup that only notes that it was called.
mkdir -p action/cli action/build/release bin releases
cp "$root"/{action.yml,CMakeLists.txt} action
cp "$root"/cli/{gate,install_action}.sh action/cli
printf '#!/bin/sh\nexec "%s" "$@"\n' "$program" >action/build/release/ikbench
printf '#!/bin/sh\necho "$@" >>"%s/built"\n' "$work" >action/setup
# A curl that knows the releases' folder alone, and the options without which the real one is not safe.
cat >bin/curl <<'CURL'
#!/usr/bin/env bash
echo "$*" >>"$RELEASES.calls"
[[ " $* " == *" --fail "*" --proto =https --proto-redir =https "* && ${*: -2:1} == -- ]] || exit 2
while [[ $1 != --output ]]; do shift; done
[[ $4 == https://github.com/owner/ikbench/releases/download/* && -e $RELEASES/${4##*/download/} ]] || { echo "curl: (22) 404" >&2; exit 22; }
cp "$RELEASES/${4##*/download/}" "$2"
CURL
sed -i "2i RELEASES=$work/releases" bin/curl
chmod +x action/setup action/build/release/ikbench bin/curl
PATH=$work/bin:$PATH

# release VERSION: a package, whose program notes its calls.
release() {
  local name=ikbench-$1-$system
  mkdir -p "$name/bin" "releases/v$1"
  printf '#!/bin/sh\necho "$@" >>"%s/calls-%s"\nexec "%s" "$@"\n' "$work" "$1" "$program" >"$name/bin/ikbench"
  chmod +x "$name/bin/ikbench"
  tar -czf "releases/v$1/$name.tar.gz" "$name"
}
release "$version"
release 1.9.0
release 1.9.1
list() { ACTION=$work/action/action.yml "$root/packaging/action_packages.sh" "$@"; }
other() { sed "s/^project(ikbench VERSION [0-9.]*/project(ikbench VERSION $1/" "$root/CMakeLists.txt"; }

# The list of packages: what is not in it, or is another one, is refused before it is published.
! list check 2>.err || fail "a tag without a package passes"
has "$(<.err)" "names no package of version $version"
cp -r "$root/packaging" listed
mkdir old && cp -r listed old/packaging
for each in 1.9.0 1.9.1; do
  other $each >old/CMakeLists.txt
  ACTION=$work/action/action.yml old/packaging/action_packages.sh write "releases/v$each/ikbench-$each-$system.tar.gz" || fail "cannot list $each"
done
cp action/action.yml without.yml
cp "releases/v$version/ikbench-$version-$system.tar.gz" "ikbench-$version-linux-x86_64.tar.gz"
list write "ikbench-$version-linux-x86_64.tar.gz" && list check "ikbench-$version-linux-x86_64.tar.gz" || fail "cannot list $version"
cp action/action.yml right.yml
echo other >"ikbench-$version-linux-x86_64.tar.gz"
! list check "ikbench-$version-linux-x86_64.tar.gz" 2>.err || fail "another package passes"
has "$(<.err)" "do not publish"
list write "ikbench-$version-linux-x86_64.tar.gz" && cp action/action.yml wrong.yml
equal "lines of packages" "$(grep -cE '^ {10}[0-9.]+ linux-[a-z0-9_]+ [0-9a-f]{64}$' wrong.yml)" 3
! list write releases/v1.9.0/*.tar.gz 2>.err || fail "a package of another version is listed"
[ "$system" = linux-x86_64 ] || { sed "s/linux-x86_64/$system/" right.yml >.yml && mv .yml right.yml; sed "s/linux-x86_64/$system/" wrong.yml >.yml && mv .yml wrong.yml; }
if can git && [ -n "$(git -C "$root" tag --points-at HEAD 'v*' 2>/dev/null)" ]; then
  "$root/packaging/action_packages.sh" check || fail "a version is tagged without its packages in action.yml"
fi

printf 'robot = "ur5e"\nsearch = "pose"\nruns = 4\n[path]\nkind = "random"\npoints = 2\n[stop]\nevaluations = 200\ntolerance_cm = 0.1\ntolerance_deg = 1\n[[solvers]]\nsolver = "levenberg_marquardt"\nlabel = "LM"\n' >my.toml

# action CODE OUTCOME REF [INPUT=VALUE]...
action() {
  local code=0 expected=$1 outcome=$2
  rm -f built calls-* releases.calls
  python3 "$scripts/runner.py" "$work/action" "${@:3}" >.out 2>.err || code=$?
  [[ $code =~ ^($expected)$ ]] || fail "the Action (${*:3}): exit code $code, expected $expected; it said $(<.out) $(<.err)"
  [[ $(sed -n 's/^outcome=//p' .out) =~ ^($outcome)$ ]] || fail "outcome (${*:3}): $(<.out), expected $outcome; it said $(<.err)"
}
package=$work/calls-$version

# A version's tag has its package, and what is not listed is built.
cp right.yml action/action.yml
for ref in v${version%%.*} v$version refs/tags/v${version%.*}; do
  action 0 no-baseline $ref study=my.toml
  [[ -s $package && ! -e built ]] || fail "$ref does not take the package: $(<.err)"
done
equal "calls of curl" "$(sed 's|.* --output|--output|' releases.calls)" "--output ${work}$(grep -oE '/runner/temp/ikbench\.\w+/package' releases.calls) -- https://github.com/owner/ikbench/releases/download/v$version/ikbench-$version-$system.tar.gz"
has "$(<.out)" "Nothing was compared"
action 0 passed v2 study=my.toml require=solved=10%
for ref in '' main v3 v1 v20 v2.0.0.0 v2.0-rc1 "v2;touch evil" v2/../v1 "$(printf 'a%.0s' {1..40})" $'v2\nv2'; do
  action 0 no-baseline "$ref" study=my.toml
  equal "build of '$ref'" "$(cat built)" "release ikbench"
  [[ ! -e $package && ! -e releases.calls ]] || fail "'$ref' takes a package"
done
cp without.yml action/action.yml
action 0 no-baseline v2 study=my.toml
[[ -e built && ! -e releases.calls ]] || fail "what is not listed is not built"
has "$(<.err)" "names no package of version $version"

# A wrong or missing package is not used, and nothing else is.
cp wrong.yml action/action.yml
action 1 failed v2 study=my.toml
has "$(<.err)" "it is not used"
[[ ! -e $package && ! -e built ]] || fail "a wrong package is used"
cp right.yml action/action.yml
mv releases/v$version away
action 1 failed v2 study=my.toml
has "$(<.err)" "cannot download https://github.com/owner/ikbench/releases/download/v$version/"
[[ ! -e built ]] || fail "a missing package is built"
mv away releases/v$version
sed -i "s/^\( *$version .*\)../\1/" action/action.yml
action 1 failed v2 study=my.toml
has "$(<.err)" "expected a version and a SHA-256"
cp right.yml action/action.yml

# The older program is a tag, whose newest package is taken, or a program; times may be incomparable on a busy machine.
action '[0134]' '.*' v2 study=my.toml old=v1.9 rounds=4 out=turns
[[ -s calls-1.9.1 && ! -e calls-1.9.0 && -s $package ]] || fail "v1.9 is not 1.9.1: $(<.err)"
equal "solves of both" "$(solves turns/store.sqlite) $(solves turns/before/store.sqlite)" "8 8"
action '[0134]' '.*' v2 study=my.toml "old=$program" rounds=4 out=turns
equal "solves of both" "$(solves turns/store.sqlite) $(solves turns/before/store.sqlite)" "8 8"
for old in v1.8 v1.9.2 v1.9-rc1 nowhere 'v1.9;touch evil' $'x\n::error::y' --version; do
  action 1 failed v2 study=my.toml "old=$old"
  has "$(<.err)" "gate: OLD is "
  ! grep -q '^::error' .out .err || fail "an input commands the forge: $(<.err)"
done

# A program that is there is taken.
action 0 no-baseline v2 study=my.toml "ikbench=$program"
[[ ! -e built && ! -e releases.calls ]] || fail "more than the program that is there is used"
for named in nowhere $'ikbench\nold=ikbench' '; touch evil'; do
  action 1 failed v2 study=my.toml "ikbench=$named"
  has "$(<.err)" "gate: IKBENCH is "
done
for odd in GITHUB_SERVER_URL=file:///tmp GITHUB_SERVER_URL=https://github.com/.. ACTION_REPOSITORY=../.. ACTION_REPOSITORY=a/b/c; do
  ! env GITHUB_ACTION_PATH="$work/action" RUNNER_TEMP="$work" GITHUB_OUTPUT="$work/.output" ACTION_REPOSITORY=owner/ikbench ACTION_REF=v2 \
    PACKAGES="$(sed -n 's/^ \{10\}//p' right.yml)" "$odd" bash action/cli/install_action.sh 2>.err || fail "$odd is taken"
  has "$(<.err)" "gate: ${odd%%=*} is "
done
[ ! -e evil ] || fail "an input is a command"

# Packages go to the release of their own tag alone; a tag that moves, as v2, has none.
cat >bin/gh <<'GH'
#!/usr/bin/env bash
echo "$*" >>"$CALLS"
[[ "$1 $2" != "release create" ]] || cat >"$CALLS.notes"
[[ "$1 $2" != "release view" ]]
GH
chmod +x bin/gh
export CALLS=$work/gh
attach() { GITHUB_REF_NAME=$1 "$root/packaging/attach.sh" "${@:2}" >.out 2>.err; }
attach "v${version%%.*}" a.deb || fail "a tag that moves fails: $(<.err)"
! attach v1.9.0 a.deb || fail "another version is attached"
! attach "v$version" || fail "no package is attached"
[ ! -e gh ] || fail "gh is asked: $(<gh)"
attach "v$version" a.deb b.whl || fail "cannot attach: $(<.err)"
equal "calls of gh" "$(paste -sd ';' gh)" "release view v$version;release create v$version --verify-tag --draft --title ikbench $version --notes-file -;release upload v$version a.deb b.whl --clobber"
has "$(head -n 5 gh.notes)" '###'
has_no "$(<gh.notes)" '# Changelog'

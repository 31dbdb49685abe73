#!/usr/bin/env bash
# libraries.sh [ARM...] [--set KEY=VALUE...]: libraries.toml and, where its programs are installed, libraries_cpp.toml on each
# arm, built in or a file (my_arm.urdf), by default three: after other work and once more with each call made twice in a row,
# the second timed (-warm). Into OUT (out/libraries); then who solves and how fast (docs/which-library.md), for each file in a
# table of its own. With a name only that study, once. On a path ssik is asked for the answer nearest to the one before. Before
# it: install.sh. IKBENCH is the program, if it is not on the PATH.
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")") arms=() files=() code=0 out=${OUT:-out/libraries}
while (($#)) && [[ $1 != -* ]]; do arms+=("$1") && shift; done
((${#arms[@]})) || arms=(franka_panda kuka_iiwa14 ur5e)
studies=(libraries) states=(first warm)
if [[ " $* " == *" name="* ]]; then
  states=(first)
elif compgen -G "$here/../../build/libraries/*.cpp/program" >/dev/null; then
  studies+=(libraries_cpp)
fi
[[ " $* " != *" start=previous "* ]] || set -- "$@" --set ssik.answers=nearest
for arm in "${arms[@]}"; do
  file=$(basename "$arm")
  name=${file%.*}
  [[ $name == "$file" ]] || files+=("$name")
  for study in "${studies[@]}"; do
    for state in "${states[@]}"; do
      end=""
      [[ $state == first ]] || end=-warm
      "${IKBENCH:-ikbench}" run "$here/$study.toml" --robot "$arm" --set name="${study/_/-}-$name$end" --set state="$state" \
        --no-report --out "$out" "$@" || code=$?
    done
  done
done
ask() {  # TABLE [PARAMETER VALUE]
  sqlite3 -header -markdown ${2:+-cmd ".parameter set :$2 \"'$3'\""} "$out/store.sqlite" <"$here/$1.sql"
}
if ((${#files[@]} < ${#arms[@]})); then
  ask who
  for study in "${studies[@]}"; do ask times study "${study/_/-}"; done
fi
for name in "${files[@]}"; do printf '\n%s\n' "$name" && ask arm arm "$name"; done
exit $code

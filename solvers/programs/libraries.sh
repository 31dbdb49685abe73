#!/usr/bin/env bash
# libraries.sh [ARM...] [--set KEY=VALUE...]: libraries.toml, and where its programs are installed and no name is set
# libraries_cpp.toml, on each arm, built in or a file (my_arm.urdf), by default three, into OUT (out/libraries); then who
# solves (docs/which-library.md), and a table of times. Before it: install.sh. IKBENCH is the program, if it is not on the
# PATH.
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")") arms=() code=0 out=${OUT:-out/libraries}
while (($#)) && [[ $1 != -* ]]; do arms+=("$1") && shift; done
((${#arms[@]})) || arms=(franka_panda kuka_iiwa14 ur5e)
studies=(libraries)
[[ " $* " == *" name="* ]] || ! compgen -G "$here/../../build/libraries/*.cpp/program" >/dev/null || studies+=(libraries_cpp)
for arm in "${arms[@]}"; do
  for study in "${studies[@]}"; do
    "${IKBENCH:-ikbench}" run "$here/$study.toml" --robot "$arm" --set name="${study/_/-}-$(basename "${arm%.*}")" \
      --no-report --out "$out" "$@" || code=$?
  done
done
for table in who table; do sqlite3 -header -markdown "$out/store.sqlite" <"$here/$table.sql"; done
exit $code

#!/usr/bin/env bash
# libraries.sh [ARM...] [--set KEY=VALUE...]: libraries.toml on each arm, built in or a file (my_arm.urdf), by default
# three, into OUT (out/libraries); then who solves (docs/which-library.md), and a table of times. Before it: install.sh.
# IKBENCH is the program, if it is not on the PATH.
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")") arms=() code=0 out=${OUT:-out/libraries}
while (($#)) && [[ $1 != -* ]]; do arms+=("$1") && shift; done
((${#arms[@]})) || arms=(franka_panda kuka_iiwa14 ur5e)
for arm in "${arms[@]}"; do
  name=$(basename "${arm%.*}")
  "${IKBENCH:-ikbench}" run "$here/libraries.toml" --robot "$arm" --set name="libraries-$name" --no-report \
    --out "$out" "$@" || code=$?
done
for table in who table; do sqlite3 -header -markdown "$out/store.sqlite" <"$here/$table.sql"; done
exit $code

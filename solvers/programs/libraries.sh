#!/usr/bin/env bash
# libraries.sh [ARM...]: libraries.toml for each arm, by default three, into out/libraries; then the table of
# docs/which-library.md. Before it: install.sh. IKBENCH is the program, if it is not on the PATH.
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
store=out/libraries/store.sqlite
for arm in "${@:-franka_panda kuka_iiwa14 ur5e}"; do
  for name in $arm; do
    "${IKBENCH:-ikbench}" run "$here/libraries.toml" --set robot="$name" --set name="libraries-$name" \
      --no-report --out out/libraries
  done
done
sqlite3 -header -markdown "$store" <"$here/table.sql"

#!/usr/bin/env bash
# Readings one at a time and in a grid; Ctrl-C shows what is done.
source "$(dirname "$0")/common.sh"

succeeds readings slim2023 --list
has "$out" "path.tool=eq27"
has "$out" "DE.bounds=reflect"

succeeds readings slim2023 "${small[@]}" --seeds 2 --jobs 2 --out folder
quiet
has "$out" "Printed error of IK-BA: default"
for type in md csv tex; do [ -s "folder/tables/readings.$type" ] || fail "no readings.$type"; done
for type in gp dat; do [ -s "folder/figures/readings.$type" ] || fail "no readings.$type"; done
! command -v gnuplot >/dev/null || [ -s folder/figures/readings.png ] || fail "no picture"
cp folder/tables/readings.csv first.csv
succeeds readings slim2023 "${small[@]}" --seeds 2 --out folder --no-figures
cmp folder/tables/readings.csv first.csv || fail "other numbers with one job"
[ ! -e folder/figures/readings.png ] || fail "a picture of before was left"

succeeds readings slim2023 "${small[@]}" --seeds 1 --grid search=all_joints,DE.bounds=reflect
has "$out" "search=all_joints + DE.bounds=reflect"
[ "$(grep -c ' all ' <<<"$out")" -ge 4 ] || fail "not four combinations: $out"

refused 'unknown interpretation "search=x"' readings slim2023 --grid search=x
refused 'is given twice' readings slim2023 --grid search=all_joints,search=all_joints
refused '--seeds' readings slim2023 --seeds 0
refused 'did you mean "slim2023"' readings slim2024
refused '--set runs' readings slim2023 --set runs=0
refused 'seeds 1 to --seeds' readings slim2023 --set seed=77

stopped_after_a_second readings slim2023 --set runs=5000 --set population=200
has "$(<stopped.err)" "Stopped: "

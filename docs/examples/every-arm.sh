#!/bin/sh
# every-arm.sh [ARM...]: which solvers find reachable poses, and positions, of these arms (all of the library)?
set -e
positions=every_arm_positions.toml
ikbench list studies any-arm | sed '/tolerance_deg/d' >$positions
[ $# -gt 0 ] || set -- $(ikbench list robots | sed -n 's/^\([a-z]\S*\).*/\1/p')
for arm; do
  ikbench run --robot "$arm" --no-report --out "out/every-arm/poses/$arm"
  ikbench run $positions --robot "$arm" --set search=all_joints --set "name=$arm" --no-report --out "out/every-arm/positions/$arm"
done
for kind in poses positions; do ikbench report out/every-arm/$kind/*/store.sqlite --out out/every-arm/$kind; done

#!/bin/sh
# every-arm.sh [ARM...]: which solvers find reachable poses, and positions, of these arms (all of the library)?
set -e
poses=$(dirname "$0")/every_arm.toml positions=every_arm_positions.toml
sed -e '/tolerance_deg/d' -e 's/"pose" .*/"all_joints"/' "$poses" > $positions
[ $# -gt 0 ] || set -- $(ikbench list robots | sed -n 's/^\([a-z]\S*\).*/\1/p')
for arm; do
  for kind in poses positions; do
    eval "ikbench run \$$kind --set robot=$arm --set name=$arm --no-report --out out/every-arm/$kind/$arm"
  done
done
for kind in poses positions; do ikbench report out/every-arm/$kind/*/store.sqlite --out out/every-arm/$kind; done

#!/usr/bin/env bash
# The arm and the study of docs/adding-anything.md are files that the program takes as they are.
source "$(dirname "$0")/common.sh"
examples=$scripts/../examples

succeeds list robots "$examples/robots/arms/long_and_short.toml"
has "$out" "long_and_short: a link of 0.6 m and one of 0.3 m in the x-y plane"
succeeds list studies "$examples/experiments/studies/two-bats.toml"
has "$out" "population = 2  # overrides the population of the study"
succeeds run "$examples/experiments/studies/two-bats.toml" --set runs=2 --set path.points=3 --set stop.iterations=5 --out made
[ "$(solves made/store.sqlite)" = 12 ] || fail "two runs of three points by two solvers are 12 solves"
has "$(<made/report.md)" "50 bats"

#!/usr/bin/env bash
# The arm and the study of docs/adding-anything.md are files that the program takes as they are.
source "$(dirname "$0")/common.sh"
examples=$scripts/../examples

succeeds list robots "$examples/robots/arms/long_and_short.toml"
has "$out" "long_and_short: a link of 0.6 m and one of 0.3 m in the x-y plane"
succeeds list studies "$examples/experiments/studies/two-bats.toml"
has "$out" "population = 2  # overrides the population of the study"
succeeds run "$examples/experiments/studies/two-bats.toml" --set runs=2 --set path.points=3 --set stop.iterations=5 --no-figures --out made
[ "$(solves made/store.sqlite)" = 12 ] || fail "two runs of three points by two solvers are 12 solves"
has "$(<made/report.md)" "50 bats"

# The larger ones, and the poses of the CSV file beside a study.
cp "$examples"/experiments/studies/{ur5e-rectangle.toml,panda-random.toml,path.csv} .
succeeds run ur5e-rectangle.toml --set runs=2 --set path.points=7 --set stop.iterations=5 --no-figures --out rectangle
has "$(<rectangle/report.md)" "joint path length"
has "$(<rectangle/tables/further.csv)" "return_deg"
[ -s rectangle/tables/times.csv ] || fail "there is no table of times"
succeeds run panda-random.toml --set runs=3 --set path.points=2 --set stop.iterations=5 --no-figures --out random
has "$(<random/tables/solved.csv)" "95 % interval low"
has_no "$(<random/report.md)" "distance of the angles after a closed path"
printf 'search = "all_joints"\n[path]\nkind = "csv"\nfile = "path.csv"\n[[solvers]]\nsolver = "bat"\n' >poses.toml
succeeds run poses.toml --set runs=2 --set stop.iterations=5 --no-figures --out poses
[ "$(solves poses/store.sqlite)" = 4 ] || fail "two runs of two poses are 4 solves"
refused 'path.file is "../path.csv"; expected a CSV file in the study' run poses.toml --set path.file=../path.csv

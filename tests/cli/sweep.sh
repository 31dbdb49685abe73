#!/usr/bin/env bash
# Sweeps: every combination of the swept settings is an entry.
source "$(dirname "$0")/common.sh"

cat >my.toml <<END
name = "my"
robot = "planar_2"
search = "all_joints"
runs = 4
[stop]
iterations = 10
[path]
kind = "random"
points = 3
[[solvers]]
label = "mine"
solver = "ik_bat"
population = 6
[[solvers]]
solver = "newton"
END

succeeds run my.toml --no-figures --sweep population=4,8,200 --sweep mine.alpha=0.5,0.9
for entry in 'mine alpha=0.5 population=200' 'newton population=4'; do
  grep -q "^$entry,position_error_cm," out/my/tables/results.csv || fail "no results of $entry: $(<out/my/tables/results.csv)"
done
# The same as lists in the file, as a table, and by --set, so that shards agree: nothing is solved anew.
sed 's/^population = 6/population = [4, 8, 200]\noptions = { alpha = [0.5, 0.9] }/' my.toml >lists.toml
succeeds run lists.toml --no-report --out out/my
has "$out" 'were already stored'
{ printf '[sweep]\npopulation = [4, 8, 200]\nmine.alpha = [0.5, 0.9]\n' | cat <(head -4 my.toml) - <(tail -n +5 my.toml); } >table.toml
succeeds run table.toml --no-report --out out/my
has "$out" '108 solves in out/my/store.sqlite (108 were already stored)'
for shard in 1 2; do succeeds run my.toml --sweep population=4,8,200 --sweep mine.alpha=0.5,0.9 --shard $shard/2; done
succeeds merge merged out/my/shards

refused 'expected setting=values' run my.toml --sweep population
refused '--sweep damping=nan,1: nan is not allowed there' run my.toml --sweep damping=nan,1
refused 'expected a whole number from 1 to 100000' run my.toml --sweep population=4,0
refused 'unknown setting to sweep "alhpa"; did you mean "alpha"?' run my.toml --sweep alhpa=0.5

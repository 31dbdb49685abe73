#!/usr/bin/env bash
# Sweeps of settings, and settings chosen by successive halving and judged on other solves.
source "$(dirname "$0")/common.sh"

study() { # NAME PATH
  cat <<END
name = "$1"
robot = "planar_2"
search = "all_joints"
runs = 4
[stop]
iterations = 10
[path]
$2
[[solvers]]
label = "mine"
solver = "ik_bat"
population = 6
[[solvers]]
solver = "newton"
END
}
study my 'kind = "random"
points = 3' >my.toml

# Mistakes.
refused 'expected several, such as --sweep population=10,20,50' tune my.toml --solver mine --budget 100
refused 'unknown label of the study "mien"; did you mean "mine"?' tune my.toml --solver mien --budget 9 --sweep alpha=0.1,0.2
refused 'expected a setting of mine' tune my.toml --solver mine --budget 100 --sweep newton.population=1,2
refused '4 candidates take at least 18 solves' tune my.toml --solver mine --budget 17 --sweep population=4,6,8,16
refused 'unknown metric "eror"' tune my.toml --solver mine --budget 100 --sweep alpha=0.1,0.2 --metric eror

# 4 x 2 runs, then 2 x 2 more: 12 runs of 3 points.
tune=(tune my.toml --solver mine --budget 50 --sweep population=4,6,8,16 --no-figures)
succeeds "${tune[@]}" --verbose
has "$out" '4 candidates, 2 rounds, 36 solves of training with seed 2'
has "$out" 'my-tuned.toml has them.'
has "$err" 'has the best of 4 settings by position error [cm], found by ikbench tune. The search cost 36 solves'
has_no "$err" 'tuning saw them'
grep -q 'label = .mine tuned' my-tuned.toml || fail "$(<my-tuned.toml)"
grep -q 'found by ikbench tune. The search cost 36 solves' out/my-tuned/report.md || fail "the report does not say what tuning cost"
# The same again solves nothing and chooses the same; the tuned study runs by itself.
cp my-tuned.toml first.toml
chosen=$(flat "$out" | grep -o 'Chosen from 4 candidates, .* population = [0-9]*\.')
succeeds "${tune[@]}"
has "$out" "$chosen"
has "$out" 'my-tuned: 24 solves in out/my-tuned/store.sqlite (24 were already stored)'
cmp -s my-tuned.toml first.toml || fail "the second tuned study is another"
succeeds run my-tuned.toml --no-figures
has "$out" '(24 were already stored)'
# A control and a list of drawn solvers that name the swept solver do not stand in the way.
sed 's/^\[stop\]/[figures]\nsolvers = ["newton", "mine"]\n[analysis]\ncontrol = "mine"\n[stop]/' my.toml >named.toml
succeeds tune named.toml --solver mine --budget 50 --sweep population=4,6,8,16 --no-figures
has "$out" "$chosen"
# With the seed of the training it is no test.
succeeds run my-tuned.toml --verbose --no-figures --set seed=2 --out out/seen
has "$err" 'chosen with the seed of this study'
# With --json there is nothing but JSON.
succeeds "${tune[@]}" --json
python3 -c 'import json, sys; data = json.load(sys.stdin); assert data["tuned_study"] == "my-tuned.toml", data' <<<"$out" || fail "no JSON: $out"
# What is no file of tune stays, and is refused before the training.
rm my-tuned.toml
fresh=("${tune[@]}" --out fresh)
echo 'name = "precious"' >my-tuned.toml
refused 'not written by ikbench tune' "${fresh[@]}"
rm my-tuned.toml && mkfifo my-tuned.toml
refused 'is no regular file' "${fresh[@]}"
rm my-tuned.toml && mkdir my-tuned.toml
refused 'is no regular file' "${fresh[@]}"
rmdir my-tuned.toml && ln -s nowhere my-tuned.toml
refused 'is no regular file' "${fresh[@]}"
rm my-tuned.toml
# So are a style that is none, and names that become too long.
refused '/dev/zero is no regular file' "${fresh[@]}" --style /dev/zero
long_text=$(printf 'x%.0s' {1..196})
refused 'the tuned study could not be read' "${fresh[@]}" --set "title=$long_text"
refused 'the tuned study could not be read' "${fresh[@]}" --set "name=$long_text"
[ ! -e fresh ] && [ ! -e my-tuned.toml ] || fail "solved or written before a refusal"
# Figures of solvers that the tuned study does not have are no mistake.
succeeds "${fresh[@]}" --set 'figures.solvers=["newton"]'
rm my-tuned.toml

# Where the solver has the best settings already, nothing is written and nothing else is solved.
best=(tune my.toml --solver mine --budget 20 --sweep population=6,200 --metric evaluations --no-figures --out best)
succeeds "${best[@]}"
has "$out" 'The search found nothing better than the settings that mine has'
[ ! -e my-tuned.toml ] && [ ! -e best/store.sqlite ] || fail "a study with the settings that the solver has"
succeeds "${best[@]}" --json
python3 -c 'import json, sys; assert json.load(sys.stdin)["tuned_study"] is None' <<<"$out" || fail "no JSON: $out"

# Where the path is fixed, tuning saw the targets.
study fixed 'kind = "circle"
points = 3
radius_cm = 20
centre_cm = [60, 0, 0]' >fixed.toml
succeeds tune fixed.toml --solver mine --budget 20 --sweep alpha=0.5,0.9 --metric evaluations --no-figures --verbose
has "$err" 'tuning saw them, and only the random numbers are new'

# Ctrl-C loses nothing.
study long 'kind = "random"
points = 3' | sed 's/iterations = 10/iterations = 200000/' >long.toml
long=(tune long.toml --solver mine --budget 600 --sweep population=40,60 --no-figures)
stopped_after_a_second "${long[@]}"
has "$(<stopped.err)" 'run the same command again to continue'
[ -s out/long-tuned/training/store.sqlite ] || fail "nothing is kept"
[ ! -e long-tuned.toml ] || fail "a tuned study from half a training"

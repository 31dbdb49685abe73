#!/usr/bin/env bash
# A map: the study of a grid, its sentence, its figure, and no test anywhere; shards, merge, verify and a run of the store.
source "$(dirname "$0")/common.sh"

coarse=(--set path.step_cm=20 --only "LM,DLS,Newton")
succeeds run map --robot ur5e "${coarse[@]}" --out map
screen=$out
has "$screen" "poses that any solver reaches"
has "${screen//$'\n'/ }" "Tool down, plane y = 0, steps of 20 cm"
[[ $screen != *"p <"* && $screen != *Brackets* ]] || fail "a test of a grid: $screen"
[ -s map/figures/map.svg ] || fail "no map.svg"
[ ! -e map/figures/ranks.svg ] && [ ! -e map/figures/differences.svg ] && [ ! -e map/figures/path.svg ] || fail "figures of a sample"
json 'of["comparisons"] == [] and of["tests"] == []' map/results.json
json 'sum("no intervals, tests or ranks" in note for note in of["notes"]) == 1' map/results.json
json 'not any(row.get("interval") for row in of["groups"])' map/results.json
succeeds report map/store.sqlite --figures none --out again
same="$(<map/results.json)"
has "$same" "$(python3 -c 'import json; print(json.dumps(json.load(open("again/results.json"))["headline"])[1:-1])')"
succeeds verify map/store.sqlite
refused "no random sample" compare map/store.sqlite map/store.sqlite
refused "no random sample" report map/store.sqlite --require solved=95% --figures none --out again
refused "no random sample" run map --robot ur5e "${coarse[@]}" --require LM.solved=50% --out required
asked="$(grep -o '`ikbench [^`]*`' <<<"${err//$'\n'/ }" | tr -d '`' | tr -s ' ')"
equal "the command for random targets" "$asked" "ikbench run --robot ur5e --require solved=50%"
succeeds ${asked#ikbench } --only LM --figures none --out random
mkdir -p "my arms"
cp "$root/tests/data/urdf/ur5e.urdf" "my arms/arm.urdf"
refused "'my arms/arm.urdf' --tip tool0 --require solved=50%" run map --robot "my arms/arm.urdf" --tip tool0 --require solved=50%
refused "step_cm = " run map --robot ur5e --set path.step_cm=0.1 --out fine

succeeds run map --robot ur5e "${coarse[@]}" --shard 1/2 --out one
succeeds run map --robot ur5e "${coarse[@]}" --shard 2/2 --out two
succeeds report one/store.sqlite --figures none --out one
has "$out" "Solves are missing"
succeeds report one/store.sqlite --figures map --out one
grep -q "not solved yet" one/figures/map.svg || fail "a map of a part that does not say so"
succeeds merge one two --out both
succeeds report both/store.sqlite --figures none --out both
has "$out" "poses that any solver reaches"
succeeds run map/store.sqlite --no-report --out rerun
succeeds verify rerun/store.sqlite
succeeds export map/store.sqlite --format targets
[ "$(wc -l <<<"$out")" -gt 20 ] || fail "too few targets"

# Several maps have their sentences side by side.
succeeds run map --sweep robot=ur5e,planar_3 --set path.step_cm=20 --only LM,DLS --out arms
[[ $out == *"On ur5e: LM"*"On planar_3: LM"* ]] || fail "$out"
for arm in ur5e planar_3; do
  [ -s arms/figures/map-$arm.svg ] || fail "no map of $arm"
done
equal "maps on the page" "$(grep -c 'id="figure-map-' arms/report.html)" 2
succeeds run map --robot planar_3 --set path.step_cm=20 --only Newton --no-report --out other
succeeds report map/store.sqlite other/store.sqlite --figures map --out stores
[ "$(ls stores/figures/map-*.svg | wc -l)" = 2 ] || fail "report of two stores: $(ls stores/figures)"

# Arms that decide the goal otherwise; a solver that cannot is left out with a sentence.
succeeds run map --robot planar_3 --set path.step_cm=20 --figures none --out planar
has "$out" "Plane z = 0"
succeeds run map --robot dobot_magician --set path.step_cm=5 --figures none --out dobot
has "$out" "positions"

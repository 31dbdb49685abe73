#!/usr/bin/env bash
# A control loop: what is late or too fast (study_results.test.cpp) is in its table, its figure and on the page, of an arm of the library and
# of a URDF file.
source "$(dirname "$0")/common.sh"
loop=(run tracking-panda --set runs=2 --set path.points=1000 --only "LM,Newton" --set loop.period_ms=0.05)
succeeds "${loop[@]}" --figures path --out loop
succeeds robot franka_panda --urdf
cp .out panda.urdf
succeeds "${loop[@]}" --set robot=panda.urdf --figures none --out of_urdf
has "$out" 'late in a row'
for joints in '0,' ''; do  # of the first joint, then of all
  sed "${joints}/velocity=\"[^\"]*\"/s//velocity=\"1e-320\"/" panda.urdf >slow.urdf
  succeeds "${loop[@]}" --set robot=slow.urdf --set runs=1 --set path.points=20 --figures none --out slow
  equal "columns that know what is too fast ($joints)" "$(grep '^|' slow/report.md | grep -c 'too fast')" $((${#joints} / 2))
  [ -z "$joints" ] || has "$(<slow/tables/loop.tex)" "joint 1"
done
first=$(sed -n 2p loop/tables/loop.csv | cut -d, -f1)
marked=$(sed -n '/^# late or too fast/,$p' loop/figures/source/path.gp | grep -c '^[-0-9]')
told=$(grep -o '"late":[a-z]*,"too_fast":[a-z]*' loop/report.html | head -n 200 | grep -c true)
[ "$marked" -gt 0 ] && [ "$told" -gt 0 ] || fail "$first: $marked points are marked in the figure, $told on the page"
refused loop.period_ms run baselines --set loop.period_ms=1 --out no

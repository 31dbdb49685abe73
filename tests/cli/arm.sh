#!/usr/bin/env bash
# An arm is one file: the example of docs/adding-an-arm.md, as it stands there.
source "$(dirname "$0")/common.sh"
page=$scripts/../../docs/adding-an-arm.md

# block KIND N: the Nth block of a kind on the page.
block() {
  awk -v kind="$1" -v n="$2" '/^```/ { if (on) { on = 0 } else if ($0 == "```" kind && ++seen == n) { on = 1 }; next } on' "$page"
}
block toml 1 >my_study.toml
block toml 2 >my_arm.toml
[ -s my_study.toml ] && [ -s my_arm.toml ] || fail "the page has no example"

# What the page shows is what is said.
succeeds list robots my_arm.toml
block console 1 | sed -n '/^my_arm: /,/^$ ikbench solve/p' | sed '$d' | sed -e :a -e '/^\n*$/{$d;N;ba' -e '}' | diff - .out ||
  fail "the page shows another list of joints"
succeeds $(block console 1 | sed -n 's/^$ ikbench solve /solve /p')
has "$out" "ok"
has "$out" "joint 3"
succeeds $(block console 1 | sed -n 's/^$ ikbench run /run /p') "${small[@]}" --out made
[ "$(solves made/store.sqlite)" = 6 ] || fail "two runs of three points are 6 solves"
"$program" export made/store.sqlite | grep -q ",my_arm," || fail "the solves do not name their arm"
grep -q 'id="motion-data"' made/report.html || fail "the page does not show the arm moving"

# The file is the one beside the study, from wherever the program is called; a copy of the arm is the same arm.
mkdir elsewhere
(cd elsewhere && "$program" run ../my_study.toml "${small[@]}" --no-report --out ../made >../.out 2>&1) || fail "$(<.out)"
has "$(<.out)" "(6 were already stored)"
cp my_arm.toml copy.toml
succeeds run my_study.toml "${small[@]}" --set robot=copy.toml --no-report --out made
has "$out" "(6 were already stored)"
sed -i 's/0.30/0.31/' my_arm.toml
succeeds run my_study.toml "${small[@]}" --no-report --out made
has_no "$out" "were already stored"

# Mistakes.
refused 'there is no file none.toml' list robots none.toml
refused 'there is no file none.toml' solve --position-cm 30 20 25 --robot none.toml
refused '--set robot: there is no file none.toml' run my_study.toml --set robot=none.toml
sed -i 's/d_m = 0.40/d_m = 400/' my_arm.toml
for command in "list robots my_arm.toml" "run my_study.toml" "solve --position-cm 30 20 25 --robot my_arm.toml"; do
  refused 'my_arm.toml:4:11: links.d_m is 400; expected a number from -100 to 100' $command
done

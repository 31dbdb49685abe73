#!/usr/bin/env bash
# compare: the gate that a solver's own repository would have, on studies that take little.
source "$(dirname "$0")/common.sh"

# make FOLDER SETTINGS...: K-ABC and MO-PSO on a short path; their errors grow where they have fewer iterations.
make() {
  local folder=$1
  shift
  succeeds run slim2023 --set runs=8 --set path.points=3 --set stop.iterations=40 --set population=10 "$@" --no-report --out "$folder"
}

# answer: the first sentences of what was said; their further lines are indented.
answer() { awk 'NR > 1 && !/^  / { exit } { sub(/^  /, " "); printf "%s", $0 }' .out; }

# answers WORDS: it begins with them.
answers() {
  [[ $(answer) == "$1"* ]] || fail "expected the answer '$1...', and it is: $(answer)"
}

# is_worse ARGUMENTS...: exit code 3, and the first line says so.
is_worse() {
  run_it compare --verbose "$@"
  [ "$code" = 3 ] || fail "compare $*: exit code $code, expected 3; it said: $out $err"
  answers "Regression beyond "
}

make base
make again
make fewer --set stop.iterations=5
base=base/store.sqlite again=again/store.sqlite fewer=fewer/store.sqlite

# The same, to the bit.
succeeds compare --verbose $base $again --metric position_error_cm --metric variation_deg --metric evaluations --metric solved
[ "$(grep -cE '  the same, bit for bit  .* equal bit for bit$' <<<"$out")" = 24 ] || fail "6 labels have 4 metrics that are the same: $out"
[ "$(answer)" = "No regression beyond 5 % (shares: 5 percentage points). Of 24 comparisons: 24 the same, bit for bit." ] || fail "the answer is: $(answer)"
quiet

# Without a tolerance nothing says what is solved, and that is said once.
unsolved="The study has no tolerance (stop.tolerance_cm), so it does not say what is solved: the status ok means that an answer is inside the joint limits, however far it is from the target."
[ "$(flat "$out" | grep -oF "$unsolved" | wc -l)" = 1 ] || fail "not said once that the study has no tolerance: $out"

# A regression, in the label and metric that has it; the other way round it is none.
is_worse $base $fewer --metric position_error_cm
has "$out" "K-ABC"
has "$out" "B differs from A in stop.iterations (40, 5)."
succeeds compare --verbose $fewer $base --metric position_error_cm
answers "No regression beyond 5 %"
is_worse $base $fewer --label K-ABC --metric position_error_cm --margin 20%
answers "Regression beyond 20 %: position_error_cm ("
succeeds compare --verbose $base $fewer --label K-ABC --metric evaluations
has "$out" "better"

# A margin in cm beside the relative one: errors that are worse, but by less than it.
is_worse $base $fewer --label K-ABC --metric position_error_cm --margin-cm 0.01
answers "Regression beyond 5 % or 0.01 cm: position_error_cm ("
succeeds compare --verbose $base $fewer --label K-ABC --metric position_error_cm --margin-cm 1000
answers "No regression beyond 5 % or 1000 cm. Of 1 comparison: 1 worse by less than 5 % or 1000 cm."
has "$out" "margin 5 % or 1000 cm; if A and B are alike"
succeeds compare --verbose $base $fewer --label K-ABC --metric evaluations --metric position_error_cm --margin-cm 1000
refused '--margin-cm: no metric is in cm' compare $base $fewer --metric evaluations --margin-cm 1
refused '--margin-cm: 2000 is not a number from 0 to 1000' compare $base $fewer --margin-cm 2000

# Another estimand of the errors than the study's first.
succeeds compare --verbose BA IK-BA --store $base --metric position_error_cm --estimand typical
has "$out" "IK-BA against BA  position_error_cm (typical)  "
has "$out" "one observation is the geometric mean of a run over its 3 points."
run_it compare --verbose BA IK-BA --store $base --metric position_error_cm --estimand mean
by_mean=$out
succeeds compare --verbose BA IK-BA --store $base --metric position_error_cm
[ "$out" = "$by_mean" ] || fail "the study's first estimand is the mean: $out"
refused '--estimand: median not in {mean,typical,reliability}' compare BA IK-BA --store $base --estimand median

# Two labels of one store.
succeeds compare --verbose BA IK-BA --store $base --metric evaluations
answers "IK-BA against BA: no worsening beyond 5 %. "
has "$out" "B: IK-BA, against A: BA, in study slim2023"
has "$out" "Independent runs, 8 of A and 8 of B: one observation is the mean of a run over its 3 points."
has "$out" "A report judges each metric over the pairs of all 6 solvers"

# Where nothing is worse and nothing undecided, the first words are what is better.
succeeds compare K-ABC BA --store $base --metric evaluations
answers "BA against K-ABC: better in evaluations, and no worsening beyond 5 %. "

# Of two labels the first words are that nothing is decided; the settings, which are many, stand below the table.
succeeds compare BA IK-BA --store $base --metric position_error_cm
answers "IK-BA against BA: undecided in position_error_cm. "
[[ $(flat "$out") == *"B: IK-BA, against A: BA"*"label "*"B differs from A in "* ]] || fail "the settings are told above the table: $out"

# Readers see first what is worse, then what is open; files for programs keep their order.
run_it compare $base $fewer -o rows.md -o rows.csv
[ "$(grep -o 'label .*' <<<"$(flat "$out")" | grep -oE 'worse by more|undecided|better by more' | head -1)" = "worse by more" ] ||
  fail "what is worse is not the first row: $out"
awk -F'|' '/<details>/ { exit } /^\| :/ { body = 1; next } body && /^\|/ { print $4 }' rows.md | grep -n 'worse by more' | tail -1 | cut -d: -f1 >worse.txt
[ "$(<worse.txt)" = "$(grep -c 'worse by more' rows.csv)" ] || fail "what is worse does not come first: $(<rows.md)"
[ "$(sed -n 2p rows.csv | cut -d, -f1)" = IK-BA ] || fail "a CSV has another order: $(<rows.csv)"

# An undecided comparison is no regression, unless --strict demands a decision.
succeeds compare --verbose $base $fewer --label IK-BA --metric variation_deg
answers "No regression beyond 5 % was found. Of 1 comparison: 1 undecided"
run_it compare --verbose $base $fewer --label IK-BA --metric variation_deg --strict
[ "$code" = 4 ] || fail "--strict, undecided: exit code $code, expected 4"
has "$(answer)" "With --strict this counts as a failure."
run_it compare --verbose $base $fewer --label IK-BA --label K-ABC --metric position_error_cm --metric variation_deg --strict
[ "$code" = 3 ] || fail "--strict, worse in one and undecided in another: exit code $code, expected 3"
has "$out" "undecided"
has_no "$(answer)" "With --strict"
succeeds compare --verbose $base $again --label IK-BA --metric solved --strict
# Times of two sessions are not comparable; with the default metrics that is no failure, where they are asked for it is.
succeeds compare --verbose $base $again --label IK-BA --strict
has "$(answer)" "1 not compared: separate sessions"
run_it compare --verbose $base $again --label IK-BA --metric seconds --strict
[ "$code" = 4 ] || fail "--strict, times of two sessions: exit code $code, expected 4"
make single --set runs=1
succeeds compare --verbose single/store.sqlite single/store.sqlite --label BA --metric evaluations
succeeds compare --verbose $base single/store.sqlite --label BA --metric position_error_cm
has "$out" "fewer than"

# Random targets: run by run the same.
for folder in drawn drawn_again; do
  succeeds run slim2023-time --set runs=6 --set path.points=2 --set stop.iterations=10 --no-report --out $folder
done
succeeds compare --verbose drawn/store.sqlite drawn_again/store.sqlite --metric evaluations
has "$out" "12 pairs of targets: one observation is the only solve of a target"
for folder in chained chained_again; do
  succeeds run slim2023-time --set runs=6 --set path.points=2 --set start=previous --set stop.iterations=10 --no-report --out $folder
done
succeeds compare --verbose chained/store.sqlite chained_again/store.sqlite --metric evaluations
has "$out" "6 pairs of runs: one observation is the mean of a run over its 2 points"
refused 'they have different start configurations' compare drawn/store.sqlite chained/store.sqlite

# A path whose targets are each solved from the initial configuration: target by target.
make each --set start=initial --set path.points=8
make each_fewer --set start=initial --set path.points=8 --set stop.iterations=5
is_worse each/store.sqlite each_fewer/store.sqlite --label K-ABC --metric position_error_cm --significance 0.2
has "$out" "8 pairs of targets: one observation is the mean of a target over 8 runs"
succeeds run slim2023-time --set runs=6 --set path.points=2 --set stop.iterations=10 --set seed=2 --no-report --out elsewhere
refused 'they have different targets (run 1, point 1: ' compare drawn/store.sqlite elsewhere/store.sqlite
make longer --set path.points=4
refused 'they have different targets (3 and 4 points per run)' compare $base longer/store.sqlite
make farther --set path.radius_cm=21
refused 'they have different targets (run 1, point 1: ' compare $base farther/store.sqlite
make turned --set initial_deg=[1,0,0,0,0,0,0] --set runs=2
refused 'they have different start configurations' compare $base turned/store.sqlite

# Files for other programs.
for type in md csv json; do
  succeeds compare --verbose $base $fewer --label MO-PSO --metric evaluations --metric solved -o new/comparison.$type
  [ -s new/comparison.$type ] || fail "no comparison.$type"
done
has "$(<new/comparison.md)" '| MO-PSO | evaluations | better by more than 5 % |'
has "$(head -1 new/comparison.csv)" 'label,metric,B_is,n_A,n_B,mean_A,mean_B,B_by_A,low,high,p,level'
[ "$(wc -l <new/comparison.csv)" = 3 ] || fail "comparison.csv has $(wc -l <new/comparison.csv) lines"
if command -v python3 >/dev/null; then
  python3 -c '
import json
told = json.load(open("new/comparison.json"))
assert told["margin"] == 0.05 and told["verdict"].startswith("No regression beyond 5 % ("), told
assert [row["metric"] for row in told["rows"]] == ["evaluations", "solved"], told
assert told["rows"][0]["B_is"] == "better by more than 5 %" and told["rows"][0]["p"] < told["rows"][0]["level"], told' || fail "the JSON"
fi
is_worse $base $fewer --label K-ABC --metric position_error_cm -o new/regression.csv
[ -s new/regression.csv ] || fail "a regression is not written"

# The margin is that of A's study, where none is given.
make wide --set analysis.margin_percent=30
succeeds compare --verbose wide/store.sqlite $base --label BA --metric evaluations
has "$out" "margin 30 %"
make wide --set analysis.margin_percent=0 --set analysis.margin_cm=500
succeeds compare --verbose wide/store.sqlite $fewer --label K-ABC --metric position_error_cm
has "$out" "margin 500 cm"
answers "No regression beyond 500 cm"

# All readers of a study's [analysis] can work with its limits.
for edge in "analysis.margin_percent=99 analysis.significance=0.2" \
  "analysis.margin_percent=0 analysis.significance=0.0001"; do
  read -r margin significance <<<"$edge"
  make edge --set "$margin" --set "$significance"
  succeeds compare --verbose edge/store.sqlite $fewer --label K-ABC --metric variation_deg
  has "$out" "some difference is found with a probability of at most $(awk "BEGIN { print 100 * ${significance#*=} }") %"
  "$program" export edge/store.sqlite >edge.csv
  succeeds stats edge.csv --value position_error_cm --run run --margin "${margin#*=}%" \
    --significance "${significance#*=}"
  rm -r edge
done

# Names are text.
printf 'name = "a <i>b</i>"\nruns = 2\npopulation = 6\n[stop]\niterations = 5\n[path]\npoints = 2\n[[solvers]]\nsolver = "bat"\nlabel = "x | <b> 関節"\n' >hostile.toml
succeeds run hostile.toml --no-report --out hostile
succeeds compare --verbose hostile/store.sqlite hostile/store.sqlite --metric evaluations -o new/hostile.md
has "$out" 'x | <b> 関節'
has_no "$(sed -E '/^<\/?(details|summary)>/d' new/hostile.md)" '<'
[ "$(sed '/<details>/,$d' new/hostile.md | grep -c '^|')" = 3 ] || fail "the table has other rows: $(<new/hostile.md)"

# Mistakes.
refused "store 'IK-BA' does not exist; to compare two labels of one store, add --store FILE" compare IK-BA BA
refused 'B: unknown label "IKBA"; did you mean "IK-BA"?' compare BA IKBA --store $base
refused 'A: unknown label "none" (there are: IK-BA, BA' compare $base $again --label none
refused 'A and B are both the label BA' compare BA BA --store $base
refused '--label needs two stores' compare BA DE --store $base --label PSO
refused 'no label in common (A: IK-BA, BA' compare $base drawn/store.sqlite
refused 'unknown metric "speed" (there are: position_error_cm, variation_deg, seconds, evaluations, solved, ' \
  compare $base $again --metric speed
refused '--margin: 5 is not a share from 0 % to 99 %; expected for example 5% or 0.05' compare $base $again --margin 5
refused '--margin: -1% is not a share' compare $base $again --margin=-1%
refused '--margin: nan is not a share' compare $base $again --margin nan
refused '--significance: 0.5 is not a number from 0.0001 to 0.2' compare $base $again --significance 0.5
refused 'expected a file name that ends in .md, .csv or .json' compare $base $again -o table.tex
cp $base base.json
refused '-o base.json is one of the stores' compare base.json $again -o base.json
refused "no study 'other'" compare $base $again --study other
refused 'B' compare $base
refused '\x1b[31m' compare $'\e[31mred' $base
quiet

# For machines: the outcome as JSON; two studies of one store.
run_it compare $base $fewer --label K-ABC --metric position_error_cm -o verdict.json -o verdict.md
[ "$code" = 3 ] || fail "exit code $code, expected 3"
grep -q '"outcome": "worse"' verdict.json && grep -q '"exit_code": 3' verdict.json || fail "no outcome: $(<verdict.json)"
[[ "$(head -n 1 verdict.md)" == "Regression beyond 5 %: position_error_cm (from "* ]] || fail "verdict.md begins otherwise: $(<verdict.md)"
[ "$(grep -m 1 '^|' verdict.md)" = "| label | metric | B is | mean A | mean B | B by A | interval | p |" ] || fail "the short table: $(<verdict.md)"
refused "expected a file name that ends in .md, .csv or .json" compare $base $fewer -o verdict.txt
refused "--other-study needs two stores" compare BA IK-BA --store $base --other-study slim2023

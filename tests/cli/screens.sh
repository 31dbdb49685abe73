#!/usr/bin/env bash
# What a command says at its end fits on a screen of 30 lines of 100 columns. --verbose says all, --json says it as data,
# --help explains. Colours and progress are for a terminal alone.
source "$(dirname "$0")/common.sh"
long="a solver whose name is a good deal longer than what fits into the column of a table on a terminal"
entries=()
for solver in newton particle_swarm levenberg_marquardt random_search bat ik_bat differential_evolution k_artificial_bee_colony; do
  entries+=('[[solvers]]' "solver = \"$solver\"")
done
study mine "${entries[@]}" '[[solvers]]' "label = \"$long\"" 'solver = "bat"'
sed -i 's/^runs = 2/runs = 8/' mine.toml
succeeds run mine.toml --no-report --out mine
quiet
has_no "$err" "solves,"
store=mine/store.sqlite
cp $store other.sqlite
RANDOM=1
printf 'solver,run,error,time,cost\n' >values.csv
for solver in A B C D E F G "$long"; do
  for run in 1 2 3 4 5 6; do printf '%s,%d,%d.%d,%d,%d\n' "$solver" $run $((RANDOM % 9)) $run $((RANDOM % 50 + 1)) $run; done
done >>values.csv
small_multiverse=(multiverse slim2023 --small --set runs=2 --set path.points=2 --set stop.iterations=3 --no-figures)

fits "" report $store --no-figures --out reported
[ "$(tail -n 1 .out)" = "Report: reported/report.html" ] || fail "the last line is: $(tail -n 1 .out)"
fits "" compare $store other.sqlite
fits "" compare newton "$long" --store $store
fits "" stats values.csv --value error --value time --value cost --out stats
fits "" "${small_multiverse[@]}" --out small
fits "" merge merged $store
fits "" robot ur5e
fits "" run mine.toml --shard 1/2 --out mine/shards/1-of-2
fits "" run mine.toml --sweep particle_swarm.population=5,10,20 --no-figures --out swept
for kind in solvers robots studies paths columns metrics instruction-sets; do # a pipe gets all, in lines that fit
  succeeds list $kind
  [ "$(wc -L <.out)" -le 100 ] || fail "list $kind: $(wc -L <.out) columns"
done
succeeds report $store --verbose --no-figures --out reported
has "$out" "random_search"
[ "$(wc -l <.out)" -gt 30 ] || fail "--verbose says no more"

# Every command explains itself, with an example.
succeeds --help
all=$out
for command in reproduce run report compare stats multiverse list robot check-solver export merge; do
  has "$all" "  $command "
  succeeds "$command" --help
  has "$out" "Examples:"
  has "$out" "ikbench $command"
  [ -z "$err" ] || fail "$command --help wrote to the standard error: $err"
  quiet
done
succeeds --version
[[ $out =~ ^ikbench\ [0-9]+\.[0-9]+\.[0-9]+\ \(.+\)$ ]] || fail "--version says: $out"
version=${out#ikbench } version=${version%% *}
grep -qx "version: $version" "$scripts/../../CITATION.cff" || fail "CITATION.cff is not of $version"
run_it
[ "$code" = 1 ] || fail "without a command: exit code $code"

command -v python3 >/dev/null || exit 77
as_json 'of["study"] == "mine" and len(of["pairs"]) == 45 and of["pairs"][0]["relation"] and of["results"][0]["algorithm"] == "DLS"' \
  report $store --no-figures --out reported
as_json 'of["report"] == "mine/report.html" and of["warnings"] is not None' run mine.toml --no-figures --out mine
as_json 'all(row["B_is"] for row in of["rows"])' compare $store other.sqlite
as_json 'len(of["findings"]) == 2 * 28 and of["findings"][28]["metric"] == "time"' \
  stats values.csv --value error --value time --out stats
as_json 'of[0]["holds_percent"] is not None' "${small_multiverse[@]}" --out small
as_json 'of["added"] == 0 and of["missing"] == {}' merge merged $store
as_json 'of["joints"] == 6 and len(of["links"]) == 6 and of["tool_at"]["position_m"]' robot ur5e
as_json 'any(row["name"] == "ur5e" and row["joints"] == 6 for row in of)' list robots
as_json 'of["options"][0]["option"]' list solvers ik_bat
as_json 'of["runs"] == 20' list studies slim2023
run_it check-solver --json -- cat # which fails, with 1
python3 -c "import json; of = json.load(open('.out')); assert of[0]['check'] and of[0]['passed'] is False" || fail "check-solver --json: $out"

script -qec true /dev/null >/dev/null 2>&1 </dev/null || exit 77 # no `script`, or no terminal to be had
# on_terminal SETTINGS ARGUMENTS...: what a terminal of 100 columns sees in the end.
on_terminal() {
  local settings=$1
  shift
  TERM=xterm script -qec "stty cols 100; $settings '$program' $*" /dev/null </dev/null >shown
}
colours=$'\e\\[3[123]m'
on_terminal "" compare $store other.sqlite
grep -q "$colours" shown || fail "no colour on a terminal: $(<shown)"
for settings in NO_COLOR=1 TERM=dumb; do
  on_terminal $settings compare $store other.sqlite
  ! grep -q "$colours" shown || fail "colours with $settings"
done
on_terminal "" compare $store other.sqlite "| cat"
! grep -q "$colours" shown || fail "colours in a pipe"

on_terminal "" run slim2023 --set runs=4 --set path.points=5 --set stop.iterations=1000 --no-report --out shown_run
has "$(<shown)" "/120 solves, " # 6 solvers x 4 runs x 5 points
[[ $(<shown) =~ \[[#]+[.]*\] ]] || fail "no bar in: $(<shown)"
# The last thing done with the bar is to wipe it: the result stands alone on its line.
line=$(tr '\r' '\n' <shown | grep '120 solves in')
[ "${line#$'\e[K'}" = "slim2023: 120 solves in shown_run/store.sqlite" ] || fail "the result's line is: $line"
exit 0

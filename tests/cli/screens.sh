#!/usr/bin/env bash
# What a command says at its end fits on a screen of 30 lines of 100 columns and begins with the answer. --verbose says
# all, --json says it as data. Colours are for a terminal alone.
source "$(dirname "$0")/common.sh"
long="a solver whose name is a good deal longer than what fits into the column of a table on a terminal"
entries=()
for solver in newton particle_swarm levenberg_marquardt random_search bat ik_bat differential_evolution k_artificial_bee_colony; do
  entries+=('[[solvers]]' "solver = \"$solver\"")
done
study mine "${entries[@]}" '[[solvers]]' "label = \"$long\"" 'solver = "bat"'
sed -i 's/^runs = 2/runs = 8/' mine.toml
succeeds run mine.toml --no-report --out mine
store=mine/store.sqlite
cp $store other.sqlite

fits "Smallest mean error" report $store --no-figures --out reported
[ "$(tail -n 1 .out)" = "Report: reported/report.html" ] || fail "the last line is: $(tail -n 1 .out)"
[[ $(flat "$out") =~ Not\ shown:\ .*\ --verbose\ shows\ all,\ and\ reported/report.md\ has\ it\. ]] ||
  fail "it does not say what is left out, and where that is: $out"
has_no "$out" "random_search  iterations"
fits "No regression beyond 5 %" compare $store other.sqlite
has "$out" "Equal bit for bit: evaluations, position_error_cm, "
fits "" compare newton "$long" --store $store
RANDOM=1
printf 'solver,run,error,time,cost\n' >values.csv
for solver in A B C D E F G "$long"; do
  for run in 1 2 3 4 5 6; do printf '%s,%d,%d.%d,%d,%d\n' "$solver" $run $((RANDOM % 9)) $run $((RANDOM % 50 + 1)) $run; done
done >>values.csv
fits "Statistics: error" stats values.csv --value error --no-figures --out stats
fits "Statistics: error" stats values.csv --value error --value time --value cost --no-figures --out stats
[ "$(grep -c '^Statistics: ' .out)" = 3 ] || fail "not an answer for each of three quantities: $out"
has "$(sed -n '/^Observations: error$/,/^Observations: time$/p' .out)" "than what fits into the column" # wrapped, not cut
has_no "$out" "than what fits into…"
fits "" audit slim2023
[[ $out =~ ^[0-9]+\ checks: ]] || fail "the count is not first: $out"
[[ $(sed -n 2,3p .out) =~ ^verdict\ .*\ printed\ .*\ follows.contradiction\  ]] || fail "not the contradictions first, with what follows: $out"
[ "$(grep -c '^contradiction ' .out)" = 4 ] || fail "not all contradictions: $out"
fits "737280 interpretations of 19 dimensions" multiverse slim2023 --list
fits "Of 4 claims, " multiverse slim2023 --small --set runs=2 --set path.points=2 --set stop.iterations=3 --no-figures --out small
[[ $(flat "$out") =~ ^Of\ 4\ claims,\ ([0-4])\ .*,\ ([0-4])\ fails?\ in\ most,\ ([0-4])\ (is|are)\ undecided\ in\ most(,\ and\ ([0-4])\ )?.*\. ]] ||
  fail "another verdict of a multiverse: $out"
[ $((BASH_REMATCH[1] + BASH_REMATCH[2] + BASH_REMATCH[3] + ${BASH_REMATCH[6]:-0})) = 4 ] || fail "not all claims are counted: $out"
fits "" multiverse slim2023 --dimensions bounds --one-at-a-time --set runs=2 --set path.points=2 --set stop.iterations=3 --no-figures --out one
fits "merged/store.sqlite" merge merged $store
fits "solver ik_bat" solve --solver ik_bat --position-cm 60 20 10
fits "ur5e: " robot ur5e
fits "mine" run mine.toml --shard 1/2 --out mine/shards/1-of-2
fits "" status mine
fits "" fingerprint $store
for kind in solvers robots studies paths columns metrics tests pieces instruction-sets; do # a pipe gets all, in lines that fit
  succeeds list $kind
  [ "$(wc -L <.out)" -le 100 ] || fail "list $kind: $(wc -L <.out) columns"
done

# What a command was given for is on its screen, although the warnings and a long table are there too.
fits "Smallest mean error" run mine.toml --sweep particle_swarm.population=5,10,20 --no-figures --out swept
[[ $(tr -s '\n ' ' ' <.out) =~ Best\ settings\ by\ [^:]*:\ particle_swarm\ population=[0-9]+\ \([^\)]*,\ best\ of\ 3\)\. ]] || fail "no best of the sweep: $out"
has "$out" "tables/sweep.md has all"
has "$out" "swept/store.sqlite"
fits "" run mine.toml --sweep particle_swarm.population=5,10,20 --set stop.tolerance_cm=1000 --no-figures --out tied
has "$(tr -s '\n ' ' ' <.out)" ": particle_swarm (100 %, all 3)."
fits "Smallest mean error" run mine.toml --perturb 1 --no-figures --out perturbed
has "$out" "Last bits of the targets, changed 1 times."
succeeds tune mine.toml --solver particle_swarm --sweep population=5,10,20 --budget 400 --no-figures --out tuned
sed -n '/^Smallest mean error/,$p' .out >screen
[ "$(cat screen .err | wc -l)" -le 30 ] && [ "$(cat .out .err | wc -L)" -le 100 ] || fail "tune: not one screen: $out $err"
has "$(<screen)" "Chosen from 3 candidates, "
printf 'studies = ["mine.toml"]\nseeds = [1, 2, 3]\n' >seeds.toml
fits "Over 3 seeds together, " run seeds.toml --no-figures --out seeds
[[ $(grep '^solver  ' <<<"$out") =~ ^solver\ +all:\ mean ]] || fail "not first what holds over all seeds: $out"
fits "Smallest mean error" run mine.toml --set analysis.significance=0.01 --no-figures --out perturbed # with warnings before and after
[ "$(grep -c '^warning: ' .err)" -ge 2 ] || fail "too few warnings: $err"

# Two versions, of which one is worse; a program that crashes; and where nothing can be compared.
succeeds run mine.toml --set stop.iterations=2 --no-report --out worse
fits "Regression beyond 5 %" compare $store worse/store.sqlite
has "$out" "B differs from A in stop.iterations (8, 2)."
has "$out" "Not compared: seconds (typical)."
fits "" trend $store worse/store.sqlite
has "$out" "worse differs from mine in stop.iterations (8, 2)."
has_no "$out" "B differs"
fits "" compare bat newton --store $store
[[ $(flat "$out") == *"label "*"B differs from A in "*"source of the solver ("* ]] || fail "digests above the table: $out"

# All of it, in lines that break between words; and as data.
succeeds report $store --verbose --no-figures --out reported
has_no "$out" "Not shown"
has "$out" "random_search"
[ "$(wc -l <.out)" -gt 30 ] || fail "--verbose says no more"
command -v python3 >/dev/null || exit 77
as_json 'of["study"] == "mine" and len(of["pairs"]) == 45 and of["pairs"][0]["relation"] and of["results"][0]["algorithm"] == "DLS"' \
  report $store --no-figures --out reported
as_json 'of["report"] == "mine/report.html" and of["is_damaged"] is False and of["warnings"] is not None' run mine.toml --no-figures --out mine
as_json 'all(row["B_is"] for row in of["rows"])' compare $store other.sqlite
as_json 'of["quantities"][1]["quantity"] == "time" and len(of["quantities"][1]["pairs"]) == 28' \
  stats values.csv --value error --value time --no-figures --out stats
as_json 'of[0]["verdict"] and of[0]["why"]' audit slim2023
as_json 'of[0]["holds_percent"] is not None' multiverse slim2023 --small --set runs=2 --set path.points=2 --set stop.iterations=3 --no-figures --out small
as_json 'of["added"] == 0 and of["missing"] == {}' merge merged $store
as_json 'of["status"] and len(of["answer_rad"]) == 7 and of["position_error_cm"] >= 0' solve --solver ik_bat --position-cm 60 20 10
as_json 'of["joints"] == 6 and len(of["links"]) == 6 and of["tool_at"]["position_m"]' robot ur5e
as_json 'of["divisions"][0]["done"] == [1] and of["divisions"][0]["not begun"] == [2]' status mine
as_json 'of[0]["study"] == "mine" and len(of[0]["fingerprint"]) == 32' fingerprint $store
as_json 'any(row["name"] == "ur5e" and row["joints"] == 6 for row in of)' list robots
as_json 'of["options"][0]["option"]' list solvers ik_bat
as_json 'of["runs"] == 20' list studies slim2023
run_it check-solver --json -- cat # which fails, with 1
python3 -c "import json; of = json.load(open('.out')); assert of[0]['check'] and of[0]['passed'] is False" || fail "check-solver --json: $out"

# help COMMAND is COMMAND --help.
succeeds help stats
by_word=$out
succeeds stats --help
[ "$out" = "$by_word" ] || fail "help stats is not stats --help"
succeeds help
has "$out" "ikbench help COMMAND"
refused 'unknown command "statz"' help statz

script -qec true /dev/null >/dev/null 2>&1 </dev/null || exit 77 # no `script`, or no terminal to be had
# on_terminal SETTINGS ARGUMENTS...: what a terminal of 100 columns sees in the end.
on_terminal() {
  local settings=$1
  shift
  TERM=xterm script -qec "stty cols 100; $settings '$program' $*" /dev/null </dev/null | tr -d '\r' >shown
}
colours=$'\e\\[3[123]m'
on_terminal "" audit slim2023
grep -q "$colours" shown || fail "no colour on a terminal: $(<shown)"
succeeds audit slim2023
[ "$(sed $'s/\e\\[[0-9]*[mK]//g' shown)" = "$out" ] || fail "a terminal sees another text: $(<shown)"
for settings in NO_COLOR=1 TERM=dumb; do
  on_terminal $settings audit slim2023
  ! grep -q "$colours" shown || fail "colours with $settings"
done
on_terminal "" audit slim2023 "| cat"
! grep -q "$colours" shown || fail "colours in a pipe"
on_terminal "stty cols 60;" audit slim2023
[ "$(wc -L <shown)" -le 70 ] || fail "a terminal of 60 columns gets $(wc -L <shown)" # with the colours
exit 0

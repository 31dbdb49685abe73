#!/usr/bin/env bash
# Several studies in one store, one table and one test.
source "$(dirname "$0")/common.sh"

# study_of NAME LINE...: two solvers and a third, four runs.
study_of() {
  local name=$1
  shift
  printf 'name = "%s"\nsearch = "all_joints"\nruns = 4\nrepeats = 1\n%s\n' "$name" "$(printf '%s\n' "$@")" >"$name.toml"
  printf '[stop]\niterations = 20\nevaluations = 400\ntolerance_cm = 0.1\n' >>"$name.toml"
  printf '[[solvers]]\nsolver = "%s"\n' damped_least_squares random_search ik_bat >>"$name.toml"
}
study_of helix 'path = { kind = "helix", points = 3 }'
study_of arm 'robot = "ur5e"' 'start = "middle"' 'path = { kind = "random", points = 3 }'
sed -i 's/ik_bat/particle_swarm/' arm.toml # the two studies share two solvers
echo 'studies = ["helix.toml", "arm.toml"]' >both.toml

# Runs are the unit, because those of the helix share no problem: a value is the mean over both studies.
succeeds run both.toml --no-figures
has "$out" "2 studies: 72 solves in out/both/store.sqlite"
[[ $(grep '^solver ' <<<"$out") =~ ^solver\ +all:\ solved ]] || fail "not first what holds over all: $out"
has "$(<out/both/report.md)" "Over 2 studies together"
has "$(<out/both/report.md)" "Left out, because not every study has them: ik_bat, particle_swarm."
# By hand: the share of both is the mean of the shares of each.
python3 - out/both/tables/together.csv <<'E2' || fail "the table is not what its studies say: $(<out/both/tables/together.csv)"
import csv, sys
rows = list(csv.DictReader(open(sys.argv[1])))
assert [row["solver"] for row in rows] == ["damped_least_squares", "random_search", "ik_bat", "particle_swarm"]
for row in rows[:2]:
    assert abs((float(row["helix: solved [%]"]) + float(row["arm: solved [%]"])) / 2 - float(row["all: solved [%]"])) < 1e-9
assert rows[2]["arm: solved [%]"] == "" and rows[2]["all: solved [%]"] == "" and rows[2]["helix: solved [%]"] != ""
E2
succeeds run both.toml --no-figures
has "$out" "(72 were already stored)"

# Each study has its tables and figures, and all say whose they are.
has "$(<out/both/report.md)" "helix: Results"
has "$(<out/both/report.md)" "arm: Results"
has "$(<out/both/report.md)" "## helix: Statistics: position error"
has "$(<out/both/report.md)" "## All studies: Statistics: "
[ -z "$(grep '^## ' out/both/report.md | sort | uniq -d)" ] || fail "two sections have one heading: $(grep '^## ' out/both/report.md)"
grep -q particle_swarm out/both/tables/arm-results.csv || fail "the results of the second study lack its solvers"
! grep -q particle_swarm out/both/tables/results.csv || fail "the results of the first study have solvers of the second"
[ -s out/both/figures/arm-overview.gp ] || fail "no figure of the second study: $(ls out/both/figures)"
has "$(<out/both/report.md)" "arm: What was reached"

# The store does not know which studies belong together; the file does.
succeeds report out/both/store.sqlite --no-figures --out again
has "$out" "The store also has arm, which this report is not about"
succeeds report out/both/store.sqlite --no-figures --out again --json
has "$(tr -d ' \n' <<<"$out")" '"further_studies":["arm"]'
succeeds report out/both/store.sqlite --study arm --no-figures --out again
has_no "$out" "The store also has"
succeeds report out/both/store.sqlite --study both.toml --no-figures --out again
has_no "$out" "The store also has"
cmp again/tables/together.csv out/both/tables/together.csv || fail "a collection has another table when it is reported again"
has "$(<again/report.md)" "arm: Results"
refused '--unit is point' report out/both/store.sqlite --study both.toml --unit point --force

# Commands that read a study.
succeeds list studies both.toml
has "$out" "helix"
has "$out" "arm"

# Where all studies have problems that the solvers share, these are the blocks: 12 of each.
study_of second 'robot = "franka_panda"' 'start = "middle"' 'path = { kind = "random", points = 2 }'
sed -i 's/ik_bat/particle_swarm/' second.toml
printf 'name = "arms of mine"\ntitle = "Two arms"\nstudies = ["arm.toml", "second.toml"]\n' >arms.toml
succeeds run arms.toml --no-figures --out arms
has "$(<arms/report.md)" "The targets of all studies count alike: 12 of arm, 8 of second."
has "$(<arms/report.md)" "Two arms"

# The CSV of solves has those of all studies.
[ "$(cut -d, -f1 out/both/solves.csv | sort | uniq -c | tr -s ' ')" = " 36 arm
 36 helix
 1 study" ] || fail "the solves of both studies: $(cut -d, -f1 out/both/solves.csv | sort | uniq -c)"
cmp again/solves.csv out/both/solves.csv || fail "a collection has other solves when it is reported again"

# One study with several seeds: each seed is a block, whose value is the mean over its runs.
printf 'studies = ["helix.toml"]\nseeds = [1, 2, 3, 4, 5, 6]\n' >seeds.toml
succeeds run seeds.toml --no-figures
has "$out" "6 studies: 216 solves in out/seeds/store.sqlite"
has "$(<out/seeds/report.md)" "Over 6 seeds together"
python3 - out/seeds <<'E2' || fail "a block is not the mean of its seed: $(<out/seeds/tables/together.csv)"
import csv, json, math, sys
rows = list(csv.DictReader(open(sys.argv[1] + "/tables/together.csv")))
judged = next(one for one in json.load(open(sys.argv[1] + "/statistics.json")) if one["quantity"].startswith("share of"))
assert judged["blocks"] == 6 and judged["block"].startswith("a seed"), (judged["blocks"], judged["block"])
for row in rows:
    of_seeds = [float(row[f"helix-seed-{seed}: solved [%]"]) for seed in range(1, 7)]
    group = next(group for group in judged["groups"] if group["name"] == row["solver"])
    assert group["n"] == 6 and math.isclose(group["mean"]["value"], sum(of_seeds) / 600, abs_tol=1e-12), row
E2
succeeds run helix.toml --set seed=6 --no-report --out alone
[ "$(numbers out/seeds/store.sqlite helix-seed-6 | cut -d, -f 3,5-)" = "$(numbers alone/store.sqlite | cut -d, -f 3,5-)" ] ||
  fail "a seed of the collection has other solves than the study with that seed"
succeeds compare ik_bat random_search --store out/seeds/store.sqlite --study helix-seed-2
printf 'studies = ["helix.toml"]\nseeds = [1, 2, 3, 4, 5]\n' >five.toml
succeeds run five.toml --no-figures --set stop.tolerance_cm=8
has "$(<out/five/report.md)" "7 seeds that all favour one group"
for seeds in '[1]' '[1, 1]' '[1, "2"]' '[1, -2]' '[1, 2.5]' 1; do
  printf 'studies = ["helix.toml"]\nseeds = %s\n' "$seeds" >wrong.toml
  refused 'expected a list of 2 to 50 whole numbers, each once' run wrong.toml
done
printf 'studies = ["helix.toml", "arm.toml"]\nseeds = [1, 2]\n' >wrong.toml
refused 'wrong.toml:1:11: the list has 2; expected one study with seeds' run wrong.toml

# Studies that one test cannot judge, and files that are none.
cp arm.toml other.toml && sed -i 's/"arm"/"other"/' other.toml && printf '[analysis]\nsignificance = 0.01\n' >>other.toml
echo 'studies = ["helix.toml", "other.toml"]' >plans.toml
refused 'helix and other cannot be judged together: their plans differ: significance is 0.05 and 0.01 in [analysis]' run plans.toml
sed -i 's/^runs = 4/runs = 5/; /analysis/,$d' other.toml
refused 'they have 4 and 5 runs' run plans.toml
succeeds run plans.toml --set runs=2 --no-report
echo 'studies = ["arm.toml", "arm.toml"]' >same.toml
refused 'two studies have the name arm' run same.toml
sed 's/"arm"/"again"/; s/^runs = 4/runs = 4 # the same solves/' arm.toml >again.toml
echo 'studies = ["arm.toml", "again.toml"]' >twice.toml
refused 'arm.toml and again.toml ask for the same solves; a collection judges each study as a sample of its own' run twice.toml
echo 'studies = ["arm.toml", "itself.toml"]' >itself.toml
refused 'itself.toml is a collection itself; expected studies' run itself.toml
echo 'studies = ["arm.toml", "none.toml"]' >missing.toml
refused 'no such file: none.toml' run missing.toml
echo 'studies = ["arm.toml"]' >single.toml
refused 'single.toml:1:11: the list has 1; expected 2 to 50 studies' run single.toml
printf 'studies = ["arm.toml"%s]\n' "$(printf ', "%s.toml"' {1..50})" >many.toml
refused 'the list has 51; expected 2 to 50 studies' run many.toml
printf 'studies = ["arm.toml", "second.toml"]\nstudy = 1\n' >unknown.toml
refused 'study' run unknown.toml
refused 'takes no --shard' run both.toml --shard 1/2
refused 'takes no --perturb' run both.toml --perturb 1
mkdir deeper && echo 'studies = ["../helix.toml", "../arm.toml"]' >deeper/beside.toml # beside the file, as an arm is
succeeds run deeper/beside.toml --no-figures --out both
[ "$(ls -A deeper)" = beside.toml ] || fail "something was written beside the collection"

#!/usr/bin/env bash
# Every study of the paper: one command, one store, one report.
source "$(dirname "$0")/common.sh"

succeeds reproduce --runs 2 --jobs 2 --readings 1 --no-figures --out paper
quiet
has "$out" "slim2023: 240 solves"        # 6 solvers x 2 runs x 20 points
has "$out" "slim2023-context: 80 solves" # 2 solvers
has "$out" "slim2023-all-joints: 240 solves"
has "$out" "slim2023-limits: 240 solves"
has "$out" "slim2023-bounds: 240 solves"
has "$out" "slim2023-elongation: 80 solves" # without Eq. 13, and without the pull of Eq. 14
has "$out" "slim2023-time: 80 solves"    # 4 sizes of the population x 20 targets
has "$out" "slim2023-dobot: 20 solves"
# Each estimand has its own winner, in the first words of the summary.
for words in "Smallest mean error (large errors dominate): no solver is tested: IK-BA" "Smallest typical error (geometric mean): no solver is tested: PSO" "Most often within 0.01 cm: IK-BA"; do
  has "$(grep -A 2 '>Summary<' paper/report.html)" "$words"
done
for table in table-3 table-3-readings claims-readings table-4 table-5 table-6 table-7 table-8 limits multiverse baselines; do
  [ -s "paper/tables/$table.md" ] || fail "there is no table $table"
  has "$(<paper/report.html)" "id=\"$table\""
done
# The last screen: the verdict, a line a claim with its verdict here and as printed and our number, the fingerprints and,
# as the last line, the report.
sed -n '/^Of 18 claims, /,$p' .out >screen
[ "$(wc -l <screen)" -le 30 ] && [ "$(wc -L <screen)" -le 100 ] || fail "not one screen: $(<screen)"
[ "$(grep -c '^Of \|^here ' screen)" = 2 ] || fail "no verdict and no head: $(<screen)"
grep -qE '^(holds|in part|undecided|fails|depends) +holds +[^ ].* +IK-BA is more accurate than BA$' screen || fail "no line for a claim: $(<screen)"
grep -q '^Fingerprints: ' screen || fail "no fingerprints: $(<screen)"
[ "$(tail -n 1 .out)" = "Report: paper/report.html" ] || fail "the last line is: $(tail -n 1 .out)"
# All claims of the paper and our own questions have a verdict; Eq. 13 changes no bit.
has "$(<paper/report.md)" "Of 18 claims, "
has "$(<paper/report.md)" "Without Eq. 13 (f_max = 0) all 40 answers are the same to the last bit"
has "$(<paper/report.md)" "## Our own questions"
has "$(<paper/report.md)" "If all solvers are clamped, IK-BA is the most accurate"
# The printed digits stand beside ours, and the tables are told before the rest is solved.
has "$(<paper/tables/table-3.md)" "(printed 1.7824e-4"
[[ ${out%%slim2023-context: *} == *"Table 3: "* ]] || fail "Table 3 is not told as soon as it is there"
has_no "$out" "Table 7: "
for label in IK-BA BA DE PSO K-ABC MO-PSO; do
  has "$(<paper/tables/table-3.md)" "$label"
done
# A report from the store alone has no interpretations, so it does not replace theirs.
cp paper/report.md before.md
refused "choose another folder (--out), or run ikbench reproduce again" report paper/store.sqlite --no-figures
refused "choose another folder (--out), or run ikbench reproduce again" run slim2023 --no-figures --out paper
cmp paper/report.md before.md || fail "a report that is refused changed the one that is there"
succeeds report paper/store.sqlite --study slim2023-context --no-figures --out context
has "$(<context/tables/results.md)" "DLS"

# It is the built-in study, and goes on from what is there.
succeeds run slim2023 --set runs=2 --no-report --out paper
has "$out" "(240 were already stored)"

# --quick: no interpretations, and the same numbers of the paper's studies.
succeeds reproduce --runs 2 --jobs 2 --quick --no-figures --out quick
[ ! -e quick/tables/multiverse.md ] || fail "--quick solved more than the studies"
[ "$(numbers quick/store.sqlite)" = "$(numbers paper/store.sqlite)" ] || fail "--quick gives other numbers"

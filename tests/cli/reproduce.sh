#!/usr/bin/env bash
# The papers' studies give the reference numbers, bit by bit, with every instruction set of this machine and other numbers
# of threads; their claims have their verdicts.
source "$(dirname "$0")/common.sh"
references=$root/results/reference.inc
studies=(slim2023 slim2023-50 slim2023-context slim2023-all-joints slim2023-limits slim2023-bounds slim2023-elongation slim2023-time slim2023-dobot)
fingerprint() { "$program" export "$1" --study "$2" --format fingerprint | cut -d' ' -f1; }
reference() { grep "\"$1\"" "$references" | cut -d'"' -f4; }

# verdicts FOLDER: the verdicts of its claims and questions.
verdicts() {
  for name in claims questions; do
    sqlite3 -separator ' | ' :memory: ".import --csv $1/tables/$name.csv t" "SELECT verdict, claim, ours FROM t"
  done
}

PATH=/nowhere succeeds reproduce --jobs 2 --out whole # scripts alone, without gnuplot
quiet
sed -n '/./,$p' .out >screen
[ "$(wc -l <screen)" -le 40 ] && [ "$(wc -L <screen)" -le 100 ] || fail "not one screen: $(<screen)"
equal "last line" "$(tail -n 1 screen)" "Report: whole/report.html"
[ "$(words whole)" -le 3600 ] || fail "report.md has $(words whole) words"
for study in "${studies[@]}"; do
  equal "fingerprint of $study" "$(fingerprint whole/store.sqlite "$study")" "$(reference "$study")"
  numbers whole/store.sqlite "$study" |
    awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "run") run = i } NR == 1 || $run <= 2' >"whole-$study.csv"
  [ "$(wc -l <"whole-$study.csv")" -gt 1 ] || fail "no first runs of $study"
done
golden reproduce whole/results.json
kept claims < <(verdicts whole)
for table in 1 2 3 3-50 4 4-50 5 5-50 7 8; do [ -s "whole/tables/table-$table.csv" ] || fail "there is no Table $table"; done
for figure in {5..12} {5..12}-50 {15..18}; do [ -s "whole/figures/source/figure-$figure.gp" ] || fail "there is no Figure $figure"; done
[ "$(find whole -type f | wc -l)" -le $((110 - 2 * 22)) ] || fail "too many files: $(find whole -type f)" # and two pictures a figure
kept multiverse <whole/tables/multiverse.csv

# Every instruction set, and other numbers of threads.
mapfile -t sets < <("$program" list instruction-sets | tail -n +2 | cut -d' ' -f1)
for i in "${!sets[@]}"; do
  export IKBENCH_INSTRUCTION_SET=${sets[i]}
  succeeds list instruction-sets
  grep -q "^${sets[i]} *yes" .out || fail "not in use: ${sets[i]}"
  succeeds reproduce --runs 2 --jobs $((${#sets[@]} - i)) --readings 0 --figures none --out "${sets[i]}"
  for study in "${studies[@]}"; do
    numbers "${sets[i]}/store.sqlite" "$study" | cmp - "whole-$study.csv" || fail "$study with ${sets[i]}: other numbers"
  done
done
unset IKBENCH_INSTRUCTION_SET

# Papers of poses: an arm or the studies whole, and all with fewer poses.
succeeds run beeson2015 --only KDL,KDL-RR --set name=beeson2015-fanuc_m430ia2f --set robot=fanuc_m430ia2f --no-report --jobs 2 --out fanuc
succeeds reproduce haviland2023 --jobs 2 --figures none --out six_rules
kept haviland2023 <six_rules/tables/numbers.csv
succeeds reproduce haviland2023 --runs 1 --figures none --out one   # a rule without a solve has no iterations
equal columns "$(awk -F, '{ print NF }' one/tables/numbers.csv | sort -u)" "$(head -n 1 one/tables/numbers.csv | awk -F, '{ print NF }')"
succeeds run haviland2023-searches --set seed=10 --set published= --set name=haviland2023-part2 --only "NR,LM Wampler 1e-4,LM Chan 0.1,LM Sugihara 1e-4" --no-report --jobs 2 --out six_rules
for study in fanuc/beeson2015-fanuc_m430ia2f six_rules/haviland2023 six_rules/haviland2023-searches; do
  equal "fingerprint of $study" "$(fingerprint "${study%/*}/store.sqlite" "${study#*/}")" "$(reference "${study#*/}")"
done
succeeds reproduce beeson2015 --runs 500 --jobs 2 --figures none --out beeson2015
equal "solves of more runs" "$(sqlite3 beeson2015/store.sqlite 'SELECT count(*) FROM solves WHERE run > 500')" 0
kept beeson2015 < <(cut -d, -f1-5 beeson2015/tables/solve-rates.csv) # the other columns depend on NLopt

# TRAC-IK itself is judged by stored solves, or by those of this machine if they are of all arms.
grep -q '^ABB IRB120,[^,]*,[^,]*,[^,]*,[^,]*,99.9,99.91,0.332,0.26' beeson2015/tables/solve-rates.csv || fail "TRAC-IK: $(<beeson2015/tables/solve-rates.csv)"
stored=$root/results/published/beeson2015/programs.csv
again=(reproduce beeson2015 --runs 500 --figures none --out beeson2015)
head -3 "$stored" >beeson2015/programs.csv
refused "2 rows" "${again[@]}"
sed 's/,9990,0.332,/,9000,0.1,/' "$stored" >beeson2015/programs.csv
succeeds "${again[@]}"
grep -q '^ABB IRB120,[^,]*,[^,]*,[^,]*,[^,]*,90.0,99.91,0.1,0.26' beeson2015/tables/solve-rates.csv || fail "anew: $(<beeson2015/tables/solve-rates.csv)"

# Numbers of answers: nothing is solved, so no library is needed; other solves are judged in place of the stored ones.
PATH=/nowhere succeeds reproduce ssik2026 --out ssik2026
quiet
kept ssik2026 < <(cat ssik2026/tables/{answers,claims,questions}.csv)
mkdir anew
sed 's/^1,4,/1,9,/' "$root/results/published/ssik2026/ssik.csv" >anew/ssik.csv
succeeds reproduce ssik2026 --out anew --json
equal "ssik solved here" "$(python3 -c 'import json; print(json.load(open(".out"))["headline"])')" \
  "12 of 16 rows of ssik and 7 of 9 of EAIK are the published ones."
echo 'pose,UR5' >anew/ssik.csv && printf '1,eight\n' >>anew/ssik.csv
refused 'anew/ssik.csv:2: UR5 is "eight"' reproduce ssik2026 --out anew

# README and the pages on papers have these numbers.
python3 "$scripts/page_numbers.py" "$root" whole six_rules fanuc ssik2026 || fail "a page says other numbers, or fewer"

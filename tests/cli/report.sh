#!/usr/bin/env bash
# A report is made from the store alone: in another folder, by somebody who may only read it, with nothing solved.
source "$(dirname "$0")/common.sh"

succeeds run --verbose slim2023 "${small[@]}" --out made
has "$out" "36 solves in made/store.sqlite"
[ "$(tail -n 1 .out)" = "Report: made/report.html" ] || fail "the last line is: $(tail -n 1 .out)"
quiet
for file in made/report.md made/report.html made/tables/table-3.csv made/tables/table-3.md made/tables/table-3.tex; do
  [ -s "$file" ] || fail "no $file"
done
if command -v gnuplot >/dev/null; then
  for figure in 5 6 7 8 9 10 11 12; do
    [ -s "made/figures/figure-$figure.svg" ] || fail "no figure $figure"
  done
fi

# A copy elsewhere: the same tables, and the store is not touched.
mkdir copy
cp made/store.sqlite copy/theirs.sqlite
before=$(sha256sum <copy/theirs.sqlite)
succeeds report --verbose copy/theirs.sqlite --no-figures
[ "$(sha256sum <copy/theirs.sqlite)" = "$before" ] || fail "report changed the store"
cmp copy/tables/table-3.csv made/tables/table-3.csv || fail "the copy gives another Table 3"
succeeds report --verbose copy/theirs.sqlite --no-figures --out elsewhere/deep
[ -s elsewhere/deep/report.md ] || fail "no report in --out"
[ "$(ls copy | sort | tr '\n' ' ')" = "figures report.html report.md solves.csv statistics.json tables theirs.sqlite " ] || fail "copy/ has: $(ls copy)"

# Opens a store by its bare name in its own folder.
(cd copy && "$program" report theirs.sqlite --no-figures >/dev/null 2>&1) || fail "cannot report on a store in ."

# Only tables, other readings.
[ -z "$(find copy -name '*.svg' -o -name '*.png' -o -name '*.pdf')" ] || fail "--no-figures drew figures"
refused 'points of one run depend on each other' report copy/theirs.sqlite --no-figures --unit point --out points
[ ! -e points ] || fail "a refused report was written"
succeeds report --verbose copy/theirs.sqlite --no-figures --unit point --quartiles 7 --force --out points
has "$err" "warning: Points of one run depend on each other; used as observations because --force was given."
has "$(<points/tables/analysis-plan.md)" "Set on the command line after the data were collected, not by the study"
cmp -s points/tables/table-4.csv made/tables/table-4.csv && fail "--unit point gives the same ANOVA"

# The study says how it is judged; a change after its solves were made is told, and costs no solve.
has "$(<made/tables/analysis-plan.md)" "The methods were fixed in the study before its first solve"
succeeds run --verbose slim2023 "${small[@]}" --no-report --out planned
succeeds run --verbose slim2023 "${small[@]}" --no-figures --set analysis.significance=0.01 --out planned
has "$out" "(36 were already stored)"
has "$err" "warning: the analysis plan of slim2023 in planned has changed: significance 0.05 -> 0.01"
has "$err" "warning: The analysis plan was changed after 36 of 36 solves were made: significance 0.05 -> 0.01."
has "$(<planned/tables/analysis-plan.csv)" $'\nsignificance,0.01,'
cmp planned/tables/table-4.csv made/tables/table-4.csv || fail "another plan gives another ANOVA"
# A study whose observations are points needs --force wherever it is used.
succeeds run --verbose slim2023 "${small[@]}" --no-report --set analysis.unit=point --force --out insisted
refused 'the plan of the study slim2023 has unit = "point"' report insisted/store.sqlite --no-figures
succeeds report --verbose insisted/store.sqlite --no-figures --unit run
cmp -s insisted/tables/table-4.csv points/tables/table-4.csv && fail "--unit run gives the ANOVA of points"
succeeds report --verbose insisted/store.sqlite --no-figures --force
has "$(<insisted/tables/table-4.md)" "One observation is one point."

# A report and a comparison change no byte of the store.
before=$(sha256sum made/store.sqlite)
succeeds report --verbose made/store.sqlite --no-figures --out again
run_it compare IK-BA DE --store made/store.sqlite --metric evaluations
[ "$(sha256sum made/store.sqlite)" = "$before" ] || fail "a reader changed the store"

# Two studies in a store: the first, unless another is asked for.
succeeds run --verbose slim2023-context "${small[@]}" --no-report --out made
has "$out" "12 solves"
succeeds report --verbose made/store.sqlite --no-figures --out first
has "$(<first/report.md)" "Report of the study slim2023"
succeeds report --verbose made/store.sqlite --no-figures --study slim2023-context --out second
has "$(<second/report.md)" "slim2023-context"
has "$(<second/tables/results.csv)" "DLS" # it has no paper, and so no Table 3
[ ! -e second/tables/table-3.csv ] || fail "a study without a paper has a Table 3"

# Targets that no configuration reaches are told at the top of the report, of a store made elsewhere too.
succeeds run --verbose slim2023 "${small[@]}" --set 'path.centre_cm=[1000,0,0]' --no-report --out far
has "$err" "warning: point 1 is out of reach"
succeeds report --verbose far/store.sqlite --no-figures
has "$(head -n 20 far/report.md)" "3 of the 3 targets of a run cannot be reached. The farthest is point "
has "$err" "warning: 3 of the 3 targets of a run cannot be reached"

# A store that may only be read, in a folder that may only be read, by somebody who is not root.
mkdir closed
cp copy/theirs.sqlite closed/store.sqlite
chmod 444 closed/store.sqlite
chmod 555 closed
mkdir -m 777 open
reader=()
if [ "$(id -u)" = 0 ] && command -v setpriv >/dev/null; then
  chmod 755 "$work"
  reader=(setpriv --reuid=65534 --regid=65534 --clear-groups)
  "${reader[@]}" "$program" --version >/dev/null 2>&1 || reader=() # the build folder may be closed to others
fi
"${reader[@]}" "$program" report closed/store.sqlite --no-figures --out open/report >.out 2>.err ||
  fail "cannot report on a store that may only be read: $(<.err)"
cmp open/report/tables/table-3.csv made/tables/table-3.csv || fail "the read-only store gives another Table 3"
"${reader[@]}" "$program" export closed/store.sqlite >.out 2>.err || fail "cannot export it: $(<.err)"
chmod 755 closed
[ "$(ls closed)" = store.sqlite ] || fail "closed/ has: $(ls closed)"

exit 0

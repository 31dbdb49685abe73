#!/usr/bin/env bash
# stats: the numbers of CSVs from anywhere, and mistakes in them.
source "$(dirname "$0")/common.sh"
data=$root/tests/data/csv
printf 'wer;wert\nA;0,5\nA;0,6\nA;0,55\nA;0,52\nB;0,7\nB;0,8\nB;0,75\nB;0,72\n' >comma.csv
printf 'solver,run,error\n' >many.csv
for i in 1 2 3 4 5 6 7; do
  for run in 1 2 3 4 5 6; do printf 'S%d,%d,%d.%d\n' $i $run $((i * i + 7 * i * run % 5)) $run; done
done >>many.csv

# judged NAME ARGUMENTS...: its golden verdict; and nothing is written that nobody asked for.
judged() {
  succeeds stats "${@:2}" --json
  quiet
  golden "stats-$1"
  [ ! -e out ] || fail "a report that nobody asked for"
}
judged two-columns "$data/runmeans.csv" --better smaller # no column has to be named
judged constant "$data/const2.csv" --better smaller
judged negative "$data/drift.csv" --better smaller --margin 1
succeeds stats "$data/drift.csv" --better smaller
has "$out" "no margin is used"
judged paired "$data/ten.csv" --block problem --better smaller
judged unpaired "$data/ten.csv" --label solver --run row --better smaller
judged control "$data/zero.csv" --better smaller --control B --significance 0.01
judged zeros "$data/zero0.csv" --better smaller
judged means "$data/zero.csv" --better smaller --test means
judged where "$data/mixed-metrics.csv" --label solver --value value --where metric=error --run row --better smaller
judged larger comma.csv --better larger
judged comma comma.csv --better smaller
judged summaries --summaries "$root/results/published/slim2023/table-3.csv" --better smaller
judged many many.csv --run run --better smaller --control S1
(ulimit -s 64; "$program" stats comma.csv --better smaller) >.out 2>.err || fail "with a stack of 64 kB: exit code $?: $(<.err)"
"$program" stats - --better smaller --json <comma.csv >.input || fail "standard input: exit code $?"
golden stats-comma .input

# A report, and its files.
succeeds stats comma.csv --better smaller --out new/report --json
has_no "$(<new/report/article/methods.tex)" ".." # sentences of which one brought its own full stop
golden stats-comma
golden stats-comma new/report/results.json
json '{"report.html", "tables/descriptives.tex", "figures/boxes.pdf", "figures/source/boxes.gp", "figures/differences.pdf"} <= set(of["files"])'
json 'of["direction"] == {"wert": "smaller"}'
for file in report.html report.md tables/results.tex; do
  grep -q 'smaller is better' new/report/$file || fail "no direction in $file"
done
for file in $(python3 -c 'import json; print(*json.load(open(".out"))["files"])'); do [ -s "new/report/$file" ] || fail "no $file"; done
[ ! -e new/report/solves.csv ] || fail "solves of a file that has none"

# Which way is better is always asked, whatever else is said.
for options in --json "--out asked" "--test means" "--control A"; do refused "--better larger" stats "$data/accuracy.csv" $options; done
[ ! -e asked ] || fail "a report of what was not said"
succeeds stats "$data/accuracy.csv" --better larger
has "$out" "A is better than B: median accuracy 0.91"

# asked WORD ARGUMENTS...: a question of one page, with the word; nothing is read.
asked() {
  ends 1 stats "${@:2}"
  has "$err" "$1"
  has "$err" docs/your-own-csv.md
  [ -z "$out" ] || fail "$* wrote $out"
  [ "$(wc -l <.err)" -le 20 ] || fail "a long question: $err"
}
asked "--label version --value runtime --better smaller" "$data/versions.csv"
asked "--label solver --value runtime --block version --block date --better" "$data/versions.csv" --label solver --value runtime
cp "$data/two-factors.csv" 'my file.csv'
asked "stats 'my file.csv' --better larger --label robot --value error" 'my file.csv' --better larger
# Each command is one that runs as it is printed.
printf 'my alloy,X,Y\n1,407,440\n2,402,437\n3,408,427\n4,420,438\n5,414,426\n6,425,442\n7,411,438\n' >wide.csv
asked "--label columns --block row" wide.csv
PATH=$(dirname "$program"):$PATH
grep '^    ikbench' .err >printed || fail "no commands: $err"
while IFS= read -r command; do bash -c "$command" >.out 2>&1 </dev/null || fail "$command: $(<.out)"; done <printed
equal "printed commands" "$(wc -l <printed)" 2

# Quantities may have any name, also one that a table of ours has for itself.
{ echo "solver,remark,verdict"; for i in 1.3 1.1 1.7 1.9 1.2; do echo "A,$i,1$i"; echo "B,2$i,2$i"; done; } >names.csv
succeeds stats names.csv --value remark --value verdict --better smaller --out names --figures none
grep -q '^A & .*1.3.* & 11.3 ' names/tables/results.tex || fail "no numbers: $(cat names/tables/results.tex)"
! grep -q 'class="pill">1' names/report.html || fail "a number is shown as a verdict"

# What has no answer is no bound, where larger is better, too; a label without values takes no picture from the others.
printf 's,v\nA,\nA,\nA,3\nB,4\nB,5\nB,6\n' >worst.csv
succeeds stats worst.csv --better larger --missing worst
has_no "$out" "at most"
if can gnuplot; then
  { echo s,p,v; for p in 1 2 3 4 5 6 7 8; do echo "A,$p,1$p"; echo "B,$p,2$p"; echo "C,$p,3$p"; echo "D,$p,"; done; } >lacks.csv
  succeeds stats lacks.csv --block p --better smaller --missing drop --out lacks
  [ -s lacks/figures/source/ranks.gp ] || fail "no ranks: $(ls lacks/figures/source)"
fi

# Many pairs hold no values of their own: the same number of rows takes no more than twice the memory with 100 labels.
cat >memory.py <<'END'
import random, resource, subprocess, sys
labels, rows = map(int, sys.argv[2:])
lines = ["solver,error"]
for label in range(labels):
    lines += [f"s{label},{random.Random(label).lognormvariate(0, 1) * (1 + row % 97):.6g}" for row in range(rows)]
open("labels.csv", "w").write("\n".join(lines))
command = [sys.argv[1], "stats", "labels.csv", "--better", "smaller", "--test", "means"]
subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
END
few=$(python3 memory.py "$program" 2 40000) many=$(python3 memory.py "$program" 100 800)
((many <= 2 * few)) || fail "memory of 100 labels: $many kB, of 2 labels with as many rows $few kB"

# An input is no output.
mkdir in && cp comma.csv in/report.md
refused "in/report.md" stats in/report.md --better smaller --out in
cmp comma.csv in/report.md || fail "an input was replaced"

# What is stopped and stores nothing speaks of no store.
mkfifo held && exec 3<>held
"$program" stats - <held >.out 2>.err &
until [ "$(ls "/proc/$!/task" | wc -l)" -ge 2 ]; do sleep 0.01; done
kill $!
wait $!
equal "code and words after SIGTERM" "$? $(tr -d '\n' <.err)" "143 Stopped."

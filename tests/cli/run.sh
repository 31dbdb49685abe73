#!/usr/bin/env bash
# run and report: the numbers of a study, its files, its screen, and that nothing but the study changes a number.
source "$(dirname "$0")/common.sh"

# The tutorial's study keeps the promises of smallness.
awk '/^```toml mine.toml/ { shown = 1; next } /^```/ { shown = 0 } shown' "$root/docs/tutorial.md" >mine.toml
sed -i '0,/^\[\[solvers\]\]/s//&\ncolour = "#00FF00"/' mine.toml
cp "$root/docs/examples/pso.py" mine.py
cp "$root/solvers/helpers/ikbench.py" .
succeeds run mine.toml --out mine
quiet
quoted() { grep -qF -- "$(sed 's/\. .*//; s/\.$//; q' .out)" "$root/docs/tutorial.md" || fail "the tutorial does not say: $(head -n 1 .out)"; }
quoted
debug=0 # times of a debug build are not compared: two lines more, a picture less; of a busy machine one line
! grep -q "a debug build" .out || debug=1
[ "$(wc -l <.out)" -le $((18 + 2 * debug)) ] && [ "$(wc -L <.out)" -le 100 ] || fail "not one screen: $out"
equal "last line" "$(tail -n 1 .out)" "Report: mine/report.html"
files=$(find mine -type f | wc -l)
[ "$files" -le 40 ] || fail "$files files: $(find mine -type f)"
[ "$(words mine)" -le 960 ] || fail "report.md has $(words mine) words"
if can gnuplot; then
  for type in svg pdf; do equal ".$type" "$(ls mine/figures/*.$type | wc -l)" $((6 - debug)); done
  for figure in mine/figures/*.svg; do
    grep -qFf <(base64 -w0 "$figure") mine/report.html || fail "the page shows another $figure"
  done
  grep -q '^colours.*#00FF00' mine/figures/source/style.gp || fail "a solver has not its colour"
  succeeds report mine/store.sqlite --figures error,differences --out few
  equal "chosen figures" "$(cd few/figures && echo *.svg)" "differences.svg error-shares.svg"
  # Every figure can be asked for alone, and no other is drawn.
  echo 'formats = ["svg"]' >svg.toml
  drawn=
  for figure in $("$program" list figures | sed -n '2,/^$/s/^\([a-z][^ ]*\) .*/\1/p'); do
    succeeds report mine/store.sqlite --figures "$figure" --style svg.toml --out "only-$figure"
    [ -z "$err" ] || { has "$err" "warning: there is nothing to draw for $figure; "; continue; }
    drawn+=" $figure"
    equal "drawn for $figure" "$(cd "only-$figure/figures" && echo *.svg)" "$figure.svg"
  done
  by_time=" solved-by-time"
  equal "figures of the tutorial's study" "$drawn" " error-shares solved-by-evaluations${by_time:$((debug * 20))} targets ranks differences"
fi
golden tutorial mine/results.json
ends 3 compare PSO mine --store mine/store.sqlite
quoted
cp -r mine changed
sed 's/^process = .*/&\noptions = { w = 0.5 }/' mine.toml >changed.toml
succeeds run changed.toml --figures none --out changed
quoted
# A store of version 3 as the first program of that version wrote it: every later one reads it.
succeeds report "$root/tests/data/version-4.sqlite" --figures none --out years
golden version-4 years/results.json
# Without gnuplot one line says so, there and on the page, and all else is there.
PATH=/nowhere "$program" report mine/store.sqlite --out bare >.out 2>.err || fail "without gnuplot: $(<.err)"
equal "lines without gnuplot" "$(grep -c gnuplot .err)" 1
for file in report.md report.html; do equal "$file" "$(grep -c 'Warning: figures are not drawn' "bare/$file")" 1; done
[ -s bare/figures/source/error-shares.gp ] && [ ! -e bare/figures/error-shares.svg ] || fail "without gnuplot: $(ls bare/figures)"

# A study without a path has the protocol of any arm.
printf 'robot = "ur5e"\n[[solvers]]\nlabel = "LM"\nsolver = "levenberg_marquardt"\n' >short.toml
for study in short.toml "--robot ur5e --only LM"; do succeeds run $study --set name=short --set runs=6 --no-report -o "by-${study:0:1}"; done
same_fingerprint by-s/store.sqlite by--/store.sqlite

# A study of the paper.
paper=(slim2023 --set runs=3 --set path.points=5)
succeeds run "${paper[@]}" --figures none --out made --json
quiet
golden slim2023
json 'of["metric"] == "position error" and "report.html" in of["files"] and len(of["files"]) < 45'
[ ! -e made/figures ] || fail "pictures or scripts: $(find made/figures)"
succeeds report made/store.sqlite --figures none --json --out again
golden slim2023

# Of the store alone, in another folder, at another time, by somebody else: the same bytes.
mkdir "another folder"
cp made/store.sqlite "another folder/theirs.sqlite"
(cd "another folder" && TZ=Asia/Kolkata HOME=$PWD USER=somebody SOURCE_DATE_EPOCH=1 \
  "$program" report theirs.sqlite --figures none >/dev/null 2>&1) || fail "no report of a bare name"
rm made/store.sqlite-* 2>/dev/null
diff -r --exclude='*.sqlite' made "another folder" || fail "two reports of one store differ"
cmp made/store.sqlite "another folder/theirs.sqlite" || fail "report changed the store"

# Any arm and task: a stranger's URDF with a torso that slides, whole poses, eight solvers; nothing of a paper.
cp "$root/tests/data/urdf/fetch.urdf" "$scripts/studies/theirs.toml" .
succeeds run theirs.toml --figures none --out theirs
equal "solves of a stranger's arm" "$(solves theirs/store.sqlite)" 96
! grep -i -n 'helix\|slim' theirs/report.html theirs/report.md || fail "the report speaks of a paper"
json '{("damped_least_squares", 92), ("newton", 75)} <= {(row["solver"], round(row["mean"])) for row in of["groups"] if row["metric"] == "targets solved"}' \
  theirs/results.json

# Sweeps: every combination is an entry (sweep.test.cpp).
succeeds run "$scripts/studies/sweep.toml" --figures none --sweep population=4,8,200 --sweep mine.alpha=0.5,0.9 --json
json 'len({row["solver"] for row in of["groups"]}) == 9'

# A built-in study of another arm has a name of its own. (Labels with commas: sweep.test.cpp.)
succeeds run baselines --robot ur5e --only LM --set runs=1 --set path.points=2 --no-report --out only
equal "study" "$(sqlite3 only/store.sqlite "SELECT name FROM studies")" baselines-ur5e

# The answer without a report: the same, and nothing but the store is written.
unreported=(slim2023 --set runs=3 --set stop.iterations=5 --set path.points=4)
succeeds run "${unreported[@]}" --json --no-report --out unreported
equal files "$(ls unreported)" store.sqlite
python3 -c 'import json; json.dump(json.load(open(".out")), open("alone.json", "w"))'
succeeds report unreported/store.sqlite --json --figures none
python3 -c 'import json; both = [json.load(open(name)) for name in ("alone.json", ".out")]; both[1].pop("files"); assert both[0] == both[1]' ||
  fail "another answer than that of the report"

# Requirements: each verdict has its exit code, also from the study's file and from a store.
cat >require.toml <<'END'
robot = "ur5e"
search = "pose"
start = "middle"
runs = 60
path = { kind = "random", points = 1 }
stop = { tolerance_cm = 0.001, tolerance_deg = 0.01, evaluations = 2000 }
[[solvers]]
label = "LM"
solver = "levenberg_marquardt"
[[solvers]]
label = "hopeless"
solver = "random_search"
END
ends 0 run require.toml --require LM.solved=50% --strict --figures none
ends 3 run require.toml --require solved=50% --figures none
ends 0 report out/require/store.sqlite --require LM.solved=99.9% --figures none
has "$(<.out)" "--strict"
ends 4 report out/require/store.sqlite --require LM.solved=99.9% --strict --figures none
ends 1 report out/require/store.sqlite --require nobody.solved=50% --figures none
equal "verdicts" "met failed" "$("$program" report out/require/store.sqlite --require solved=50% --figures none --json |
  python3 -c 'import json, sys; print(*(each["verdict"] for each in json.load(sys.stdin)["requirements"]))')"
sed '/^stop/a [require]\n"hopeless.solved" = "50%"' require.toml >inside.toml
ends 3 run inside.toml --figures none
ends 0 report out/inside/store.sqlite --require LM.solved=50% --figures none
ends 3 run inside.toml --no-report
ends 0 run inside.toml --only LM --figures none --out out/only
refused "not judged" run require.toml --shard 1/2 --require LM.solved=50%
"$program" list studies inside.toml >again.toml
ends 3 run again.toml --out out/again --figures none

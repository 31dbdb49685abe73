#!/usr/bin/env bash
# All combinations of what a paper leaves open: resumable, the same for any number of jobs; Ctrl-C tells how to go on.
source "$(dirname "$0")/common.sh"

succeeds multiverse --verbose slim2023 --list
has "$out" "bounds=initial"
has "$out" "interpretations of"
succeeds multiverse --verbose slim2023 --small --list
has "$out" "interpretations of"

few=(--dimensions bounds,IK-BA.f_max,BA.best_of)
succeeds multiverse --verbose slim2023 "${small[@]}" "${few[@]}" --jobs 2 --out folder
quiet
has "$out" "IK-BA is the most accurate in"
has "$out" "Eq. 13 makes IK-BA move the joints less in 0 % of the interpretations (100 % fail, 0 % undecided)"
for table in multiverse multiverse-alternatives; do
  for type in md csv tex; do [ -s "folder/tables/$table.$type" ] || fail "no $table.$type"; done
done
for type in gp dat; do [ -s "folder/figures/multiverse.$type" ] || fail "no multiverse.$type"; done
! command -v gnuplot >/dev/null || [ -s folder/figures/multiverse.png ] || fail "no picture"

# One job, and a file that was cut: the same bytes.
succeeds multiverse --verbose slim2023 "${small[@]}" "${few[@]}" --no-figures --out again
cmp folder/series.csv again/series.csv || fail "other series with one job"
head -c 1500 folder/series.csv >again/series.csv
succeeds multiverse --verbose slim2023 "${small[@]}" "${few[@]}" --no-figures --out again
cmp folder/series.csv again/series.csv || fail "other series after a cut"
for file in tables/multiverse.csv tables/multiverse-alternatives.csv figures/multiverse.dat; do
  cmp "folder/$file" "again/$file" || fail "another $file"
done
# Each alternative alone, from the same series: what is there is not solved again.
tiny=(--set runs=2 --set path.points=3 --set stop.iterations=5)
succeeds multiverse --verbose slim2023 "${tiny[@]}" --one-at-a-time --jobs 2 --out alone
quiet
has "$out" "DE.bounds=reflect"
has "$out" "most_accurate "
for type in md csv tex; do [ -s "alone/tables/multiverse-one-at-a-time.$type" ] || fail "no one-at-a-time.$type"; done
cp alone/tables/multiverse-one-at-a-time.csv first.csv
lines=$(wc -l <alone/series.csv)
succeeds multiverse --verbose slim2023 "${tiny[@]}" --dimensions search --out alone --no-figures
[ "$(wc -l <alone/series.csv)" = "$lines" ] || fail "solved again what was solved"
succeeds multiverse --verbose slim2023 "${tiny[@]}" --one-at-a-time --out again-alone
cmp again-alone/tables/multiverse-one-at-a-time.csv first.csv || fail "other numbers with one job"
succeeds multiverse --verbose slim2023 --one-at-a-time --dimensions bounds,DE.bounds --list
has "$out" "6 interpretations of 2 dimensions: 3 choices for the study, 21 series for a seed"

refused 'unknown dimension "bound"' multiverse slim2023 --dimensions bound
refused 'is given twice' multiverse slim2023 --dimensions bounds,bounds
refused '--seeds' multiverse slim2023 --seeds 0
refused 'did you mean "slim2023"' multiverse slim2024
refused 'seeds 1 to --seeds' multiverse slim2023 --set seed=77
refused 'population is a dimension that varies' multiverse slim2023 --dimensions population --set population=20
refused 'excludes' multiverse slim2023 --small --dimensions bounds
refused 'excludes' multiverse slim2023 --small --one-at-a-time
refused '--set runs: runs is 0' multiverse slim2023 --set runs=0 --list
sed -i '2s/,.*,/,-1,/' again/series.csv
refused "series.csv:2: column position_error_cm, run 1: '-1', expected a number from 0, or Inf; the file was edited: remove this line" \
  multiverse slim2023 "${small[@]}" --dimensions bounds --out again
echo "edited" >folder/series.csv
refused 'series.csv:1' multiverse slim2023 "${small[@]}" --dimensions bounds --out folder

stopped_after_a_second multiverse slim2023 --set runs=500 --jobs 1 --out long
has "$(<stopped.err)" "to continue: ikbench multiverse slim2023 --set runs=500 --jobs 1 --out long"

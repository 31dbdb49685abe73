#!/usr/bin/env bash
# All combinations of what a paper leaves open: resumable, the same for any number of jobs; Ctrl-C tells how to go on.
source "$(dirname "$0")/common.sh"

succeeds multiverse --verbose slim2023 --list
has "$out" "bounds=initial"
has "$out" "interpretations of"
succeeds multiverse --verbose slim2023 --small --list
has "$out" "interpretations of"

few=(--dimensions bounds,IK-BA.step_factor,BA.best_of)
succeeds multiverse --verbose slim2023 "${small[@]}" "${few[@]}" --jobs 2 --out folder
quiet
has "$out" "IK-BA is the most accurate in"
has "$out" "IK-BA and MO-PSO move the joints least in"
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

refused 'unknown dimension "bound"' multiverse slim2023 --dimensions bound
refused 'is given twice' multiverse slim2023 --dimensions bounds,bounds
refused '--seeds' multiverse slim2023 --seeds 0
refused 'did you mean "slim2023"' multiverse slim2024
refused 'seeds 1 to --seeds' multiverse slim2023 --set seed=77
refused 'population is a dimension that varies' multiverse slim2023 --dimensions population --set population=20
refused 'excludes' multiverse slim2023 --small --dimensions bounds
refused '--set runs: runs is 0' multiverse slim2023 --set runs=0 --list
sed -i '2s/,.*,/,-1,/' again/series.csv
refused "series.csv:2: column position_error_cm, run 1: '-1', expected a number from 0, or Inf; the file was edited: remove this line" \
  multiverse slim2023 "${small[@]}" --dimensions bounds --out again
echo "edited" >folder/series.csv
refused 'series.csv:1' multiverse slim2023 "${small[@]}" --dimensions bounds --out folder

stopped_after_a_second multiverse slim2023 --set runs=500 --jobs 1 --out long
has "$(<stopped.err)" "to continue: ikbench multiverse slim2023 --set runs=500 --jobs 1 --out long"

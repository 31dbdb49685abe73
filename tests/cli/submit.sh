#!/usr/bin/env bash
# submit writes job scripts that do what they say, whatever the names are, and status tells how far they are.
source "$(dirname "$0")/common.sh"

# A Slurm that only writes down what it is given; work_off FOLDER does it, one task after another.
mkdir bin
cat >bin/sbatch <<'SH'
#!/usr/bin/env bash
printf '%s\n' "$@" >>"$SUBMISSIONS"
echo "sbatch: a warning" >&2
echo "7;cluster"
SH
work_off() {
  local i
  for i in 1 2 3; do
    SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID=$i bash "$1/solve.sbatch" >>"$1/log/$i.txt" 2>&1
  done
  bash "$1/merge.sbatch" >"$1/log/merge.txt" 2>&1
}
printf '#!/usr/bin/env bash\necho "$@" >>"$SUBMISSIONS.requeued"\n' >bin/scontrol
chmod +x bin/*
export PATH=$work/bin:$PATH SUBMISSIONS=$work/submissions

# Nothing is written in a dry run.
succeeds submit slim2023 "${small[@]}" --tasks 2 --out dry --sbatch "--partition=long  --time=1:00" --dry-run
has "$out" "#SBATCH --array=1-2"
has "$out" "sbatch --parsable --partition=long --time=1:00 solve.sbatch"
has "$out" "sbatch --parsable --partition=long --time=1:00 --dependency=afterany:ARRAY merge.sbatch"
[ ! -e dry ] && [ ! -e submissions ] || fail "a dry run did something"

# Names that a shell would take for something else.
hostile=$'a "b" $(touch pwned) `touch pwned` %a\n#SBATCH --array=1-99\n'"'; touch pwned; '"
mkdir "$hostile"
cd "$hostile" || exit 1
printf 'name = "$(touch pwned) %%s \\\\ \\" x"\nruns = 3\npopulation = 6\nstop.iterations = 5\npath = { kind = "helix", points = 3 }\nsolvers = [{ solver = "bat" }, { solver = "newton" }]\n' >"-- my \$(touch pwned).toml"
succeeds submit "./-- my \$(touch pwned).toml" --tasks 3 --out "results $hostile" --set "title=\"'; touch pwned\""
has "$out" "job 7 has 3 tasks, then job 7 merges and reports"
folder="results $hostile"
work_off "$folder"
bash -n "$folder/solve.sbatch" && bash -n "$folder/merge.sbatch" || fail "a script is no bash"
[ "$(grep -c '^#SBATCH --array' "$folder/solve.sbatch")" -ge 1 ] || fail "no array"
[ "$(grep -m1 '^#SBATCH --array' "$folder/solve.sbatch")" = "#SBATCH --array=1-3" ] || fail "another array first"
[ -s "$folder/report.md" ] || fail "no report: $(cat "$folder"/log/*)"
succeeds run "./-- my \$(touch pwned).toml" --set "title=\"'; touch pwned\"" --out one --no-report
same_fingerprint "$folder/store.sqlite" one/store.sqlite
succeeds status "$folder"
quiet
has "$out" "3 shards"
has "$out" "done  3  1-3"
has "$out" "18 of 18 solves"
has "$out" "Merged: 18 of 18 solves"
cd "$work" || exit 1
[ -z "$(find . -name 'pwned*')" ] || fail "a name was run: $(find . -name 'pwned*')"
mapfile -t words <submissions
[ "${words[*]}" = "--parsable solve.sbatch --parsable --dependency=afterany:7 merge.sbatch" ] || fail "submitted: ${words[*]}"

# As data: the numbers of the jobs, and in a dry run the scripts.
succeeds submit slim2023 "${small[@]}" --tasks 2 --out data --json
python3 -c 'import json, sys; of = json.load(sys.stdin); assert (of["study"], of["array_job"], of["merge_job"], of["tasks"]) == ("slim2023", "7", "7", 2), of' <<<"$out" ||
  fail "the numbers of the jobs are not in: $out"
succeeds submit slim2023 "${small[@]}" --tasks 2 --out dry --dry-run --json
python3 -c 'import json, sys; of = json.load(sys.stdin)["scripts"]; assert "#SBATCH --array=1-2" in of[0]["text"] and of[1]["submission"][-1] == "merge.sbatch", of' <<<"$out" ||
  fail "the scripts are not in: $out"
[ ! -e dry ] || fail "a dry run did something"

# A task that fails is queued again, unless the request is wrong or it was thrice.
succeeds submit slim2023 "${small[@]}" --tasks 2 --out again
mkdir -p again/shards/1-of-2/store.sqlite # a mistake
SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID=1 bash again/solve.sbatch >/dev/null 2>&1
[ $? = 1 ] || fail "no mistake told"
[ ! -e submissions.requeued ] || fail "a mistake was queued again"
sed 's/^.* run .*--shard.*/(exit 2)/' again/solve.sbatch >again/failing.sbatch
fails_after() { SLURM_ARRAY_JOB_ID=7 SLURM_ARRAY_TASK_ID=2 SLURM_RESTART_COUNT=$1 bash again/failing.sbatch >/dev/null 2>&1; }
fails_after 0 && fail "no failure told"
[ "$(<submissions.requeued)" = "requeue 7_2" ] || fail "a failure was not queued again"
fails_after 3 && fail "no failure told"
[ "$(wc -l <submissions.requeued)" = 1 ] || fail "a failure was queued again for ever"

# Shards that run, stopped, and have not begun.
many=(slim2023 --set runs=30 --set path.points=20 --set stop.iterations=400)
"$program" run "${many[@]}" --shard 1/3 --out many/shards/1-of-3 >/dev/null 2>&1 &
process=$!
# incomplete FOLDER: exit code 5 of status.
incomplete() {
  run_it status "$1"
  [ "$code" = 5 ] || fail "exit code $code of status, expected 5: $out $err"
}
until [ "$("$program" export many/shards/1-of-3/store.sqlite 2>/dev/null | wc -l)" -gt 10 ]; do sleep 0.1; done
incomplete many
has "$out" "running    1  1"
has "$out" "not begun  2  2-3"
has "$out" " of 3600 solves, " # 6 solvers x 30 runs x 20 points
has "$out" " per second, "
[ ! -e many/shards/1-of-3/store.sqlite-wal ] || fail "a shard has a log, which network file systems do not support"
kill -9 $process
wait $process 2>/dev/null
incomplete many
has "$out" "stopped or failed  1  1"
has_no "$out" "per second"

# Solves of other parts in a shard's store are reported and stop no other shard; so are other divisions and another
# study.
study=(slim2023 "${small[@]}" --set runs=3)
succeeds run "${study[@]}" --shard 1/3 --out mixed/shards/1-of-3
succeeds run "${study[@]}" --shard 3/3 --out mixed/shards/2-of-3
mkdir -p mixed/shards/3-of-3
: >mixed/shards/3-of-3/store.sqlite
incomplete mixed
has "$out" "done               1  1"
has "$out" "stopped or failed  2  2-3"
has "$out" "Look at 2/3: 'mixed/shards/2-of-3/store.sqlite' has 18 solves of other shards"
has "$out" "Look at 3/3: 'mixed/shards/3-of-3/store.sqlite' is not an ikbench store yet"
rm -r mixed/shards/[23]-of-3
for i in 2 3; do succeeds run "${study[@]}" --shard $i/3 --out mixed/shards/$i-of-3; done
succeeds run "${study[@]}" --shard 1/2 --out mixed/shards/1-of-2
succeeds status mixed
has "$out" "Besides: 36 solves in 1 of 2 shards, another division"
succeeds run "${study[@]}" --set seed=9 --shard 2/3 --out mixed/shards/2-of-3
has "$err" "merge takes no two of one name"
incomplete mixed
has "$out" "Look at 2/3: the study slim2023 is not the same in shard 1/3 and shard 2/3: seed is 1 and 9"
sqlite3 mixed/shards/1-of-2/store.sqlite "DELETE FROM solves; DELETE FROM series; DELETE FROM studies" || fail "sqlite3"
rm -r mixed/shards/*-of-3
incomplete mixed
has "$out" "stopped or failed  1  1"

# A store that cannot be read counts as begun.
ln -sf store.sqlite mixed/shards/1-of-2/store.sqlite
incomplete mixed
has "$out" "Look at 1/2: cannot open 'mixed/shards/1-of-2/store.sqlite'"
mkdir unread
ln -s shards unread/shards
refused "cannot read 'unread/shards'" status unread

# Mistakes.
refused "'nowhere' is no folder" status nowhere
refused "'submissions' is no folder" status submissions
refused "no shard has begun in 'bin/shards'" status bin
refused "--tasks 9: slim2023 has only 2 runs to share out" submit slim2023 "${small[@]}" --tasks 9 --out none
refused "unknown built-in study" submit no-such-study --tasks 2 --out none
refused "--tasks" submit slim2023 --tasks 0 --out none
[ ! -e none ] || fail "a mistake made a folder"
printf '#!/usr/bin/env bash\necho "sbatch: error: no partition" >&2\nexit 1\n' >bin/sbatch
run_it submit slim2023 "${small[@]}" --tasks 2 --out refused
[ "$code" = 2 ] || fail "exit code $code where sbatch fails, expected 2"
has "$err" "sbatch --parsable solve.sbatch failed: sbatch: error: no partition; the job scripts stay in '$work/refused'"
PATH=/nowhere run_it submit slim2023 "${small[@]}" --tasks 2 --out refused
[ "$code" = 2 ] || fail "exit code $code without sbatch, expected 2"
has "$err" "cannot start sbatch"
exit 0

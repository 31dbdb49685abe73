#!/usr/bin/env bash
# A real Slurm on this machine: 12 tasks of a study, of which some are cancelled, give after all what one machine gives
# (killed ones: merge.sh). It waits for Slurm most of a minute. Skipped where Slurm is not installed (./setup --with-all check) or this is
# not root.
source "$(dirname "$0")/common.sh"
needs munged slurmctld slurmd sbatch
[ $EUID = 0 ] || skip "only root starts slurmd with jobs of its own"
host=$(hostname -s) run=$work/slurm
mkdir -p "$run"/{state,spool,log,munge}

# The test ends all that it started; the process numbers are in the files of $run.
stop() {
  local daemon pid
  scancel --user=root --quiet 2>/dev/null
  for daemon in slurmd slurmctld munged; do
    pid=$(cat "$run/$daemon.pid" 2>/dev/null) || continue
    kill "$pid" 2>/dev/null
    for _ in $(seq 50); do kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
    kill -9 "$pid" 2>/dev/null
  done
  rm -rf "$work"
}
trap stop EXIT
trap 'exit 1' INT TERM HUP

for port in $(shuf -i 20000-30000 -n 50); do # a free one, and the next
  (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null || (exec 3<>"/dev/tcp/127.0.0.1/$((port + 1))") 2>/dev/null || break
done
head -c 1024 /dev/urandom >"$run/munge/munge.key"
chmod 700 "$run/munge"
chmod 400 "$run/munge/munge.key"
# As root, in the test's own folders: munged warns of both.
munged --force --key-file="$run/munge/munge.key" --socket="$run/munge/socket" --pid-file="$run/munged.pid" \
  --log-file="$run/log/munged.log" --seed-file="$run/munge/seed" 2>"$run/log/munged.err" || fail "no munged: $(<"$run/log/munged.err")"
sed "s|@run|$run|; s|@host|$host|g; s|@port|$port|; s|@next|$((port + 1))|; s|@cpus|$(nproc)|" "$scripts/studies/slurm.conf" >"$run/slurm.conf"
export SLURM_CONF=$run/slurm.conf
slurmctld -f "$SLURM_CONF" && slurmd -f "$SLURM_CONF" || fail "no slurm: $(tail -n 5 "$run"/log/*.log)"
for _ in $(seq 600); do [ "$(sinfo --noheader --format=%T 2>/dev/null)" != idle ] || break; sleep 0.2; done
equal "state of the node" "$(sinfo --noheader --format=%T)" idle

# The study: enough that a task can be met while it runs.
study=(slim2023 --set runs=24 --set path.points=6 --set stop.iterations=5000 --set population=20)
mkdir bin "two words"
ln -s "$program" bin/ikbench
export PATH=$work/bin:$PATH
submit() {
  local array
  array=$(sbatch --parsable "$root/docs/examples/slurm.sbatch" "two words" "${study[@]}") || fail "no array"
  sbatch --parsable --dependency="afterany:$array" --job-name=merge --output=merge.txt --wrap \
    "ikbench merge 'two words' 'two words/shards'; echo code \$?; ikbench report 'two words/store.sqlite' --figures none" >merge.id || fail "no merge"
}
wait_for_all() {
  for _ in $(seq 1800); do
    [ -n "$(squeue --noheader)" ] || return 0
    sleep 0.2
  done
  fail "jobs do not end: $(squeue) $(tail -n 20 "$run"/log/*.log)"
}

# Two running tasks are cancelled.
submit
cancelled=0
while [ $cancelled -lt 2 ]; do
  [ -n "$(squeue --noheader --name=slurm.sbatch)" ] || fail "the tasks ended before they could be met: $(cat slurm-*.txt)"
  job=$(squeue --noheader --array --states=RUNNING --name=slurm.sbatch --format=%i | head -n 1)
  [ -n "$job" ] && scancel "$job" 2>/dev/null # which may have ended meanwhile
  sleep 0.5
  ! scontrol --oneliner show job "${job:-none}" 2>/dev/null | grep -q "JobState=CANCELLED" || cancelled=$((cancelled + 1))
done
wait_for_all
has "$(<merge.txt)" "code 5" # some are missing

# Cancelled tasks are submitted again.
submit
wait_for_all
has "$(<merge.txt)" "code 0"
succeeds run "${study[@]}" --out one --no-report
same_fingerprint "two words/store.sqlite" one/store.sqlite
equal solves "$(solves "two words/store.sqlite")" 864 # 6 solvers x 24 runs x 6 points

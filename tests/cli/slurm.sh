#!/usr/bin/env bash
# A real Slurm on this machine: 12 tasks of a study, of which some are cancelled and some killed, give after all what one
# machine gives. It waits for Slurm most of a minute. Skipped where Slurm is not installed (./setup --with-slurm) or this is
# not root.
source "$(dirname "$0")/common.sh"
for program_needed in munged slurmctld slurmd sbatch; do
  command -v $program_needed >/dev/null || { echo "skipped: no $program_needed (./setup --with-slurm)"; exit 77; }
done
[ $EUID = 0 ] || { echo "skipped: only root starts slurmd with jobs of its own"; exit 77; }

host=$(hostname -s)
run=$work/slurm
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

# A free port, and the next.
free_port() {
  local port
  for port in $(shuf -i 20000-30000 -n 50); do
    (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null || (exec 3<>"/dev/tcp/127.0.0.1/$((port + 1))") 2>/dev/null || { echo "$port"; return; }
  done
}
port=$(free_port)
head -c 1024 /dev/urandom >"$run/munge/munge.key"
chmod 700 "$run/munge"
chmod 400 "$run/munge/munge.key"
# As root, in the test's own folders: munged warns of both.
munged --force --key-file="$run/munge/munge.key" --socket="$run/munge/socket" --pid-file="$run/munged.pid" \
  --log-file="$run/log/munged.log" --seed-file="$run/munge/seed" 2>"$run/log/munged.err" || fail "no munged: $(<"$run/log/munged.err")"
cat >"$run/slurm.conf" <<CONF
ClusterName=test$port
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$run/munge/socket
CredType=cred/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation=$run/state
SlurmdSpoolDir=$run/spool
SlurmctldPidFile=$run/slurmctld.pid
SlurmdPidFile=$run/slurmd.pid
SlurmctldLogFile=$run/log/slurmctld.log
SlurmdLogFile=$run/log/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
KillWait=2
MinJobAge=300
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=test Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$run/slurm.conf
slurmctld -f "$SLURM_CONF" && slurmd -f "$SLURM_CONF" || fail "no slurm: $(tail -n 5 "$run"/log/*.log)"
for _ in $(seq 100); do
  [ "$(sinfo --noheader --format=%T 2>/dev/null)" = idle ] && break
  sleep 0.2
done
[ "$(sinfo --noheader --format=%T)" = idle ] || fail "no idle node: $(sinfo) $(tail -n 5 "$run"/log/*.log)"

# The study: enough that a task can be met while it runs.
study=(slim2023 --set runs=24 --set path.points=6 --set stop.iterations=1000 --set population=20)
mkdir bin "two words"
ln -s "$program" bin/ikbench
export PATH=$work/bin:$PATH
submit() {
  local array
  array=$(sbatch --parsable "$scripts/../../docs/examples/slurm.sbatch" "two words" "${study[@]}") || fail "no array"
  sbatch --parsable --dependency="afterany:$array" --job-name=merge --output=merge.txt \
    --wrap "ikbench merge 'two words' 'two words/shards' && ikbench report 'two words/store.sqlite'" >merge.id || fail "no merge"
}
states() {
  squeue --noheader --array --format="%K %T"
}
# Waits until all jobs have ended; a task that was requeued waits for a moment that Slurm chooses, so it is let go.
wait_for_all() {
  local job
  for _ in $(seq 1800); do
    [ -n "$(squeue --noheader)" ] || return 0
    for job in $(squeue --noheader --array --states=PENDING --format="%i %r" | awk '$2 == "BeginTime" { print $1 }'); do
      scontrol update jobid="$job" starttime=now 2>/dev/null
    done
    sleep 0.2
  done
  fail "jobs do not end: $(squeue) $(tail -n 20 "$run"/log/*.log)"
}

submit
# Two running tasks are cancelled, two are killed; the killed ones are queued again.
cancelled=0 killed=0
while [ $cancelled -lt 2 ] || [ $killed -lt 2 ]; do
  [ -n "$(squeue --noheader --name=slurm.sbatch)" ] || fail "the tasks ended before they could be met: $(cat slurm-*.txt)"
  task=$(states | awk '$2 == "RUNNING" && $1 ~ /^[0-9]+$/ { print $1; exit }')
  if [ -n "$task" ] && [ $killed -le $cancelled ]; then
    pid=$(pgrep -f -- "--shard $task/12 --out two words" | head -n 1)
    [ -z "$pid" ] || { kill -9 "$pid" && killed=$((killed + 1)) && echo "killed task $task"; }
  elif [ -n "$task" ]; then
    job=$(squeue --noheader --array --states=RUNNING --name=slurm.sbatch --format=%i | head -n 1)
    scancel "$job" 2>/dev/null  # which may have ended meanwhile
    for _ in $(seq 20); do [ -n "$(squeue --noheader --array --jobs="$job" --states=RUNNING,COMPLETING 2>/dev/null)" ] || break; sleep 0.2; done
    scontrol --oneliner show job "$job" 2>/dev/null | grep -q "JobState=CANCELLED" &&
      cancelled=$((cancelled + 1)) && echo "cancelled task $job"
  fi
  sleep 0.3
done
wait_for_all
grep -q "Killed" slurm-*.txt || fail "no task was killed: $(cat slurm-*.txt)"
grep -q "lacks" merge.txt || fail "merge does not say what is missing: $(<merge.txt)"
[ ! -e "two words/report.md" ] || fail "a report of an incomplete study"

# Cancelled tasks are submitted again.
submit
wait_for_all
has "$(<merge.txt)" "Report: "
succeeds run "${study[@]}" --out one --no-report
[ "$("$program" export "two words/store.sqlite" --format fingerprint)" = "$("$program" export one/store.sqlite --format fingerprint)" ] || fail "another fingerprint than one machine"
[ "$(solves "two words/store.sqlite")" = 864 ] || fail "864 solves expected" # 6 solvers x 24 runs x 6 points
exit 0

#!/usr/bin/env bash
# archive.sh [STORE [END]]: makes results/published/libraries, what `ikbench run --beside libraries` shows without installing
# a library, of the studies libraries-ARM-END (warm) of a store (out/libraries/store.sqlite). Of each pose an answer's
# status (empty: ok), errors, joint motion, time and, where ikbench counted them, evaluations; a library stands in the first
# row of its own.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")") store=${1:-out/libraries/store.sqlite} end=${2-warm}
out=$here/../../results/published/libraries
names=$(printf ", 'libraries-%s${end:+-$end}'" franka_panda kuka_iiwa14 ur5e)
arms="study IN (${names:2}) AND label NOT IN ('nothing', 'KDL (Newton), one start')"
ask() { sqlite3 -readonly -csv "$store" "$1" | tr -d '\r'; }
{
  echo key,value
  ask "SELECT key, iif(type = 'object', replace(json_remove(value, '\$.targets'), ':', '='), value)
    FROM (SELECT definition FROM studies WHERE name IN (${names:2}) LIMIT 1), json_each(definition)
    WHERE key NOT IN ('name', 'title', 'robot', 'analysis', 'arm', 'departures', 'figures', 'points', 'initial_deg')
      AND value <> '' ORDER BY key"
  echo 'initial_deg,[]'
} >"$out/settings.csv"
versions="CASE label WHEN 'LM' THEN 'levenberg_marquardt'"  # by label: what answers
while IFS=, read -r label process; do  # its program says the version that is installed
  said=$(cd "$here" && $process </dev/null 2>/dev/null) || { echo "archive.sh: $label's program does not start" >&2; exit 2; }
  versions+=" WHEN '$label' THEN '$label $(sed -n 's/.*"version": *"\([^"]*\)".*/\1/p' <<<"$said" | head -1)'"
done < <(ask "SELECT DISTINCT label, json_extract(options, '\$.process') FROM series WHERE $arms AND label <> 'LM'" | tr -d '"')
for arm in franka_panda kuka_iiwa14 ur5e; do
  echo library,version,month,run,status,error_um,rotation_urad,motion_deg,time_us,evaluations >"$out/$arm.csv"
  ask "SELECT iif(before = label, '', label), iif(before = label, '', $versions END),
      iif(before = label, '', strftime('%m/%Y', began)), run, iif(status = 'ok', '', status),
      iif(stays, '', round(position_error_cm * 1e4, 3)), iif(stays, '', round(2e6 * asin(orientation_error * sqrt(0.375)), 3)),
      iif(stays, '', round(variation_deg, 1)), iif(us < 100, round(us, 2), cast(round(us) AS int)),
      iif(counted_by = 'ikbench', evaluations, '')
    FROM (SELECT *, status IN ('crashed', 'timed_out', 'protocol_error', 'declined', 'over_budget') AS stays,
      1e6 * iif(seconds <> wall_seconds, seconds, cpu_seconds) AS us, lag(label) OVER (ORDER BY label, run) AS before,
      sum(status <> 'declined') OVER (PARTITION BY label) AS answers FROM current_solves WHERE $arms AND robot = '$arm')
      JOIN sessions ON sessions.id = session
    WHERE answers > 0 ORDER BY label, run" | sed 's/""//g' >>"$out/$arm.csv"
done
sqlite3 -readonly "$store" "SELECT DISTINCT key, value FROM environment WHERE key IN ('cpu', 'cpus', 'os', 'version')
  UNION SELECT 'date', date(min(began)) FROM sessions" >"$out/machine.txt"
wc -c "$out"/*

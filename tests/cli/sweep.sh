#!/usr/bin/env bash
# A sweep over keys of a study: one store, one table, and the same report from the store.
source "$(dirname "$0")/common.sh"

sweep=(run --only "LM,PSO" --set runs=12 --set rounds=1 --set stop.evaluations=500 --figures none)
studies() { sqlite3 -readonly "$1" 'SELECT group_concat(name, "; ") FROM (SELECT name FROM studies ORDER BY position)'; }

# By arms: the report of the store is that of the run.
store=out/any-arm-by-robot/store.sqlite
succeeds "${sweep[@]}" --sweep robot=ur5e,puma560
screen=$out
has "$screen" "On ur5e and puma560, PSO is worse than LM"
equal "studies" "$(studies $store)" "any-arm robot=ur5e; any-arm robot=puma560"
equal "columns" "$(head -n 1 out/any-arm-by-robot/tables/studies.csv | tr , '\n' | grep -c low)" 2
succeeds report $store --figures none
equal "screen of the store" "$out" "$screen"
succeeds report $store --figures none --json
json '[of_one["name"] for of_one in of["studies"]] == ["ur5e", "puma560"] and of["keys"] == ["robot"]'
json 'of["studies"][0]["study"] == "any-arm robot=ur5e"'

# One of its studies by itself; what needs one study asks which.
succeeds report $store --study "any-arm robot=ur5e" --figures none --out one
succeeds verify $store
equal "studies that are verified" "$(grep -c '^any-arm robot=.*: errors' <<<"$out")" 2
succeeds verify $store --study "any-arm robot=puma560"
refused "--study 'any-arm robot=ur5e'" run $store --out again
succeeds run $store --study "any-arm robot=ur5e" --out again --no-report
equal "studies of it again" "$(studies again/store.sqlite)" "any-arm robot=ur5e"

# Other values replace it, and solve only what is missing.
succeeds "${sweep[@]}" --sweep robot=puma560,franka_panda --no-report
has "$out" "(24 were already stored)"
equal "studies afterwards" "$(studies $store)" "any-arm robot=puma560; any-arm robot=franka_panda"

# By a number and an option: columns and rows. A requirement is checked in each study.
ends 3 "${sweep[@]}" --robot ur5e --sweep near_deg=1,10,45 --set start=near --sweep LM.damping=1,0.1 --require PSO.solved=95%
has "$out" "PSO solved 0 of 12 targets: at least 95 % is not met"
equal "rows" "$(cut -d, -f1 out/ur5e-by-near_deg/tables/studies.csv | sort | tr '\n' ' ')" "LM damping=0.1 LM damping=1 PSO solver "
if can gnuplot; then
  succeeds report out/ur5e-by-near_deg/store.sqlite
  [ -s out/ur5e-by-near_deg/figures/sweep-solved.svg ] || fail "no figure of the sweep"
fi

# Parts of a sweep are merged.
for part in 1 2; do succeeds "${sweep[@]}" --sweep robot=ur5e,puma560 --shard $part/2 --out parts/$part; done
succeeds merge whole parts
succeeds report whole/store.sqlite --figures none
equal "headline of the merged parts" "$(head -n 1 <<<"$out")" "$(head -n 1 <<<"$screen")"

# Mistakes are refused before anything is solved.
refused "there is no file" "${sweep[@]}" --sweep robot=ur5e,nothing.urdf --out bad
refused "unknown" "${sweep[@]}" --sweep robot=ur5e,ur5f --out bad
refused "leave one of them out" "${sweep[@]}" --robot ur5e --sweep robot=ur5e,puma560 --out bad
refused "--beside" "${sweep[@]}" --sweep robot=ur5e,puma560 --beside libraries --out bad
refused "given twice" "${sweep[@]}" --robot ur5e --sweep near_deg=1,1 --out bad
[ ! -e bad ] || fail "a refused sweep wrote into its folder"

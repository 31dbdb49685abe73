#!/usr/bin/env bash
# Everything that can be named is listed, and everything listed can be looked at.
source "$(dirname "$0")/common.sh"

for kind in solvers robots studies paths columns metrics instruction-sets; do
  succeeds list $kind
  [ -z "$err" ] || fail "list $kind wrote to the standard error: $err"
  quiet
  names=$(tail -n +2 .out | cut -d' ' -f1)
  [ -n "$names" ] || fail "list $kind is empty"
  for name in $names; do
    succeeds list $kind "$name"
    has "$out" "$name"
    quiet
  done
done

succeeds list solvers
for name in ik_bat bat differential_evolution particle_swarm k_artificial_bee_colony multi_objective_swarm; do
  has "$out" "$name" # the six of the paper
done

succeeds list solvers ik_bat
has "$out" "Slim et al. 2023"
for option in alpha gamma loudness pulse_rate acceptance bounds; do
  has "$out" $'\n'"$option "
done

succeeds list robots kuka_iiwa14
for length in 0.36 0.42 0.4 0.126; do # the manufacturer's, docs/paper-notes.md 1
  has "$out" "  $length  "
done
has "$out" "170"

# Every column of an export is listed.
succeeds run slim2023 "${small[@]}" --no-report --out made
succeeds list columns
columns=$out
succeeds export made/store.sqlite
for column in $(head -n 1 .out | tr , '\n' | sed -E 's/_[0-9]+$//' | sort -u); do
  has "$columns" $'\n'"$column "
done

# A listed study is a study file.
for study in slim2023 slim2023-time slim2023-dobot slim2023-limits slim2023-bounds slim2023-elongation slim2023-context slim2023-all-joints; do
  succeeds list studies $study
  cp .out $study.toml
  succeeds run $study.toml "${small[@]}" --no-report --out "from-$study"
  succeeds list studies $study.toml
  cmp .out $study.toml || fail "the listed study, listed again, is another"
done

# So does its plan of analysis.
succeeds list studies slim2023
for line in "[analysis]  # how" "test = 'by_design'  # by_design | bootstrap | tamhane | kruskal_wallis: " \
  "significance = 0.05  # significance level of a test" "margin_percent = 5  # smallest relative difference that matters" "unit = 'run'  # run | point: " \
  "estimands = ['mean', 'typical', 'reliability']  # mean | typical | reliability: " "within_cm = 0.01  # "; do
  has "$out" $'\n'"$line"
done

# Keys come with their meaning, a solver's own population too.
succeeds list studies slim2023-time
for line in "start = 'initial'  # previous | initial | middle | random | near: a solve starts" "limits = 'recorded'  # recorded | enforced: " \
  "kind = 'random'  # helix | circle | random | poses" "population = 12  # overrides the population of the study"; do
  has "$out" $'\n'"$line"
done

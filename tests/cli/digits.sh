#!/usr/bin/env bash
# A published table to the last digit, its first targets with every instruction set of this machine; and what last bits
# change.
source "$(dirname "$0")/common.sh"

succeeds run haviland2023-part2 --jobs 2 --no-report --out table
has "$("$program" fingerprint table/store.sqlite)" "$(grep '"haviland2023-part2"' "$scripts/../../results/reference.inc" | cut -d'"' -f4)"
for set in $("$program" list instruction-sets | tail -n +2 | cut -d' ' -f1); do
  IKBENCH_INSTRUCTION_SET=$set succeeds run haviland2023-part2 --set path.points=500 --jobs 2 --no-report --out "$set"
  "$program" fingerprint "$set/store.sqlite" >>first
done
[ "$(sort -u first | wc -l)" = 1 ] || fail "instruction sets give other numbers: $(<first)"

succeeds report table/store.sqlite --no-figures --out digits
rows=digits/tables/rows-part2-ur5.md
has "$(grep '^| Chan 0.1 ' $rows)" "| every digit | 15.52 (printed 15.52) | 8 (printed 8) | 0 (printed 0) | 1.21 (printed 1.21) | 14 (printed 14) |"
has "$(grep '^| Sugihara 1e-4 ' $rows)" "| every digit | 21.89 (printed 21.89) | 13 (printed 13) | 0 (printed 0) | 1.27 (printed 1.27) | 19 (printed 19) |"
has "$(grep '^| QP ' $rows)" "not attempted: it needs a solver of quadratic programs"
has_no "$(<digits/report.md)" "last-bits"

# Copies are solved, sharded and merged like all solves; who solves again changes nothing.
cat >mine.toml <<'TOML'
name = "mine"
robot = "planar_3"
search = "all_joints"
start = "random"
runs = 4
repeats = 1
[path]
kind = "random"
points = 5
[stop]
iterations = 50
tolerance_cm = 0.01
[[solvers]]
solver = "damped_least_squares"
[[solvers]]
solver = "particle_swarm"
TOML
succeeds run mine.toml --perturb 2 --no-figures --out mine
has "$(<mine/report.md)" "Last bits of the targets, changed 2 times."
grep -q '^| damped_least_squares | position error' mine/tables/last-bits.md || fail "no row of last bits"
for part in 1 2; do succeeds run mine.toml --perturb 2 --shard $part/2 --out shard-$part; done
succeeds merge merged shard-1 shard-2
"$program" fingerprint mine/store.sqlite >whole
"$program" fingerprint merged/store.sqlite | cmp - whole || fail "shards of copies give others"
[ "$(wc -l <whole)" -eq 3 ] || fail "expected a study and two copies: $(<whole)"
[ "$(cut -d' ' -f1 whole | sort -u | wc -l)" -eq 3 ] || fail "copies are equal: $(<whole)"
refused "101" run mine.toml --perturb 101

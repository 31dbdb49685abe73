#!/usr/bin/env bash
# A library that changes how the processor rounds, while it is loaded or called, changes no bit of what other solvers answer.
#
#   rounding.sh PROGRAM OTHER_ROUNDING
source "$(dirname "$0")/common.sh"
rounding=$(realpath "$2")
study rounding '[[solvers]]' 'solver = "particle_swarm"' 'label = "PSO"'
whens=(load)
if "$program" list solvers | grep -q '^newton_slsqp'; then
  printf '[[solvers]]\nsolver = "newton_slsqp"\nlabel = "other"\n' >>rounding.toml
  whens+=(nlopt_create nlopt_optimize nlopt_destroy)
else
  echo "skipped in part: no NLopt"
fi
others() { numbers "$1/store.sqlite" | grep -v ',other,'; }
succeeds run rounding.toml --no-report --out plain
others plain >plain.csv
for when in "${whens[@]}"; do
  IKBENCH_ROUNDS=$when LD_PRELOAD=$rounding "$program" run rounding.toml --no-report --out "$when" >.out 2>.err || fail "$when: $(<.err)"
  others "$when" | cmp - plain.csv || fail "$when changes bits of other solvers"
done
succeeds verify load/store.sqlite

#!/usr/bin/env bash
# In a system where the package is installed, and nothing of the source (docs/package --try): what a user does first.
set -euo pipefail
export LC_ALL=C.UTF-8 HOME=/tmp/home
mkdir -p "$HOME/work"
cd "$HOME/work"
ikbench --version
ikbench reproduce --quick --out reproduced | tail -n 5
test -s reproduced/report.html && test -s reproduced/figures/figure-10.svg
ikbench reproduce --out whole | tail -n 5
test -s whole/report.html && test -s whole/tables/multiverse.csv
ikbench run slim2023 --set runs=4 --set path.points=3 --set stop.iterations=50 --no-report --out before | tail -n 1
ikbench run slim2023 --set runs=4 --set path.points=3 --set stop.iterations=50 --set seed=2 --no-report --out after | tail -n 1
ikbench compare before/store.sqlite after/store.sqlite | sed -n 1p
ikbench new mine.toml --like slim2023 --without-paper
gate() { STUDY=mine.toml BASELINE=baseline.sqlite OUT=$1 bash /usr/share/doc/ikbench/cli/gate.sh >"$1.txt"; }
sed -i 's/^runs = .*/runs = 5/; s/^points = .*/points = 3/; s/^iterations = .*/iterations = 50/' mine.toml
gate first && cp first/store.sqlite baseline.sqlite && gate again && test -s again/verdict.md
sed -i 's/^iterations = .*/iterations = 2/' mine.toml
code=0; gate worse || code=$?
test "$code" = 3 && echo "gate: green of equal solvers, red of worse ones"
examples=/usr/share/doc/ikbench/docs/examples
ikbench check-solver -- python3 "$examples/pso.py" | tail -n 3
man ikbench | grep SYNOPSIS >/dev/null
man ikbench-compare | grep SYNOPSIS >/dev/null
PYTHONPATH=/usr/share/ikbench/python python3 -c 'import ikbench; print(len(ikbench.Store("before").solves()), "solves read in Python")'
bash -c 'source /usr/share/bash-completion/completions/ikbench
  COMP_WORDS=(ikbench comp) COMP_CWORD=1; _ikbench; [[ ${COMPREPLY[*]} == compare ]]'
echo "package: works"

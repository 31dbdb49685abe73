#!/usr/bin/env bash
# Functions of a Python process as solvers (ikbench.study of ikbench.py and ikbench_notebook.py), without pandas; with it:
# install.sh. The cells of docs/examples/notebook.ipynb.
source "$(dirname "$0")/common.sh"
mkdir bin temporary
ln -s "$program" bin/ikbench
export PATH=$work/bin:$PATH TMPDIR=$work/temporary PYTHONPATH=$root/solvers/helpers PYTHONDONTWRITEBYTECODE=1
python3 "$scripts/notebook.py" "$root/solvers/helpers" >.out 2>.err || fail "$(<.out) $(<.err)"
equal "temporary folders that stay" "$(ls temporary | wc -l)" 1  # of the function that did not return, as it says
[ -z "$(pgrep -f "$work/temporary" || true)" ] || fail "a process stays"
python3 "$scripts/cells.py" "$root/docs/examples/notebook.ipynb" >.out 2>.err || fail "the notebook: $(<.out) $(<.err)"
has "$(<.out)" "<td>LM</td>"

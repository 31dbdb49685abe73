# The examples of docs/solvers-in-any-language.md, each in a study beside a built-in solver; one without its interpreter or
# compiler is left out by name.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
examples=$(realpath "$scripts/../../docs/examples")
cp "$examples"/* .

entries=() labels=() left_out=()
add() { # add LABEL "quoted", "words"
  entries+=("$(printf '[[solvers]]\nlabel = "%s"\nprocess = [%s]\n' "$1" "$2")")
  labels+=("$1")
}
if command -v python3 >/dev/null; then add pso.py '"python3", "pso.py"'; else left_out+=(pso.py); fi
scipy=
for python in python3 /usr/bin/python3; do
  "$python" -c "import scipy" 2>/dev/null && scipy=$python && break
done
if [ -n "$scipy" ]; then add least_squares.py "\"$scipy\", \"least_squares.py\""; else left_out+=(least_squares.py); fi
if command -v octave-cli >/dev/null; then add damped.m '"octave-cli", "--quiet", "damped.m"'; else left_out+=(damped.m); fi
if cc -O2 -Wall -Wextra -Werror -o search search.c 2>cc.err; then add search.c '"./search"'; else left_out+=(search.c); fi
if c++ -std=c++17 -O1 -I/usr/include/eigen3 -o descent descent.cpp 2>cc.err; then add descent.cpp '"./descent"'; else left_out+=(descent.cpp); fi
for name in "${left_out[@]}"; do echo "left out: $name"; done
[ ${#entries[@]} -gt 0 ] || exit 77
for file in "$examples"/*; do
  [ "$(wc -l <"$file")" -lt 60 ] || fail "$file has 60 lines or more"
done

{
  printf 'name = "examples"\nsearch = "all_joints"\nrobot = "ur5e"\nstart = "near"\nnear_deg = 10\nruns = 2\nrepeats = 1\n'
  printf '[path]\nkind = "random"\npoints = 3\n[stop]\niterations = 60\ntolerance_cm = 0.5\n[[solvers]]\nsolver = "damped_least_squares"\n'
  printf '%s\n' "${entries[@]}"
} >examples.toml
succeeds run examples.toml --no-report --out out
"$program" export out/store.sqlite >solves.csv
for label in "${labels[@]}"; do
  solved=$(awk -F, -v solver="$label" '
    NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
    $column["solver"] == solver && $column["status"] == "ok" { ++solved } END { print solved + 0 }' solves.csv)
  # Near a solution those with slopes find it, and those that try at random at least once.
  [[ $label == pso.py || $label == search.c ]] && least=1 || least=4
  [ "$solved" -ge $least ] || fail "$label solves $solved of 6; it said: $err"
done
has_no "$err" "last failure"

# Examples with their own loop keep a budget of time: without it they would be given up.
sed -e 's/iterations = 60/iterations = 1000000\nseconds = 0.05/; s/tolerance_cm = 0.5/tolerance_cm = 0/' \
  -e 's/name = "examples"/name = "budget"/; s/points = 3/points = 1/' examples.toml >budget.toml
succeeds run budget.toml --no-report --out budget
has_no "$("$program" export budget/store.sqlite)" timed_out
echo "examples: all right"

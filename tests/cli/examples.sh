#!/usr/bin/env bash
# Every file of docs/examples and each helper does what the page that shows it says.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
examples=$root/docs/examples helpers=$root/solvers/helpers
cp "$root/tests/data/urdf/ur5e.urdf" .
for file in "$examples"/* "$helpers"/*; do
  [[ $file == */__pycache__ ]] || grep -rqF "$(basename "$file")" "$root"/tests/{cli,solvers} || fail "no test of $(basename "$file")"
done

# The examples of docs/reference/protocol.md, below 50 lines each, find solutions that are near, and pass their
# checks.
cp "$helpers"/ikbench{.py,_program.hpp} "$examples"/{pso.py,descent.py,damped.m,search.cpp} .
entries=()
add() {
  [ "$(wc -l <"$1")" -lt 50 ] || fail "$1 has 50 lines or more"
  entries+=("$(printf '[[solvers]]\nlabel = "%s"\nprocess = [%s]\n' "$1" "$2")")
  succeeds check-solver --timeout 20 -- "${@:3}"
}
add pso.py '"python3", "pso.py"' python3 pso.py
add descent.py '"python3", "descent.py"' python3 descent.py
! can octave-cli || add damped.m '"octave-cli", "--quiet", "damped.m"' octave-cli --quiet damped.m
if can c++; then
  c++ -std=c++17 -O2 -Wall -Wextra -Werror -o search search.cpp 2>cc.err || fail "search.cpp: $(<cc.err)"
  add search.cpp '"./search"' ./search
fi
study examples "${entries[@]}"
sed -i 's/^robot = .*/robot = "ur5e"/; s/^runs = .*/&\nstart = "near"\nnear_deg = 10/; s/points = 8/points = 3/; s/^iterations = 8/iterations = 60\ntolerance_cm = 0.5/' examples.toml
succeeds run examples.toml --no-report --out examples
for of in pso.py:1 search.cpp:1 descent.py:4 damped.m:4; do # the first two try at random
  label=${of%:*}
  [[ "${entries[*]}" != *$label* ]] || [ "$(column examples/store.sqlite status $label | grep -cx ok)" -ge ${of#*:} ] ||
    fail "$label: $(column examples/store.sqlite status $label | counted)"
done

python3 "$scripts/helper.py" "$helpers" || fail "ikbench.py tells other than it should"

# ikbench_program.hpp reads JSON, refuses what is none, and writes nothing that is none.
cat >hostile.cpp <<'CPP'
#include "ikbench_program.hpp"
int main(int, char** arguments) try {
  const ikbench::Json of = ikbench::Json::of(arguments[1]);
  if (of["text"].text == "none") ikbench::run("none", {}, [](const ikbench::Robot& robot) { return robot; },
      [](ikbench::Robot&, ikbench::Problem&) -> ikbench::Values { return {}; });
  ikbench::say(ikbench::json_of(of["text"].text) + ikbench::json_of(of["list"].numbers()));
  ikbench::say(ikbench::json_of(ikbench::inside({2.0000006, 2.0000008, 5, 9}, {1, 1, 1, 0}, {-2, -2, -2, -2}, {2, 2, 2, 2})));
} catch (const std::runtime_error& wrong) {
  ikbench::say(wrong.what());
}
CPP
if can c++; then
  c++ -std=c++17 -fsanitize=address,undefined -fno-sanitize-recover=all -o hostile hostile.cpp 2>cc.err ||
    { echo "skipped in part: no sanitizers of c++"; c++ -std=c++17 -o hostile hostile.cpp; } || fail "hostile.cpp"
  equal "what it read" "$(./hostile '{ "list" : [1, null,-25e-2,true ], "text":"a\"\\\u001f/é", "rest": [{}, []] }' | head -n 1)" \
    '"a\"\\ /  "[1,null,-0.25,1]'
  json '[round(x, 9) for x in of] == [2, 2.0000008, -1.283185307, 9]' <(./hostile '{}' | tail -n 1)
  for wrong in '' '{' '{"a"' '{"a":' '{"a":1' '{"a":1,}' '[1,]' '["a' '["a\' '["\u12' '["\q"]' '[nul]' '{]' '[}' '[-]' '[1 2]' x; do
    equal "what it says of $wrong" "$(./hostile "$wrong" 2>&1)" "a line that is not JSON"
  done
  # A library that finds nothing has answered: the arm stays, and its solves are not lost.
  study none "$(printf '[[solvers]]\nlabel = "none"\nprocess = ["./hostile", "{\\"text\\":\\"none\\"}"]\n')"
  succeeds run none.toml --no-report --out none-of-it
  equal "solves of none" "$(column none-of-it/store.sqlite status none | counted)" "16 ok"
fi

# A library: by the Python that has it.
kdl=
for python in python3 /usr/bin/python3; do
  $python -c 'import PyKDL' 2>/dev/null || continue
  cp "$root/solvers/programs/kdl.py" .
  succeeds check-solver --timeout 20 -- $python kdl.py
  study library "$(printf '[[solvers]]\nlabel = "KDL"\nprocess = ["%s", "kdl.py"]\n' "$python")"
  library=(run library.toml --no-report --set robot=ur5e.urdf --set search=pose --set start=near --set stop.iterations=100
    --set stop.tolerance_cm=0.01 --set stop.tolerance_deg=0.1)
  succeeds "${library[@]}" --out library
  equal "solves of a library" "$(column library/store.sqlite status KDL | counted)" "16 ok"
  refused "solves for pose" "${library[@]}" --set search=axis
  kdl=yes
  break
done
[ -n "$kdl" ] || echo "skipped in part: no PyKDL"

# Each program around a library pins its version, and a study of libraries has it.
for file in "$root"/solvers/programs/with_*.{py,cpp}; do
  grep -qE '^(# dependencies|// source) = .*==|^// flags = -lorocos-kdl$' "$file" || fail "$file pins no version"
  grep -qE "[\"/]$(basename "$file")[\"/]" "$root"/solvers/programs/libraries*.toml || fail "no study has $file"
done

# A path from a program that writes poses, as a CSV.
python3 "$root/docs/examples/rectangle.py" >rectangle.csv
sed -e 's/robot = .*/robot = "ur5e.urdf"\nruns = 2\ninitial_deg = [0, -90, 90, -90, -90, 0]\nstop = { iterations = 100, tolerance_cm = 0.001, tolerance_deg = 0.01 }/' \
  -e 's/all_joints/pose/; s/kind = .*/kind = "csv"\nfile = "rectangle.csv"/' "$scripts/studies/my_study.toml" >rectangle.toml
succeeds run rectangle.toml --figures none --out rectangle --json
json '[(row["n"], row["mean"]) for row in of["groups"] if row["metric"] == "targets solved"] == [(1, 100)]'
equal "solves of the rectangle" "$(solves rectangle/store.sqlite)" 62

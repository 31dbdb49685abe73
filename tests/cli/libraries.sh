#!/usr/bin/env bash
# What reads a store of libraries, and what the helpers of programs do with answers outside the limits.
source "$(dirname "$0")/common.sh"

# Who solves, and who answers otherwise when asked again.
sqlite3 store.sqlite "CREATE TABLE current_solves (study, robot, label, run, point, status, answer_rad)"
while read -r robot label run status one two; do
  for state in one two; do
    study=libraries-$robot
    [[ $state == one ]] || study+=-hot
    sqlite3 store.sqlite "INSERT INTO current_solves VALUES ('$study', '$robot', '$label', $run, 1, '$status', '[${!state}]')"
  done
done <<'END'
ur5e A 1 ok 1 1
ur5e A 2 tolerance_missed 1 2
ur5e B 1 ok 1 2
ur5e B 2 ok 1 1
puma560 A 1 declined 1 1
puma560 B 1 ok 1 1
ur5e nothing 1 ok 1 1
END
equal "who solves" "$(sqlite3 store.sqlite <"$root/solvers/programs/who.sql" | paste -sd' ')" "B|||2|2|2|2|0 A|||1|1|1|0|1"
equal "who answers otherwise" "$(sqlite3 store.sqlite <"$root/solvers/programs/again.sql")" "libraries-ur5e|B|1|2"

# What is 7e-7 rad outside the limits, as single precision costs, comes inside; by both helpers.
cp "$root"/docs/examples/ikbench{.py,_program.hpp} .
inside='[round(x, 9) for x in of] == [2, 2.0000008, -1.283185307, 9]'
json "$inside" <(python3 -c 'import ikbench; print(ikbench.inside([2.0000006, 2.0000008, 5, 9], [1, 1, 1, 0], [-2] * 4, [2] * 4))')
cat >inside.cpp <<'CPP'
#include "ikbench_program.hpp"
int main() { ikbench::say(ikbench::json_of(ikbench::inside({2.0000006, 2.0000008, 5, 9}, {1, 1, 1, 0}, {-2, -2, -2, -2}, {2, 2, 2, 2}))); }
CPP
can c++ && { c++ -std=c++17 -o inside inside.cpp && json "$inside" <(./inside); }
exit 0

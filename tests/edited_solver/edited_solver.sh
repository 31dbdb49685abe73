#!/usr/bin/env bash
# A solver whose file was changed is solved anew, and no other; what it solved before stays, and is current again for the
# program that solved it. edited_solver.sh PROGRAM EDITED
source "$(dirname "$0")/../cli/common.sh"
original=$program
edited=$(realpath "$2")

run=(run slim2023 "${small[@]}" --no-report --out store)
# numbers_of LABEL: the solves of one solver, without what every run and every source have otherwise.
numbers_of() { numbers store/store.sqlite | grep ",$1," | sed -E 's/,[0-9a-f]{16}@[0-9a-f]{16},/,/'; }

succeeds "${run[@]}"
[ -z "$(grep -v 'debug build' .err)" ] || fail "a new store gives a warning: $err"
numbers_of IK-BA >ik-ba.before
numbers_of DE >de.before
before=$("$program" fingerprint store/store.sqlite)

program=$edited
succeeds "${run[@]}"
has "$out" "slim2023: 36 solves in store/store.sqlite (30 were already stored)" # all but IK-BA's 2 runs of 3 points
has "$err" "warning: 6 solves of IK-BA come from another version of the solver or of shared code"
numbers_of IK-BA >ik-ba.after
numbers_of DE | cmp - de.before || fail "a solver that was not edited gives other numbers"
[ "$(wc -l <ik-ba.after)" = 6 ] || fail "IK-BA has $(wc -l <ik-ba.after) current solves, expected 6"
cmp -s ik-ba.before ik-ba.after && fail "the edited solver gives the old numbers"
[ "$("$program" fingerprint store/store.sqlite)" != "$before" ] || fail "other numbers have the same fingerprint"
succeeds "${run[@]}"
has "$out" "(36 were already stored)"
has_no "$err" "another version"

# The solves of before are current again for the program that made them.
program=$original
succeeds "${run[@]}"
has "$out" "(36 were already stored)"
numbers_of IK-BA | cmp - ik-ba.before || fail "the first solves did not come back"
[ "$("$program" fingerprint store/store.sqlite)" = "$before" ] || fail "the same numbers have another fingerprint"

# The program reports what differs, down to the solver.
succeeds "${run[@]/%store/one}"
program=$edited
succeeds "${run[@]/%store/other}"
run_it compare one/store.sqlite other/store.sqlite --metric evaluations
has "$out" "source of the solver ("
[ "$("$original" --version)" != "$("$edited" --version)" ] || fail "--version is the same"
succeeds report other/store.sqlite --no-figures
has "$(<other/tables/environment.csv)" "source.ik_bat,"

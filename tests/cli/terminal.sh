#!/usr/bin/env bash
# Progress is shown on a terminal, and only there.
source "$(dirname "$0")/common.sh"

succeeds run slim2023 "${small[@]}" --no-report --out quiet
quiet
has_no "$err" "solves,"

# In one log with the results, a warning stands on its own line, in the order of the messages.
PATH=/nonexistent "$program" run slim2023 --verbose "${small[@]}" --out logged >.log 2>&1 || fail "no figures: $(<.log)"
grep -q '^warning: ' .log || fail "no warning on a line of its own: $(<.log)"
! grep -q '.warning: ' .log || fail "a warning within a line: $(grep '.warning: ' .log)"
[ "$(grep -n 'cannot start gnuplot' .log | head -n 1 | cut -d: -f1)" -gt "$(grep -n '^slim2023: 36 solves in' .log | cut -d: -f1)" ] ||
  fail "a warning before what was said before it: $(<.log)"
[[ "$(tail -n 1 .log)" == "Report: "* ]] || fail "the report's path is not the last line: $(<.log)"

script -qec true /dev/null >/dev/null 2>&1 </dev/null || exit 77  # no `script`, or no terminal to be had
script -qec "'$program' run slim2023 --set runs=4 --set path.points=5 --set stop.iterations=1000 --no-report --out shown" /dev/null >.shown </dev/null ||
  fail "on a terminal: exit code $?; it said: $(<.shown)"
shown=$(<.shown)
has "$shown" $'\r'
has "$shown" "slim2023 ["
has "$shown" "/120 solves, " # 6 solvers x 4 runs x 5 points
has "$shown" " left"
has "$shown" "slim2023: 120 solves in shown/store.sqlite"
[[ $shown =~ \[[#]+[.]*\] ]] || fail "no bar in: $shown"

# The last thing done with the bar is to wipe it: the result stands alone on its line.
line=$(tr '\r' '\n' <.shown | grep '120 solves in')
[ "${line#$'\e[K'}" = "slim2023: 120 solves in shown/store.sqlite" ] || fail "the result's line is: $line"

# A listed study is a file for a program, and words for a reader: nothing turns the direction of a line on a terminal.
turn=$'\u202e'
printf 'name = "turned"\ntitle = "a%sb"\n[[solvers]]\nsolver = "bat"\n' "$turn" >turned.toml
succeeds list studies turned.toml
has "$out" "$turn"
script -qec "'$program' list studies turned.toml" /dev/null >.shown </dev/null || fail "list studies: $(<.shown)"
has "$(<.shown)" 'a b'
has_no "$(<.shown)" "$turn"

# A name moves no cursor: escapes are not even taken into a study.
printf 'name = "x\\u001b[2J"\n[[solvers]]\nsolver = "bat"\n' >escape.toml
script -qec "'$program' run escape.toml" /dev/null >.shown </dev/null && fail "an escape in a name was taken"
has_no "$(<.shown)" $'\e[2J'
exit 0

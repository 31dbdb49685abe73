# Shared by the tests of the program: a folder that vanishes with the test, and checks that print what they saw.
# Every script takes the path of the program as its argument; exit code 77 means skipped.
set -uo pipefail
export LC_ALL=C.UTF-8 # else, where no locale is set, bash writes $'\u202e' as letters
PATH=/usr/bin:$PATH   # Debian's python3, which has what ./setup installs, and no shim that takes 0.2 s to find another
program=$(realpath "$1")
scripts=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

# run_it ARGUMENTS...: puts the exit code into $code, the output into $out and $err.
run_it() {
  "$program" "$@" >"$work/.out" 2>"$work/.err" </dev/null
  code=$?
  out=$(<"$work/.out") err=$(<"$work/.err")
}

# stopped_after_a_second ARGUMENTS...: a run that is far too long; exit code 130 after SIGINT, its messages in
# stopped.err.
stopped_after_a_second() {
  "$program" "$@" >stopped.out 2>stopped.err &
  local process=$!
  sleep 1
  kill -INT $process || fail "it had ended before it could be stopped: $(<stopped.err)"
  wait $process
  code=$?
  [ "$code" = 130 ] || fail "exit code $code after SIGINT, expected 130: $(<stopped.err)"
}

# succeeds ARGUMENTS...: exit code 0.
succeeds() {
  run_it "$@"
  [ "$code" = 0 ] || fail "ikbench $*: exit code $code, expected 0; it said: $out $err"
}

# refused WORDS ARGUMENTS...: exit code 1, nothing on the standard output, and one sentence that has the words.
refused() {
  local words=$1 line
  shift
  run_it "$@"
  [ "$code" = 1 ] || fail "ikbench $*: exit code $code, expected 1; it said: $out $err"
  [ -z "$out" ] || fail "ikbench $*: wrote to the standard output: $out"
  line=$(sed -e ':a;N;$!ba;s/\n  / /g' "$work/.err" | grep -v '^warning: ') # sentences, which are broken between words
  [ "$(wc -l <<<"$line")" = 1 ] || fail "ikbench $*: not one sentence: $line"
  [[ $line == "ikbench: "* ]] || fail "ikbench $*: does not say who speaks: $line"
  [[ $line == *"$words"* ]] || fail "ikbench $*: expected '$words' in: $line"
}

# flat TEXT: the text in one line, as it was before its lines were broken between words.
flat() { printf %s "$1" | tr -s '\n ' ' '; }

has() {
  [[ $1 == *"$2"* || $(flat "$1") == *"$(flat "$2")"* ]] || fail "expected '$2' in: $1"
}

has_no() {
  [[ $1 != *"$2"* && $(flat "$1") != *"$(flat "$2")"* ]] || fail "expected no '$2' in: $1"
}

# A study that takes little, of the paper's six solvers.
small=(--set runs=2 --set path.points=3 --set stop.iterations=5 --set population=6)

# numbers STORE [STUDY]: the solves of its first study, or of another, as CSV without what differs from one run of the
# program to the next.
numbers() {
  "$program" export "$1" ${2:+--study "$2"} >"$work/.csv" || fail "cannot export $1"
  awk -F, '
    NR == 1 { for (i = 1; i <= NF; ++i) if ($i ~ /^((cpu_|smallest_|largest_)?seconds|repeats|interruptions|timing|session)$/) timed[i] = 1 }
    { for (i = 1; i <= NF; ++i) if (!(i in timed)) printf "%s,", $i; print "" }' "$work/.csv"
}

# solves STORE: the number of its solves.
solves() {
  "$program" export "$1" | tail -n +2 | wc -l
}

# same_fingerprint STORE STORE: and both have one.
same_fingerprint() {
  local first second
  first=$("$program" export "$1" --format fingerprint) && second=$("$program" export "$2" --format fingerprint) || fail "no fingerprint of $1 or $2"
  [ -n "$first" ] && [ "$first" = "$second" ] || fail "another fingerprint: $1 has '$first', $2 has '$second'"
}

# quiet: what went to no terminal has no control characters (colours, cursor moves, carriage returns).
quiet() {
  ! LC_ALL=C grep -q $'[\001-\010\013-\037\177]' "$work/.out" "$work/.err" || fail "control characters in: $out $err"
}

# fits WORDS ARGUMENTS...: what it says is no more than a screen, with the warnings, and begins with the words.
fits() {
  local words=$1 lines columns
  shift
  run_it "$@"
  [ "$code" != 1 ] && [ "$code" != 2 ] || fail "ikbench $*: exit code $code: $err"
  lines=$(cat "$work/.out" "$work/.err" | wc -l) columns=$(cat "$work/.out" "$work/.err" | wc -L)
  [ "$lines" -le 30 ] && [ "$columns" -le 100 ] || fail "ikbench $*: $lines lines of $columns columns: $out $err"
  [[ $(flat "$out") == "$words"* ]] || fail "ikbench $*: expected '$words' first in: $out"
  quiet
}

# as_json EXPRESSION ARGUMENTS...: standard output is JSON, `of`, which the expression holds. Nothing without python3.
as_json() {
  local expression=$1
  shift
  run_it "$@" --json
  [ "$code" != 1 ] && [ "$code" != 2 ] || fail "ikbench $* --json: exit code $code: $err"
  command -v python3 >/dev/null || return 0
  python3 -c "import json, sys; of = json.load(open('$work/.out')); sys.exit(not ($expression))" ||
    fail "ikbench $* --json: not $expression: $out"
}

# study NAME ENTRY...: a study file of two runs of eight points, damped least squares first.
study() {
  local name=$1
  shift
  {
    printf 'name = "%s"\nsearch = "all_joints"\nruns = 2\nrepeats = 1\n' "$name"
    printf '[path]\nkind = "random"\npoints = 8\n[stop]\niterations = 8\n'
    printf '[[solvers]]\nlabel = "DLS"\nsolver = "damped_least_squares"\n'
    printf '%s\n' "$@"
  } >"$name.toml"
}

# column STORE NAME SOLVER: the values of a solver's rows.
column() {
  "$program" export "$1" | awk -F, -v name="$2" -v solver="$3" '
    NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
    $column["solver"] == solver { print $column[name] }'
}

# counted: counts each line of the input.
counted() { sort | uniq -c | sed 's/^ *//'; }

# Shared by the tests of the program: a folder that vanishes with the test, and checks that print what they saw.
# Every script takes the path of the program as its first argument; exit code 77 means skipped.
set -uo pipefail
export LC_ALL=C.UTF-8 # else, where no locale is set, bash writes $'\u202e' as letters
PATH=/usr/bin:$PATH   # Debian's python3, which has what ./setup installs, and no shim that takes 0.2 s to find another
program=$(realpath "$1")
scripts=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
root=$(realpath "$scripts"/../..)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

fail() {
  echo "FAILED: $*" >&2
  exit 1
}
skip() {
  echo "skipped: $*"
  exit 77
}
# is_here TOOL: or a file of TeX.
is_here() { command -v "$1" || { [[ $1 == *.* ]] && kpsewhich "$1"; }; } >/dev/null 2>&1
# needs TOOL...: without one the test is skipped. can TOOL...: without one a part of it is, which says so.
needs() { local tool; for tool in "$@"; do is_here "$tool" || skip "no $tool"; done; }
can() { local tool; for tool in "$@"; do is_here "$tool" || { echo "skipped in part: no $tool"; return 1; }; done; }
for tool in python3 sqlite3 pgrep; do is_here $tool || fail "no $tool; ./setup check installs it"; done

# run_it ARGUMENTS...: puts the exit code into $code, the output into $out and $err.
run_it() {
  "$program" "$@" >"$work/.out" 2>"$work/.err" </dev/null
  code=$?
  out=$(<"$work/.out") err=$(<"$work/.err")
}

# ends CODE ARGUMENTS...
ends() {
  run_it "${@:2}"
  [ "$code" = "$1" ] || fail "ikbench ${*:2}: exit code $code, expected $1; it said: $out $err"
}
succeeds() { ends 0 "$@"; }

# refused WORD ARGUMENTS...: exit code 1, nothing on the standard output, and one sentence that names the word.
refused() {
  local word=$1 sentence
  shift
  ends 1 "$@"
  [ -z "$out" ] || fail "ikbench $*: wrote to the standard output: $out"
  sentence=$(sed -e ':a;N;$!ba;s/\n  / /g' "$work/.err" | grep -v '^warning: ') # lines are broken between words
  [[ $sentence == "ikbench: "*"$word"* && $sentence != *$'\n'* ]] || fail "ikbench $*: expected '$word' in one sentence: $err"
}

# has TEXT WORD
has() { [[ $1 == *"$2"* ]] || fail "expected '$2' in: $1"; }
has_no() { [[ $1 != *"$2"* ]] || fail "expected no '$2' in: $1"; }
# equal WHAT FOUND EXPECTED
equal() { [ "$2" = "$3" ] || fail "$1: $2, expected $3"; }

# looks_in FOLDER FILE: each folder in which the loader looks for the file's libraries before it looks in the system's
# matches the pattern. An empty one is the current folder, which may be anybody's.
looks_in() {
  local dynamic
  dynamic=$(readelf -dW "$2") || fail "cannot read $2"
  ! grep -E 'R(UN)?PATH' <<<"$dynamic" | grep -vE "\[$1(:$1)*\]$" || fail "$2 looks for libraries elsewhere than in '$1'"
}

# json EXPRESSION [FILE]: the file, else what was said last, is JSON, `of`, of which the expression holds.
json() {
  python3 -c 'import json, sys; of = json.load(open(sys.argv[2])); sys.exit(not eval(sys.argv[1]))' "$1" "${2:-$work/.out}" ||
    fail "not $1: $(head -c 600 "${2:-$work/.out}")"
}

# kept NAME: the input is tests/cli/golden/NAME. IKBENCH_GOLDEN=write writes that instead.
kept() {
  if [ "${IKBENCH_GOLDEN:-}" = write ]; then cat >"$scripts/golden/$1"; return; fi
  diff "$scripts/golden/$1" - || fail "other numbers than in golden/$1"
}

# golden NAME [FILE]: what a verdict says as JSON, a line each group, pair and doubt, without times, which no machine
# repeats, is kept.
golden() {
  python3 "$scripts/rows.py" "${2:-$work/.out}" >"$work/.rows" || fail "$1: no verdict: $(head -c 1000 "$work/.out")"
  kept "$1" <"$work/.rows"
}

# A study that takes little, of the paper's six solvers.
small=(--set runs=2 --set path.points=3 --set stop.iterations=5 --set population=6)

# numbers STORE [STUDY]: the solves of its first study, or of another, as CSV without what differs from one run of the
# program to the next.
numbers() {
  "$program" export "$1" ${2:+--study "$2"} | awk -F, '
    NR == 1 { for (i = 1; i <= NF; ++i) if ($i ~ /^((cpu_|wall_)?seconds|batch_size|timing|session)$/) timed[i] = 1 }
    { for (i = 1; i <= NF; ++i) if (!(i in timed)) printf "%s,", $i; print "" }' || fail "cannot export $1"
}

# solves STORE: the number of its solves.
solves() { "$program" export "$1" | tail -n +2 | wc -l; }

# same_fingerprint STORE STORE: and both have one.
same_fingerprint() {
  local first second
  first=$("$program" export "$1" --format fingerprint) && second=$("$program" export "$2" --format fingerprint) || fail "no fingerprint of $1 or $2"
  [ -n "$first" ] || fail "no fingerprint of $1"
  equal "fingerprint of $1" "$first" "$second"
}

# quiet: what went to no terminal has no control characters (colours, cursor moves, carriage returns).
quiet() {
  ! LC_ALL=C grep -q $'[\001-\010\013-\037\177]' "$work/.out" "$work/.err" || fail "control characters in: $out $err"
}

# study NAME ENTRY...: a study file of two runs of eight points, damped least squares first.
study() {
  {
    printf 'name = "%s"\nrobot = "kuka_iiwa14"\nsearch = "all_joints"\nruns = 2\n' "$1"
    printf '[path]\nkind = "random"\npoints = 8\n[stop]\niterations = 8\n'
    printf '[[solvers]]\nlabel = "DLS"\nsolver = "damped_least_squares"\n'
    printf '%s\n' "${@:2}"
  } >"$1.toml"
}

# entry LABEL FAULT [FURTHER KEYS [PATIENCE]]: faulty.py in a study; who answers is not given up, however busy the machine is.
entry() { printf '[[solvers]]\nlabel = "%s"\nprocess = ["python3", "faulty.py", "%s"]\ntimeout_s = %s\n%s\n' "$1" "$2" "${4:-60}" "${3:-}"; }

# column STORE NAME LABEL: the values of a solver's rows.
column() {
  "$program" export "$1" | awk -F, -v name="$2" -v label="$3" '
    NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
    $column["label"] == label { print $column[name] }'
}

# words FOLDER: of its report.md, where a processor's name counts as one.
words() {
  local text cpu
  text=$(<"$1/report.md") cpu=$(sqlite3 "$1/store.sqlite" "SELECT value FROM environment WHERE key = 'cpu' LIMIT 1")
  tr -s '[:space:]' '\n' <<<"${text//"$cpu"/machine}" | grep -c '[[:alnum:]]'
}

# counted: counts each line of the input.
counted() { sort | uniq -c | sed 's/^ *//'; }

# is STUDY LABEL STATUS...: the statuses of its solves, with their counts.
is() {
  local found=$(column "$1/store.sqlite" status "$2" | counted | paste -sd' ')
  [[ $found =~ ^${*:3}$ ]] || fail "$2 in $1: $found, expected ${*:3}"
}
any='([0-9]+ (ok|tolerance_missed|limit_violated) ?)+' # no fault

#!/usr/bin/env bash
# `ikbench trend` finds the version where a solver changed, and no other.
source "$(dirname "$0")/common.sh"
version() {
  succeeds run slim2023 --set runs=10 --set path.points=3 --set population=10 --set seed="$2" --set stop.iterations="$3" \
    --no-report --out "$1"
}
version v1 1 30
version v2 2 30
version v3 3 3
version v4 4 3

succeeds trend v{1,2,3,4}/store.sqlite --label IK-BA --label PSO --out drawn --verbose
has "$out" "Position error of PSO changed in v3: worse by more than 5 % than in v1."
[[ $(tail -n 1 .out) == drawn/trend.* ]] || fail "the last line is no file: $out"
! grep -q ' changed in v[24]:' <<<"$out" || fail "a change where there is none: $out"
[ "$(grep -cE '^(IK-BA|PSO) +v[1-4] ' <<<"$out")" = 8 ] || fail "a row for each label and version: $out"
grep -q '^PSO,v4,.*,v3,' drawn/trend.csv || fail "v4 is not compared with v3: $(<drawn/trend.csv)"
fits "Position error of PSO changed in v3: worse by more than 5 % than in v1." trend v{1,2,3,4}/store.sqlite --label IK-BA --label PSO
as_json 'of["changes"] == [{"label": "PSO", "version": "v3", "is": "worse by more than 5 %", "than_in": "v1"}] and
  [row["version"] for row in of["rows"]] == ["v1", "v2", "v3", "v4"] * 2' trend v{1,2,3,4}/store.sqlite --label IK-BA --label PSO
fits "" trend v{1,2,3,4,1,2,3,4}/store.sqlite
has "$out" "--verbose shows all, and --out FOLDER writes it."
has "$(<drawn/trend.md)" "PSO: v4 differs from v3 in "
has "$(<drawn/trend.gp)" "set logscale y"
succeeds trend v{1,2}/store.sqlite --metric solved --out shares
has_no "$(<shares/trend.gp)" "set logscale y"
! command -v gnuplot >/dev/null || [ -s drawn/trend.svg ] || fail "no figure"

succeeds trend v1/store.sqlite v1/store.sqlite
has "$out" "Position error: no change beyond the margin was found in 2 versions."
has_no "$out" "undecided"
[[ "$(flat "$out")" == *"No other metric than position error was looked at; --metric names another."* ]] || fail "other metrics: $out"
refused "1 stores; expected 2 to 200" trend v1/store.sqlite
refused "unknown label" trend v1/store.sqlite v2/store.sqlite --label none
refused "position_eror_cm" trend v1/store.sqlite v2/store.sqlite --metric position_eror_cm

#!/usr/bin/env bash
# `ikbench site` shows what fits, and names the stores that do not.
source "$(dirname "$0")/common.sh"
for i in {1..8}; do
  succeeds run slim2023 --set runs=3 --set path.points=2 --set stop.iterations=20 --set seed=$i --no-report --out "store-$i"
done
succeeds run arms-ur5 --set runs=3 --no-report --set path.points=1 --out other-study
cp -r store-1 edited-errors && cp -r store-2 impossible-times && cp -r store-3 '<b>&"quoted'
sqlite3 edited-errors/store.sqlite "UPDATE solves SET position_error_cm = 1e-6"
sqlite3 impossible-times/store.sqlite "UPDATE solves SET seconds = 1e-9, cpu_seconds = 1e-9, smallest_seconds = 1e-9,
  largest_seconds = 1e-9"
cp -r store-4 without-digests
sqlite3 without-digests/store.sqlite "UPDATE solves SET digest = 0; DELETE FROM meta WHERE key <> 'schema'"
echo nonsense >none.sqlite

succeeds site store-*/store.sqlite other-study/store.sqlite '<b>&"quoted/store.sqlite' edited-errors/store.sqlite \
  impossible-times/store.sqlite without-digests/store.sqlite none.sqlite --out public --verbose
[[ $out == *" pages of 10 stores, and 4 stores that do not fit"*public/index.html ]] || fail "not the counts and the page: $out"
has "$err" "edited-errors is not shown: Study slim2023: Damaged: "
has "$err" "impossible-times is not shown: Study slim2023: Damaged: "
has "$err" "without-digests is not shown: its digests were removed"
has "$err" "none is not shown:"
fits "" site store-*/store.sqlite edited-errors/store.sqlite impossible-times/store.sqlite none.sqlite --out fitting
[ "$(tail -n 1 .out)" = fitting/index.html ] || fail "the last line is not the page: $out"
as_json 'of["stores"] == 3 and of["page"] == "two/index.html" and [each["store"] for each in of["refused"]] == ["edited-errors", "none"]' \
  site store-1/store.sqlite edited-errors/store.sqlite none.sqlite --out two
has "$err" "edited-errors is not shown: "
index=$(<public/index.html)
has "$index" "every answer fits"
has "$(flat "$(<public/study-slim2023.html)")" "costs ten times the study"
has "$index" "1e-06 is stored"
has "$index" "less than 1 ns an evaluation"
has "$index" 'href="study-slim2023.html"'
has "$index" '&lt;b&gt;&amp;&quot;quoted'
has_no "$index" '<b>&'
[ -s public/solver-ik-ba.html ] || [ -s public/solver-ik-bat.html ] || fail "no page of a solver: $(ls public)"
[ -s public/arm-kuka-iiwa14.html ] || fail "no page of an arm: $(ls public)"
study=$(<public/study-slim2023.html)
has_no "$study" "edited-errors"
has_no "$study" "impossible-times"
has "$study" "comparable with"
for page in public/*.html; do
  ! grep -qE '<script|https?://|src=' "$page" || fail "$page has a script or something from elsewhere"
  for link in $(grep -o 'href="[^"]*"' "$page" | sed 's/href="\(.*\)"/\1/' | sort -u); do
    [ -s "public/$link" ] || fail "$page links to $link, which is not there"
  done
done

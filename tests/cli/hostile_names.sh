#!/usr/bin/env bash
# Names are text, whatever they look like to a shell, a terminal, TeX, Markdown, HTML, CSV, SQL or gnuplot.
source "$(dirname "$0")/common.sh"

name=$'<script>$(touch pwned)`touch pwned`"\''
labels=("\"quoted\", 'single'" '<b>&amp;</b>' '$(touch pwned)`touch pwned`' '100 % | 50 $ \ ~^#_{}&'
  'Gelenkkörper 関節 плечо' '@{/Symbol a} %s %n \n' "'; DROP TABLE solves; --" '../../pwned' '=1+1' 'a  b' '-x' 'A'
  $'turned \u202egnp.exe \u2066x\u2069 \u061cy\u2028z')

{
  escaped=${name//\"/\\\"}
  printf 'name = "%s"\ntitle = "<img src=x> $\\\\alpha$"\nruns = 2\npopulation = 6\n' "$escaped"
  printf '[stop]\niterations = 5\n[path]\npoints = 3\n'
  for label in "${labels[@]}"; do
    escaped=${label//\\/\\\\}
    printf '[[solvers]]\nsolver = "bat"\nlabel = "%s"\n' "${escaped//\"/\\\"}"
  done
} >hostile.toml

mkdir here
(
  cd here || exit 1
  succeeds run ../hostile.toml
  quiet
  has "$out" '<script>'
  [ "$(ls -A)" = out ] || fail "something beside out/ was written: $(ls -A)"
  [ "$(ls -A out | wc -l)" = 1 ] || fail "out/ has: $(ls -A out)"
  folder=$(realpath out/*)
  [[ $(basename "$folder") =~ ^[A-Za-z0-9._-]+$ ]] || fail "the folder is named $(basename "$folder")"
  [ -s "$folder/report.md" ] || fail "no report"
  # What people read has no letter that turns the direction of writing or ends a line.
  turning=$'[\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]'
  found=$(grep -l "$turning" "$work/.out" "$work/.err" "$folder"/report.{md,html} "$folder"/tables/*.{md,tex})
  [ -z "$found" ] || fail "letters that turn the direction of writing in: $found"
  # The page has scripts of its own, on lines that begin with them, and its figures.
  ! sed 's/^<script>//; s/<img class="picture[^"<>]*" alt="[^"<>]*" src="data:image\/svg+xml;base64,[A-Za-z0-9+/=]*">//' \
    "$folder/report.html" | grep '<script>\|<b>\|<img' >/dev/null || fail "the page has HTML of the user's making"
  ! grep -q '<script>\|<b>\|<img' "$folder/report.md" || fail "the report has HTML of the user's making"
  if command -v gnuplot >/dev/null; then
    has_no "$err" "figure"
    [ -s "$folder/figures/error.svg" ] || fail "no figure of the error"
    ! grep -q '<b>\|<script>' "$folder"/figures/*.svg || fail "a figure has HTML of the user's making"
  fi
) || exit 1
[ -z "$(find . -name 'pwned*')" ] || fail "a name was run: $(find . -name 'pwned*')"
[ "$(ls)" = $'here\nhostile.toml' ] || fail "something was written outside: $(ls)"

# The text is intact in what other programs read.
store=(here/out/*/store.sqlite)
succeeds export "${store[0]}"
for label in "${labels[@]}"; do
  quoted=${label//\"/\"\"}
  [[ $out == *",$label,"* || $out == *",\"$quoted\","* ]] || fail "the CSV has no label $label"
done
has "$out" "\"${name//\"/\"\"}\",kuka_iiwa14"
if command -v python3 >/dev/null; then
  succeeds export "${store[0]}" --format json -o export.json
  "$program" export "${store[0]}" -o export.csv || fail "cannot export"
  printf '%s\n' "${labels[@]}" | python3 -c '
import csv, json, sys
labels = sys.stdin.read().split("\n")[:-1]
name = sys.argv[1]
solves = json.load(open("export.json"))["solves"]
rows = list(csv.DictReader(open("export.csv", newline="")))
assert len(solves) == len(rows) == 6 * len(labels), (len(solves), len(rows))
for found in (solves, rows):
    assert {solve["solver"] for solve in found} == set(labels), {solve["solver"] for solve in found} ^ set(labels)
    assert {solve["study"] for solve in found} == {name}
' "$name" || fail "names are not intact in JSON or CSV"
fi

# And the study can be asked for by its name.
succeeds report "${store[0]}" --study "$name" --no-figures --out again
[ -s again/report.md ] || fail "no report of the study by its name"

# Names that are no folder's.
for odd in .. . ../up /abs a/b; do
  printf 'name = "%s"\nruns = 1\npopulation = 2\n[stop]\niterations = 1\n[path]\npoints = 1\n[[solvers]]\nsolver = "bat"\n' \
    "$odd" >odd.toml
  mkdir odd && cd odd || exit 1
  succeeds run ../odd.toml --no-report
  [ "$(ls -A)" = out ] && [ "$(find out -name store.sqlite | wc -l)" = 1 ] || fail "name $odd: $(find .)"
  cd .. && rm -r odd
done
rm -f export.csv export.json  # only where there is a python3 to read them
[ "$(ls)" = $'again\nhere\nhostile.toml\nodd.toml' ] || fail "something else was written: $(ls)"

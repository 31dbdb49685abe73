#!/usr/bin/env bash
# Names are text, whatever they look like to a shell, a terminal, TeX, Markdown, HTML, CSV, SQL or gnuplot.
source "$(dirname "$0")/common.sh"

name=$'<script>$(touch pwned)`touch pwned`"\''
long=$(printf 'long%.0s' {1..50}) # 200 characters, the most
labels=("\"quoted\", 'single'" '<b>&amp;</b>' '<script>pwned</script>' '$(touch pwned)`touch pwned`' '100 % | 50 $ \ ~^#_{}&'
  'Gelenkkörper ψ плечо' '@{/Symbol a} %s %n \n' "'; DROP TABLE solves; --" '../../pwned' '=1+1' 'a  b' '-x' '*'
  $'turned \u202egnp.exe \u2066x\u2069 \u061cy\u2028z\u200bw' "$long")
{
  printf 'name = "%s"\ntitle = "<img src=x> $\\\\alpha$"\nrobot = "kuka_iiwa14"\nruns = 2\npopulation = 6\n' "${name//\"/\\\"}"
  printf '[stop]\niterations = 5\n[path]\nkind = "helix"\npoints = 3\n'
  for label in "${labels[@]}"; do
    escaped=${label//\\/\\\\}
    printf '[[solvers]]\nsolver = "bat"\nlabel = "%s"\n' "${escaped//\"/\\\"}"
  done
} >hostile.toml

mkdir here && cd here || exit 1
succeeds run ../hostile.toml
cp "$work/.out" ../screen
quiet
[ "$(wc -L <../screen)" -le 120 ] && [ "$(wc -l <../screen)" -le 40 ] || fail "not one screen: $out"
equal "beside out/" "$(ls -A)" out
folder=$(realpath out/*)
[[ $(basename "$folder") =~ ^[A-Za-z0-9._-]+$ ]] || fail "the folder is named $(basename "$folder")"
cd ..

# What people read has no letter that turns the direction of writing or ends a line, and no HTML of the user's making.
turning='[\x{61c}\x{200b}-\x{200f}\x{2028}-\x{202e}\x{2066}-\x{2069}]'
grep -qP "$turning" hostile.toml || fail "grep does not see them"
equal "files with letters that turn" "$(grep -lP "$turning" screen "$folder"/report.{md,html} "$folder"/tables/*.tex "$folder"/article/*)" ""
! sed -E 's/^<script( type="[a-z\/]*" id="motion-data")?>//; s/<img alt="[^"<>]*" src="data:image\/svg\+xml;base64,[A-Za-z0-9+\/=]*">//' \
  "$folder/report.html" | grep -o '.\{0,60\}\(<script\|<b>\|<img\).\{0,60\}' || fail "the page has HTML of the user's making"
! grep '<script>\|<b>\|<img' "$folder/report.md" || fail "Markdown has HTML of the user's making"
equal "columns of the first table" "$(sed 's/\\|//g' "$folder/report.md" | awk '/^\|/ { at = 1; print; next } at { exit }' | tr -cd '|\n' | sort -u | wc -l)" 1

# The text is intact in what other programs read, but in a CSV a cell that begins like a formula is text.
store=$folder/store.sqlite
"$program" export "$store" -o export.csv || fail "cannot export"
printf '%s\n' "${labels[@]}" | python3 "$scripts/names.py" "$name" "$folder" || fail "names are not intact in CSV"

# By name; through compare too.
succeeds report "$store" --study "$name" --figures none --out again
ends 1 compare "${labels[1]}" "${labels[4]}" --store "$store" -o verdict.md  # too few runs
quiet
! grep '<b>' verdict.md || fail "the verdict has HTML of the user's making"

# Nothing outside (names that are no folder's: console.test.cpp).
equal "run by a name" "$(find . -name 'pwned*')" ""
equal "written" "$(echo *)" "again export.csv here hostile.toml screen verdict.md"

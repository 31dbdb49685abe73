#!/usr/bin/env bash
# Every LaTeX table of a report and its paragraph for Methods compile, and fit an A4 page with margins of 2 cm. That of the results fits a column.
source "$(dirname "$0")/common.sh"
for tool in pdflatex mf; do command -v $tool >/dev/null || { echo "skipped: no $tool"; exit 77; }; done # mf makes fonts
for package in booktabs graphicx geometry; do kpsewhich "$package.sty" >/dev/null || { echo "skipped: no $package.sty"; exit 77; }; done
export HOME=$PWD # where fonts are kept

# compiles CLASS OPTIONS TABLE...: all in one document, of which nothing sticks out.
compiles() {
  local class=$1 geometry=$2 table
  shift 2
  equal "tables that say what they need" "$(grep -lx '% Needs \\usepackage{.*}' "$@" | wc -l)" $#
  {
    printf '\\documentclass%s\n%s\n' "$class" "$geometry"
    printf '\\usepackage{%s}\n' "$(sed -n '1s/^% Needs \\usepackage{\(.*\)}$/\1/p' -s "$@" | tr ',' '\n' | sort -u | paste -sd,)"
    echo '\begin{document}'
    for table in "$@"; do printf '\\typeout{Table %s}\n\\input{%s}\n\\clearpage\n' "$(basename "$table")" "$table"; done
    echo '\input{methods}\end{document}'
  } >all.tex
  for _ in 1 2; do # the second knows the numbers of tables
    pdflatex -interaction=nonstopmode -halt-on-error all.tex >.pdflatex 2>&1 || fail "$*: $(grep -A 5 '^!' all.log)"
  done
  ! grep -E '^Table |Overfull \\hbox|too large' all.log | grep -B 1 'Overfull\|large' || fail "sticks out of $class: $*"
}

# Labels may be anything, and long.
{
  printf 'name = "labels"\nrobot = "kuka_iiwa14"\nruns = 3\npopulation = 6\n[stop]\niterations = 5\n[path]\nkind = "helix"\npoints = 3\n'
  for label in '100 %% of_{x} & #1 $y$ \\\\ ^~ [a] <b>' 'a name that goes on and on and on, as the names of some users do' \
    WWWWWWWWWW '[a]' '*'; do
    printf "[[solvers]]\nsolver = \"bat\"\nlabel = \"$label\"\n"
  done
} >labels.toml
succeeds run labels.toml --figures none --out labels
succeeds run slim2023 "${small[@]}" --figures none --out paper
for folder in labels paper; do
  mv $folder/tables/methods.tex . # a paragraph
  compiles '[a4paper]{article}' '\usepackage[margin=2cm]{geometry}' "$folder"/tables/*.tex
  for class in '[twocolumn,a4paper]{article}' '{IEEEtran}'; do
    [ "$class" != '{IEEEtran}' ] || kpsewhich IEEEtran.cls >/dev/null || continue
    compiles "$class" "" $folder/tables/results.tex
  done
done

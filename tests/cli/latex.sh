#!/usr/bin/env bash
# Every LaTeX table of a report compiles, and fits an A4 page with margins of 2 cm. That of the results fits a column.
source "$(dirname "$0")/common.sh"
command -v pdflatex >/dev/null || exit 77
for package in booktabs array adjustbox geometry; do
  kpsewhich "$package.sty" >/dev/null || exit 77
done
command -v mf >/dev/null || exit 77 # makes fonts, and keeps them in the home folder
export HOME=$PWD

# compiles FOLDER: all of its tables in one document.
compiles() {
  local folder=$1 packages
  packages=$(sed -n '1s/^% Needs \\usepackage{\(.*\)}$/\1/p' -s "$folder"/*.tex | tr ',' '\n' | sort -u | paste -sd,)
  [ "$(grep -lx '% Needs \\usepackage{.*}' "$folder"/*.tex | wc -l)" = "$(ls "$folder"/*.tex | wc -l)" ] ||
    fail "a table of $folder does not say what it needs"
  {
    echo '\documentclass[a4paper]{article}'
    echo '\usepackage[margin=2cm]{geometry}'
    echo "\\usepackage{$packages}"
    echo '\begin{document}'
    for table in "$folder"/*.tex; do
      echo "\\typeout{Table $(basename "$table")}"
      echo "\\input{$table}"
      echo '\clearpage'
    done
    echo '\end{document}'
  } >all.tex
  for _ in 1 2; do # the second knows the numbers of tables
    pdflatex -interaction=nonstopmode -halt-on-error all.tex >.pdflatex 2>&1 || fail "$folder: $(grep -A 5 '^!' all.log)"
  done
  ! grep -q 'Overfull \\hbox' all.log || fail "$folder: $(grep -E '^Table |Overfull \\hbox' all.log | grep -B 1 Overfull)"
  ! grep -q 'Float too large' all.log || fail "$folder: $(grep -E '^Table |too large' all.log | grep -B 1 large)"
  [ -z "${IKBENCH_LATEX:-}" ] || cp all.pdf "$IKBENCH_LATEX/${folder//\//-}.pdf"
}

# fits_a_column FOLDER: its table of results compiles in one of two columns.
fits_a_column() {
  local class
  for class in '[twocolumn,a4paper]{article}' '{IEEEtran}'; do
    [ "$class" != '{IEEEtran}' ] || kpsewhich IEEEtran.cls >/dev/null || continue
    {
      printf '\\documentclass%s\n' "$class"
      sed -n '1s/^% Needs //p' "$1/results.tex"
      printf '\\begin{document}\n\\input{%s}\nText.\n\\end{document}\n' "$1/results.tex"
    } >column.tex
    pdflatex -interaction=nonstopmode -halt-on-error column.tex >.pdflatex 2>&1 || fail "$1: $(grep -A 5 '^!' column.log)"
    ! grep -q -e 'Overfull \\hbox' -e 'Float too large' column.log ||
      fail "$1/results.tex in $class: $(grep -A 2 -e Overfull -e 'too large' column.log)"
    [ -z "${IKBENCH_LATEX:-}" ] || cp column.pdf "$IKBENCH_LATEX/${1//\//-}-${class//[^A-Za-z]/}.pdf"
  done
}

# With two jobs, times are not judged, and have fewer tables.
succeeds reproduce --runs 2 --jobs 2 --readings 1 --no-figures --out paper
[ "$(ls paper/tables/*.tex | wc -l)" -gt 30 ] || fail "paper/tables has few tables: $(ls paper/tables)"
compiles paper/tables
! grep -h -E '\$-[0-9.]+ to ' paper/tables/*.tex || fail "words in mathematics"

# Labels may be anything, and long.
{
  printf 'name = "labels"\nruns = 3\npopulation = 6\n[stop]\niterations = 5\n[path]\npoints = 3\n'
  for label in '100 %% of_{x} & #1 $y$ \\\\ ^~ [a] <b>' 'a name that goes on and on and on, as the names of some users do' \
    WWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWWW '[a]' '*'; do
    printf "[[solvers]]\nsolver = \"bat\"\nlabel = \"$label\"\n"
  done
} >labels.toml
succeeds run labels.toml --no-figures --out labels
compiles labels/tables
fits_a_column labels/tables
exit 0

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

# writes FOLDER: its article compiles too, and has these sections.
writes() {
  succeeds article "$1"
  [ "$(head -c 4 "$1/article.pdf")" = %PDF ] || fail "$1 has no article.pdf"
  ! grep -q -e 'Overfull \\hbox' -e 'Float too large' "$1/article.log" || fail "$1: $(grep -e Overfull -e 'too large' "$1/article.log")"
  for section in 'Experimental set-up' Results 'Flow of solves' 'Data availability'; do
    has "$(<"$1/article.tex")" "\\section{$section}"
  done
  [ -z "${IKBENCH_LATEX:-}" ] || cp "$1/article.pdf" "$IKBENCH_LATEX/$1-article.pdf"
}

# With two jobs, times are not judged, and have fewer tables.
succeeds reproduce --runs 2 --jobs 2 --readings 1 --repetitions 2 --no-figures --out paper
[ "$(ls paper/tables/*.tex | wc -l)" -gt 30 ] || fail "paper/tables has few tables: $(ls paper/tables)"
compiles paper/tables
writes paper
has "$(<paper/article.tex)" "Of 20 claims"
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
writes labels
has "$(<labels/article.tex)" "We compare 5 solvers"
succeeds article labels --json
python3 -c 'import json, sys; of = json.load(sys.stdin); assert of == {"article": "labels/article.pdf", "made_by": "pdflatex"}, of' <<<"$out" || fail "no JSON: $out"

# Letters that pdflatex lacks: lualatex makes the PDF, or the package is named before LaTeX begins.
{
  printf 'name = "letters"\nruns = 3\npopulation = 6\n[stop]\niterations = 5\n[path]\npoints = 3\n'
  for label in שלום مرحبا 関節 плечо; do printf '[[solvers]]\nsolver = "bat"\nlabel = "%s"\n' "$label"; done
} >letters.toml
succeeds run letters.toml --no-figures --out letters
run_it article letters
if command -v lualatex >/dev/null && kpsewhich luaotfload.sty >/dev/null; then
  [ "$code" = 0 ] || fail "exit code $code: $err"
  has "$out" "by lualatex, because pdflatex lacks some of its letters"
  [ "$(head -c 4 letters/article.pdf)" = %PDF ] || fail "letters has no article.pdf"
else
  [ "$code" = 2 ] || fail "exit code $code, expected 2: $out $err"
  has "$err" "to install it: apt-get install texlive-luatex"
  [ ! -e letters/article.log ] || fail "LaTeX began"
fi
refused "has no article.tex; write a report into it first" article nowhere
refused "ikbench reproduce beeson2015" article beeson2015
exit 0

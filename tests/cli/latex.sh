#!/usr/bin/env bash
# Every LaTeX table of a report and its paragraphs compile, and fit an A4 page with margins of 2 cm. That of the results
# fits a column. The example of an article compiles with all, and knows all that it refers to.
source "$(dirname "$0")/common.sh"
needs pdflatex bibtex mf {booktabs,graphicx,geometry}.sty IEEEtran.cls ptmr7t.tfm # mf makes fonts; a font of IEEEtran
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
    echo '\input{methods}\input{results}\end{document}'
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
succeeds stats "$root/tests/data/csv/zero.csv" --better smaller --figures none --out file
for folder in labels paper file; do
  for class in IEEEtran plain; do
    (
      cd $folder/article || exit 1
      [ $class = IEEEtran ] || sed -i 's/^\\IfFileExists.*/\\plain/' main.tex
      for tool in pdflatex bibtex pdflatex pdflatex; do
        [ $tool != bibtex ] || [ -e references.bib ] || continue
        case $tool in bibtex) bibtex main ;; *) pdflatex -interaction=nonstopmode -halt-on-error main.tex ;; esac >.tex 2>&1 ||
          fail "$folder as $class, $tool: $(grep -A 5 '^!' main.log) $(tail -n 3 .tex)"
      done
      ! grep -E 'undefined|multiply defined' main.log || fail "$folder as $class"
    ) || exit 1
  done
  cp $folder/article/{methods,results}.tex . # paragraphs
  compiles '[a4paper]{article}' '\usepackage[margin=2cm]{geometry}' "$folder"/tables/*.tex
  for class in '[twocolumn,a4paper]{article}' '{IEEEtran}'; do
    compiles "$class" "" $folder/tables/results.tex
  done
done

# Letters beyond Latin take another engine.
can xelatex fontspec.sty || exit 0
sed 's/WWWWWWWWWW/Ж θ/' labels.toml >greek.toml
succeeds run greek.toml --set name=greek --figures none --out greek
cd greek/article && xelatex -interaction=nonstopmode -halt-on-error main.tex >.tex 2>&1 || fail "greek: $(grep -A 5 '^!' main.log)"

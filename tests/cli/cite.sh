#!/usr/bin/env bash
# `ikbench cite` prints BibTeX of the program, a study's paper and its solvers' papers.
source "$(dirname "$0")/common.sh"

succeeds cite
has "$out" "@misc{ikbench,"
[ "$(grep -c '^@' <<<"$out")" = 1 ] || fail "the program alone was expected: $out"

succeeds cite slim2023
for entry in slim2023 yang2010 storn1997 kennedy1995 elsherbiny2018 coello2004; do
  [ "$(grep -c "^@.*{$entry,$" <<<"$out")" = 1 ] || fail "expected $entry once: $out"
done
has_no "$out" "{lloyd2022,"
printf '%s\n' "$out" >references.bib
succeeds run slim2023 "${small[@]}" --no-report --out made
succeeds cite made/store.sqlite
cmp <(printf '%s\n' "$out") references.bib || fail "a study and its store are cited differently"
if command -v bibtex >/dev/null; then # every entry is one that BibTeX reads
  printf '%s\n' '\citation{*}' '\bibstyle{plain}' '\bibdata{references}' >references.aux
  bibtex references >.log || fail "BibTeX: $(<.log)"
  ! grep -q 'Warning' .log || fail "BibTeX warns: $(<.log)"
  [ "$(grep -c '^\\bibitem' references.bbl)" = "$(grep -c '^@' references.bib)" ] || fail "$(<references.bbl)"
fi
refused "unknown built-in study" cite none

as_json 'len(of["bibtex"]) == '"$(grep -c '^@' references.bib)"' and of["bibtex"][0].startswith("@misc{ikbench,") and of["sources"] == {}' \
  cite slim2023

# Each solver that is built in has an entry or its source. Some are refused on this arm, or not built here.
of_solvers=0 cited=0
while read -r solver _; do
  printf 'name = "one"\nsearch = "pose"\nstart = "middle"\nruns = 1\n[path]\nkind = "random"\npoints = 2\n[[solvers]]\nsolver = "%s"\n' \
    "$solver" >one.toml
  run_it cite one.toml
  of_solvers=$((of_solvers + 1))
  [ "$code" = 0 ] || continue
  cited=$((cited + 1))
  grep -qE '^(@[a-z]*\{[a-z0-9]*,|% ).*' <(tail -n +8 <<<"$out") || fail "nothing is cited for $solver: $out"
done < <("$program" list solvers | sed -n '2,$s/^\([a-z]\)/\1/p')
((2 * cited > of_solvers)) || fail "only $cited of $of_solvers solvers were cited: $err"

# Program, citation, metadata and manual pages have one version; the citation says what `ikbench cite` says.
succeeds --version
whole=$out version=$(sed 's/^ikbench \([0-9.]*\) (.*)$/\1/' <<<"$out")
[[ $version =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]] || fail "no version in: $out"
source_folder=$scripts/../..
has "$(<"$source_folder/CMakeLists.txt")" "project(ikbench VERSION $version "
grep -qx "version: $version" "$source_folder/CITATION.cff" || fail "CITATION.cff is not of $version"
grep -q "\"version\": \"$version\"" "$source_folder/codemeta.json" || fail "codemeta.json is not of $version"
grep -qx "  version: \"$version\"" "$source_folder/docs/conda/recipe.yaml" || fail "the recipe for conda is not of $version"
if command -v help2man >/dev/null; then
  "$source_folder/docs/man" "$program" man1 || fail "no manual pages"
  for page in man1/ikbench.1 man1/ikbench-compare.1; do
    head -n 3 $page | grep -q "^\.TH .*\"ikbench $version\"" || fail "$page is not of $version: $(head -n 3 $page)"
  done
fi
succeeds cite
title=$(sed -n '1,/^title: /s/^title: "\(.*\)"$/\1/p' "$source_folder/CITATION.cff")
author=$(sed -n '1,/ - name: /s/^ *- name: "\(.*\)"$/\1/p' "$source_folder/CITATION.cff")
year=$(sed -n 's/^date-released: \([0-9]*\)-.*/\1/p' "$source_folder/CITATION.cff")
has "$out" "title = {$title}"
has "$out" "author = {{$author}}"
has "$out" "year = {$year}"
has "$out" "version = {${whole#ikbench }}"
grep -q "\"name\": \"$author\"" "$source_folder/codemeta.json" || fail "codemeta.json has another author"

# What the program writes says which program that was.
succeeds report made/store.sqlite --out reported
has "$(<reported/report.html)" "Made by $whole."
for file in article.tex tables/results.tex; do
  [ "$(tail -n 1 reported/$file)" = "% Made by $whole" ] || fail "$file does not say who made it"
done
if command -v gnuplot >/dev/null; then
  figure=$(basename "$(ls reported/figures/*.svg | head -n 1)" .svg)
  for type in svg pdf png; do
    LC_ALL=C grep -qaF "$whole" "reported/figures/$figure.$type" || fail "$figure.$type does not say who made it"
  done
fi

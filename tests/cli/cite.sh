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

# Each solver that is built in has an entry or its source.
while read -r solver _; do
  printf 'name = "one"\nsearch = "pose"\nstart = "middle"\nruns = 1\n[path]\nkind = "random"\npoints = 2\n[[solvers]]\nsolver = "%s"\n' \
    "$solver" >one.toml
  run_it cite one.toml
  [ "$code" != 0 ] || grep -qE '^(@[a-z]*\{[a-z0-9]*,|% ).*' <(tail -n +8 <<<"$out") || fail "nothing is cited for $solver: $out"
done < <("$program" list solvers | sed -n '2,$s/^\([a-z]\)/\1/p')

#!/usr/bin/env bash
# Everything that can be named is listed, everything listed can be looked at, and every command explains itself.
source "$(dirname "$0")/common.sh"

for kind in solvers robots studies paths columns metrics instruction-sets; do
  succeeds list $kind
  [ -z "$err" ] && [ "$(wc -L <.out)" -le 100 ] || fail "list $kind: $(wc -L <.out) columns; $err"
  quiet
  names=$(grep -E '^[a-z]' .out | cut -d' ' -f1) && [ -n "$names" ] || fail "there are no $kind"
  case $kind in robots) show=robot ;; solvers | paths) show="list $kind" ;; *) continue ;; esac
  for name in $names; do
    succeeds $show "$name"
    has "$out" "$name"
    quiet
  done
done

succeeds list solvers ik_bat
has "$out" $'\n'"pulse_rate "
succeeds list
equal kinds "$(wc -l <.out)" 8
# What to cite: an entry for each, and no keyword of another one.
"$program" list solvers >all && "$program" list robots >>all
for name in $(sed -n 's/^\([a-z][^ ]*\).*/\1/p' all); do
  [[ $name == planar_* ]] || grep -q "keywords = .*\b$name\b" "$root/docs/references.bib" || fail "nothing to cite for $name"
done
for keyword in $(sed -n 's/.*keywords = {\(.*\)}/\1/p' "$root/docs/references.bib" | tr -d ,); do
  grep -q "^$keyword " all || [[ -e $root/analysis/papers/$keyword.toml ]] || fail "references.bib names $keyword"
done

# A listed study is a study file, and says the meaning of its keys.
for study in $("$program" list studies | grep -E '^[a-z]' | cut -d' ' -f1); do
  succeeds list studies "$study"
  cp .out "$study.toml"
  [ "$(grep -c ' = .*  # ' .out)" -gt 30 ] || fail "$study does not explain its keys"
  succeeds list studies "$study.toml"
  diff <(grep "^[^#]" .out) <(grep "^[^#]" "$study.toml") || fail "the listed study, listed again, is another"
done
# The page on study files names each of these keys, and those of a URDF file.
for key in base tip limits $(sed -n 's/^\([a-z_]*\) = .*/\1/p' slim2023-time.toml any-arm.toml); do
  grep -qE "\`$key(\`| =)" "$root/docs/reference/study-file.md" || fail "study-file.md lacks $key"
done
study theirs '[[solvers]]' 'label = "X"' 'process = ["touch", "ran"]'
refused "starts no programs" list studies theirs.toml
[ ! -e ran ] || fail "a list started a program"

succeeds list metrics && [[ $out =~ solved_in_time\ +larger ]] || fail "more solved in time is not better: $out"

# Help, and the version.
succeeds --help
cp .out all
for command in $(sed -n 's/^COMMAND([^"]*"\([^"]*\)".*/\1/p' "$root/cli/commands.inc"); do
  grep -q "^  $command " all || fail "--help does not list $command"
  succeeds "$command" --help
  has "$out" "ikbench $command "
  [ "$(wc -L <.out)" -le 100 ] || fail "$command --help has a line of more than 100 columns"
  [ -z "$err" ] || fail "$command --help wrote to the standard error: $err"
  quiet
done
succeeds list solvers levenberg_marquardt
cp .out whole
succeeds list solvers lm
cmp .out whole || fail "an abbreviation of tables names no solver: $out"
succeeds --version
[[ $out =~ ^ikbench\ [0-9]+\.[0-9]+\.[0-9]+\ \(.+\)$ ]] || fail "--version says: $out"
succeeds
diff .out all || fail "ikbench alone is not ikbench --help"

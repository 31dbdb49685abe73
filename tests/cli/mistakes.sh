#!/usr/bin/env bash
# A mistake in what was asked for: exit code 1, one sentence that names it, and nothing written.
source "$(dirname "$0")/common.sh"
printf 'robot = "ur5e"\npath.kind = "random"\n[[solvers]]\n  solver = "abt"\n' >misspelt.toml
: >empty.sqlite
succeeds run slim2023 "${small[@]}" --no-report --out made
head -c 5000 made/store.sqlite >truncated.sqlite
printf 'solver,error\nA,1\n' >table.csv
printf 'solver,error\nA\u0378,1\nA\u0378,3\nB,2\nB,5\n' >glyph.csv # which no font has
echo "a file" >file
echo 'font = "No Such Font"' >font.toml
printf '[words.eror-boxes]\nx = "Fehler"\n' >words.toml
mkdir none taken folder.urdf
mkfifo pipe.urdf
echo "not a store" >taken/store.sqlite
before=$(find . -type f -exec md5sum {} + | grep -v '\./\.' | sort)

while IFS='|' read -r word command; do
  eval "refused $word $command"
  quiet
done < <(grep -v '^#' "$root/tests/data/mistakes/commands")
! can fc-list || refused "U+0378" stats glyph.csv --better smaller --out glyph
for command in report export "compare made/store.sqlite"; do
  refused none.sqlite $command none.sqlite
  refused made/store.sqlite $command made
  refused folder $command none
  for file in table.csv empty.sqlite truncated.sqlite; do refused $file $command $file; done
  refused "'other'" $command made/store.sqlite --study other
done
equal files "$(find . -type f -exec md5sum {} + | grep -v '\./\.' | sort)" "$before"
[ ! -e out ] || fail "something was written to out/"

# Output to a full device is no success; an unread complaint is no crash.
"$program" list robots >/dev/full 2>.err; equal "code of a full standard output" $? 2
"$program" list nonsense 2>/dev/full; equal "code of a full standard error" $? 1

#!/usr/bin/env bash
# A mistake in what was asked for: exit code 1, one sentence that names it, and nothing written.
source "$(dirname "$0")/common.sh"
printf 'robot = "ur5e"\npath.kind = "random"\n[[solvers]]\n  solver = "abt"\n' >misspelt.toml
: >empty.sqlite
succeeds run slim2023 "${small[@]}" --no-report --out made
head -c 5000 made/store.sqlite >truncated.sqlite
printf 'robot = "ur5e\nsearch = "pose"\n' >quote.toml
echo '<robot/>' >xml.toml
printf 'solver,error\nA,1\n' >table.csv
printf 'solver,error\nBA,1\nBA,3\nIK-BA,2\nIK-BA,5\n' >two.csv
printf 'solver,error\nA\u0378,1\nA\u0378,3\nB,2\nB,5\n' >glyph.csv # which no font has
echo "a file" >file
echo 'font = "No Such Font"' >font.toml
printf '[words.eror-boxes]\nx = "Fehler"\n' >words.toml
cp "$scripts/studies/my_study.toml" "$scripts/studies/my_arm.toml" .
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

# A file that is no table: what it is, and a command, which makes a table that is read.
times() { printf '%s' "$1"; for i in $(seq 2 8); do printf ',%s%s' "$1" "$i"; done; }
echo "{\"results\":[{\"command\":\"one\",\"mean\":1,\"times\":[$(times 0.1)]},{\"command\":\"two, too\",\"mean\":2,\"times\":[$(times 0.3)]}]}" >hyperfine.json
google() { for i in $(seq 8); do printf '{"name":"%s","run_type":"iteration","real_time":%s.%s,"time_unit":"us"},' "$1" "$2" "$i"; done; }
echo "{\"context\":{},\"benchmarks\":[$(google one 1)$(google two 3){\"name\":\"one_mean\",\"run_type\":\"aggregate\",\"real_time\":9}]}" >google.json
for name in one two; do for i in $(seq 8); do echo "{\"who\":\"$name\",\"ms\":${#name}$i}"; done; done | sed 's/two","ms":/&9/' >"a line.jsonl"
paste -sd, "a line.jsonl" | sed 's/.*/[&]/' >objects.json
if can jq; then
  while IFS='|' read -r file what; do
    ends 1 stats "$file" --better smaller
    has "$(xargs <.err)" "$what"
    bash -c "$(tail -n 1 .err)" || fail "the command for $file: $(<.err)"
    succeeds stats "$file.csv" --better smaller
    [[ $out == one\ * ]] || fail "of $file: $out"
    "$program" stats - --better smaller <"$file" 2>.err; equal "code of standard input" $? 1
    has "$(tail -n 1 .err)" "> table.csv"
  done <<'END'
hyperfine.json|from hyperfine
google.json|from Google Benchmark
a line.jsonl|one object per line
objects.json|is JSON
END
fi
rm -f ./*.json ./*.json.csv "a line.jsonl"*
echo '{"x":[1,{"y":2}]}' >nested
gzip <table.csv >table.csv.gz
printf 'PK\003\004\0' >table.ods
for file in "nested|one row per value" "table.csv.gz|gunzip -k table.csv.gz" "table.ods|libreoffice" "made/store.sqlite|ikbench report made/store.sqlite"; do
  ends 1 stats "${file%%|*}"
  has "$(xargs <.err)" "${file#*|}"
done

# Output to a full device is no success; an unread complaint is no crash.
"$program" list robots >/dev/full 2>.err; equal "code of a full standard output" $? 2
"$program" list nonsense 2>/dev/full; equal "code of a full standard error" $? 1

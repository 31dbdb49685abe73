#!/usr/bin/env bash
# A mistake in what was asked for: exit code 1, one sentence that names it, and nothing written.
source "$(dirname "$0")/common.sh"
study hand 'options = { damping = "0.1" }'
printf 'name = "x"\nruns = = 3\n' >broken.toml
printf 'name = "x"\n\n[[solvers]]\n  solver = "abt"\n' >misspelt.toml
printf '\376\355\372\316\000\001binary\377' >garbage.toml
: >empty.toml
: >empty.sqlite
succeeds run slim2023 "${small[@]}" --no-report --out made
head -c 5000 made/store.sqlite >truncated.sqlite
printf 'solver,error\nA,1\n' >table.csv
echo "a file" >file
echo 'font = "No Such Font"' >font.toml
mkdir none taken
echo "not a store" >taken/store.sqlite
before=$(find . -type f -exec md5sum {} + | grep -v '\./\.' | sort)

# A command and the word that its sentence has; a pair of quotes keeps words together.
while IFS='|' read -r word command; do
  eval "refused $word $command"
  quiet
done <<'END'
'"run"'|rnu
'"frobnicate"'|frobnicate
'"slim2023"'|run slim2032
'"ik_bat"'|list solvers ik_bta
'"solvers"'|list solver
'--bogus'|run slim2023 --bogus
'--study'|report made/store.sqlite --studi=x
'"error-boxes"'|report made/store.sqlite --figures eror-boxes
'"No Such Font"'|report made/store.sqlite --style font.toml
'"#1E8CF8"'|run slim2023 --set IK-BA.colour=red
'STUDY'|run
'--jobs'|run slim2023 --jobs 0
'--format'|export made/store.sqlite --format xml
'--snap-deg'|robot ur5e --snap-deg nan
'--margin'|compare made/store.sqlite made/store.sqlite --margin 5
'"IK-BA"'|compare IKBA BA --store made/store.sqlite
'same'|compare BA BA --store made/store.sqlite
'"runs"'|run slim2023 --set runz=3
'key=value'|run slim2023 --set runs
'alpha'|run slim2023 --set IK-BA.alpha=7
'name'|run slim2023 --set $'name=a\nb'
'"12 bats"'|run slim2023-time --set '12bats.population=16'
'limits'|run slim2023-limits --set bounds=initial
'analysis.significance'|run slim2023 --set analysis.significance=0.75
'"IK-BA"'|run slim2023 --set analysis.control=IKBA
'metric'|run slim2023 --set analysis.metric=speed
'"alpha"'|run slim2023 --sweep alhpa=0.5
'style.toml'|run slim2023 --style style.toml
'folder'|run .
'hand.toml:13:23'|run hand.toml
'broken.toml:2:8'|run broken.toml
'misspelt.toml:4:12'|run misspelt.toml
'garbage.toml:1:'|run garbage.toml
'empty.toml:1:1'|run empty.toml
'COMMAND'|check-solver
'--patience'|check-solver --patience nan -- cat
'file'|run slim2023 --set runs=1 --out file
'file'|report made/store.sqlite --out file
'store.sqlite/solves.csv'|export made/store.sqlite -o made/store.sqlite/solves.csv
'taken/store.sqlite'|run slim2023 --set runs=1 --out taken
'\x1b[31m'|list solvers $'\e[31mred'
'\x1b[31m'|run slim2023 --set $'\e[31m=1'
END
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

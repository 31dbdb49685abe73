#!/usr/bin/env bash
# A mistake in what was asked for: exit code 1, one line, and nothing written.
source "$(dirname "$0")/common.sh"

# Names.
refused 'did you mean "run"?' rnu
refused 'unknown command "frobnicate"' frobnicate
refused 'unknown built-in study "slim2032"; did you mean "slim2023"?' run slim2032
refused 'unknown solver "ik_bta"; did you mean "ik_bat"?' list solvers ik_bta
refused 'unknown robot "planar_4"; did you mean' list robots planar_4
refused 'unknown column "tmie"' list columns tmie
refused 'unknown built-in study "x"' list studies x
refused 'unknown kind of path "helx"; did you mean "helix"?' list paths helx
refused 'unknown instruction set "x86-65"' list instruction-sets x86-65
refused 'unknown kind of list "solver"; did you mean "solvers"?' list solver
refused 'unknown kind of list "things" (there are: solvers, robots, ' list things

# Options of the commands.
refused 'run has no option --bogus; see --help' run slim2023 --bogus
refused 'compare has no option --metrics; did you mean --metric?' compare --metrics solved a b
refused 'report has no option --studi; did you mean --study?' report store.sqlite --studi=x
refused 'extra' run slim2023 extra
refused 'STUDY' run
refused '--jobs: 0 is not a whole number from 1 to 1024; ' run slim2023 --jobs 0
refused '--jobs: many is not a whole number from 1 to 1024; ' run slim2023 --jobs many
refused '--runs: 0 is not a whole number from 1 to 1000000; ' reproduce --runs 0
refused '--seed: -1 is not a whole number from 0' reproduce --seed -1
refused '--unit' report store.sqlite --unit day
refused '--quartiles' report store.sqlite --quartiles 10
refused '--unit is point; expected run: points of one run depend on each other' run slim2023 --unit point
refused 'to insist: --force' reproduce --unit point
refused '--format' export store.sqlite --format xml
refused '--snap-deg: nan is not a number from 0 to 1' robot ur5e --snap-deg nan
refused '--base is about a URDF file, but the arm is ur5e' robot ur5e --base x
refused 'list lacks its KIND; expected one of: solvers, ' list
refused 'did you mean "franka_panda"' robot panda
refused '--runs is not an option of beeson2015' reproduce beeson2015 --runs 3

# --set.
refused '--set runs: runs is 0; expected a whole number from 1' run slim2023 --set runs=0
refused '--set runz: unknown key "runz"; did you mean "runs"?' run slim2023 --set runz=3
refused 'expected key=value' run slim2023 --set runs
refused '--set IK-BA.alpha: option alpha is "7"; expected a number from 0 to 1' run slim2023 --set IK-BA.alpha=7
refused 'did you mean "IK-BA"?' run slim2023 --set IKBA.alpha=0.5
refused '--set path.tool:' run slim2023 --set path.tool=sideways
refused '--set name:' run slim2023 --set $'name=a\nb'
refused '--set path.points: path.points is 0; expected a whole number from 1 to 100000' run slim2023-time --set path.points=0
refused '--set path.points: path.points is 1000000000' run slim2023-dobot --set path.points=1000000000
refused '--set path.radius_cm: path.radius_cm is nan' run slim2023-dobot --set path.radius_cm=nan
refused '--set 12 bats.population: 12 bats.population is 0; expected a whole number from 1' \
  run slim2023-time --set '12 bats.population=0'
refused '12 bats.population is 1000000000' run slim2023-time --set '12 bats.population=1000000000'
refused 'did you mean "12 bats"?' run slim2023-time --set '12bats.population=16'
refused '--set bounds: bounds is "initial", but limits is "enforced"' run slim2023-limits --set bounds=initial
refused '--set IK-BA.bounds: bounds is "initial", but limits is "enforced"' run slim2023-limits --set IK-BA.bounds=initial
refused 'dobot_magician has no spherical wrist' run slim2023-dobot --set search=wrist

refused '--set analysis.significance: analysis.significance is 0.75; expected a number from 0.0001 to 0.2' \
  run slim2023 --set analysis.significance=0.75
refused 'the label of a solver of the study: "IK-BA", "BA"' run slim2023 --set analysis.control=IKBA
refused 'to insist: --force' run slim2023 --set analysis.unit=point
refused 'did you mean "analysis"?' run slim2023 --set anlysis.unit=run

# Study files.
refused 'no such file: none.toml; expected a TOML file, or a name of: ikbench list studies' run none.toml
refused '. is a folder; expected a TOML file' run .
study hand 'options = { damping = "0.1" }'
refused 'no such file: hnd.toml; did you mean "hand.toml"?' run hnd.toml
refused "no such file: $work/hnd.toml; did you mean \"$work/hand.toml\"?" run "$work/hnd.toml"
refused 'no such file: slim2032.toml; did you mean "slim2023"?' run slim2032.toml
refused 'hand.toml:13:23: DLS.damping is "0.1"; expected a number, without quotes: 0.1' run hand.toml
refused 'did you mean "random"?' run hand.toml --set path.kind=randon
refused 'runs is "2"; expected a whole number from 1 to 1000000, without quotes' run hand.toml --set 'runs="2"'
refused '--set DLS.damping: DLS.damping is "0.1"; expected a number, without quotes: 0.1' run hand.toml --set 'DLS.damping="0.1"'
printf 'name = "x"\nruns = = 3\n' >broken.toml
refused 'broken.toml:2:8: not TOML' run broken.toml
printf 'name = "x"\nruns = 0\n[[solvers]]\nsolver = "bat"\n' >wrong.toml
refused 'wrong.toml:2:8: runs is 0; expected a whole number from 1' run wrong.toml
printf 'name = "x"\n\n[[solvers]]\n  solver = "abt"\n' >misspelt.toml
refused 'misspelt.toml:4:12: unknown solver "abt"; did you mean "bat"?' run misspelt.toml
printf '\376\355\372\316\000\001binary\377' >garbage.toml
refused 'garbage.toml:1:' run garbage.toml
: >empty.toml
refused 'empty.toml:1:1: the study names no solver' run empty.toml

# Stores.
succeeds run slim2023 "${small[@]}" --no-report --out made
mkdir none
head -c 5000 made/store.sqlite >truncated.sqlite
printf 'solver,error\nA,1\n' >table.csv
: >empty.sqlite
for command in report export; do
  refused "'none.sqlite' does not exist" $command none.sqlite
  refused "'made' is a folder; expected a store file, such as 'made/store.sqlite'" $command made
  refused "'.' is a folder; expected a store file, such as './empty.sqlite', './made/store.sqlite', './truncated.sqlite'" $command .
  refused "'none' is a folder; expected a store file" $command none
  refused 'is not an ikbench store' $command table.csv
  refused 'empty.sqlite' $command empty.sqlite
  refused 'truncated.sqlite' $command truncated.sqlite
  refused "no study 'other'" $command made/store.sqlite --study other
done

# Places that cannot be written to: a file is no folder, not even for root.
echo "a file" >file
refused 'file' run slim2023 "${small[@]}" --out file
refused 'file' run slim2023 "${small[@]}" --out file/below
refused 'file' reproduce --runs 1 --out file
refused 'file' report made/store.sqlite --out file
refused 'store.sqlite/solves.csv' export made/store.sqlite -o made/store.sqlite/solves.csv
refused 'made' export made/store.sqlite -o made
[ "$(<file)" = "a file" ] || fail "the file was changed"
mkdir taken && echo "not a store" >taken/store.sqlite
refused 'taken/store.sqlite' run slim2023 "${small[@]}" --out taken
[ "$(<taken/store.sqlite)" = "not a store" ] || fail "somebody else's store.sqlite was changed"

# A name from the command line moves no cursor.
refused '\x1b[31m' list solvers $'\e[31mred'
refused '\x1b[31m' $'\e[31mred'
refused '\x1b[31m' report $'\e[31mred'
refused '\x1b[31m' run slim2023 --set $'\e[31m=1'
quiet
[ ! -e out ] || fail "something was written to out/"

# Whole numbers are decimal and fit: CLI11 alone reads 010 as 8.
refused '010 has a leading zero; expected a whole number' reproduce --seed 010 --runs 1
refused 'is not a whole number' reproduce --runs 99999999999999999999999
refused 'is not a whole number' run slim2023 --jobs 0x2

# Output to a full device is no success; an unread complaint is no crash.
"$program" list robots >/dev/full 2>.err; [ $? = 2 ] || fail "a full standard output went unnoticed"
has "$(<.err)" 'cannot write to standard output'
"$program" list nonsense 2>/dev/full; [ $? = 1 ] || fail "a full standard error"
refused 'is the store itself' export made/store.sqlite -o made/store.sqlite
succeeds export made/store.sqlite

#!/usr/bin/env bash
# Exports are what other programs read: CSV, a fingerprint.
source "$(dirname "$0")/common.sh"
traced=(slim2023 "${small[@]}" --set trace=best_error --no-report)
succeeds run "${traced[@]}" --out made
succeeds run slim2023-context "${small[@]}" --no-report --out made
succeeds export made/store.sqlite
quiet
[ -z "$err" ] || fail "export wrote to the standard error: $err"
equal "lines" "$(wc -l <.out)" 37 # a head and 36 solves
equal "lengths of rows" "$(awk -F, '{ print NF }' .out | sort -u | wc -l)" 1
cp .out first.csv
equal "lines of the second study" "$("$program" export made/store.sqlite --study slim2023-context | wc -l)" 13

# A fingerprint (fingerprint.test.cpp).
succeeds export made/store.sqlite --study slim2023-context --format fingerprint
[[ $out =~ ^[0-9a-f]{32}\ \ 12\ \ slim2023-context$ ]] || fail "it said: $out"

# -o writes a whole file, and none of the store's (files.test.cpp has more).
code=0
(ulimit -f 1 && "$program" export made/store.sqlite -o limited.csv 2>.err) || code=$?
equal "code beyond ulimit -f, which said $(<.err)" $code 2
[ ! -e limited.csv ] || fail "half a file beyond ulimit -f"
for part in '' -wal -shm -journal; do
  [ -e "made/store.sqlite$part" ] || : >"made/store.sqlite$part"
  refused 'store' export made/store.sqlite -o "made/store.sqlite$part"
  [ -s "made/store.sqlite$part" ] || rm "made/store.sqlite$part"
done
"$program" export made/store.sqlite | head -n 1 >.out
code=${PIPESTATUS[0]}
[ "$code" = 0 ] || [ "$code" = 141 ] || fail "export | head: exit code $code"

# The SQL of the docs counts no solve of an older program, and has the means of the report.
cp -r made asked
sqlite3 asked/store.sqlite "CREATE TEMP TABLE older AS SELECT * FROM solves; UPDATE older SET series = 'older@' || series; INSERT INTO solves SELECT * FROM older"
succeeds report asked/store.sqlite --figures none
mapfile -t lines < <(grep '^sqlite3 -readonly' "$root/docs/reference/data.md")
equal "lines of SQL in the docs" ${#lines[@]} 1
cd asked || exit 1
equal "solves of each solver" "$(bash -c "${lines[0]}" | cut -d'|' -f1,3 | sort | uniq -c | xargs)" "2 slim2023-context|6 6 slim2023|6"
bash -c "${lines[0]/current_solves/run_means}" | awk -F'|' '$1 == "slim2023" { printf "%s,%s,%.9g\n", $2, $3, $4 }' | sort >../means
awk -F, '$1 == "position error" { printf "%s,%s,%.9g\n", $2, $3, $4 }' tables/descriptives.csv | sort | diff ../means - || fail "other means than the report's"
cd ..

python3 "$scripts/exports.py" || fail "other programs would not read it"

# verify draws targets and starts again, whatever a study asks, and its last line is what to cite.
sealed='[0-9]+ of [0-9]+ solves \(runs x targets x solvers: [0-9]+ x [0-9]+ x [0-9]+\), fingerprint [0-9a-f]{32}$'
cp "$root/tests/data/urdf/ur5e.urdf" .
drawn=(--no-report --set runs=2 --set stop.iterations=5)
succeeds run any-arm "${drawn[@]}" --set start=near --set near_deg=30 --set path.set=anywhere --set robot=ur5e.urdf --only LM --out near
succeeds run any-arm "${drawn[@]}" --set path.generator=numpy --set start=initial --only LM --out numpy
for folder in made near numpy; do
  succeeds verify $folder/store.sqlite
  has "$out" "starts from the seed"
  [[ $(tail -n 1 .out) =~ $sealed ]] || fail "no line to cite: $out"
done
succeeds verify "$root/tests/data/version-4.sqlite"
edited() { # WORD SQL
  cp near/store.sqlite edited.sqlite
  sqlite3 edited.sqlite "$2"
  refused "$1" verify edited.sqlite
}
edited "another target" "UPDATE studies SET definition = json_set(definition, '\$.seed', 7)"
edited "another start" "UPDATE studies SET definition = json_set(definition, '\$.near_deg', 20)"
printf 'robot = "planar_3"\nsearch = "all_joints"\nruns = 2\n[path]\nkind = "poses"\nposes = [{ position_cm = [30, 10, 0], rpy_deg = [0, 0, 0] }]\n[stop]\n[[solvers]]\nsolver = "damped_least_squares"\n' >poses.toml
succeeds run poses.toml --no-report --out poses
succeeds verify poses/store.sqlite
has "$out" "times, targets, starts"

# An archive is a store, whole and sealed, for who reads stores; one that was edited says so.
refused "-o FILE" export made/store.sqlite --format archive
succeeds export made/store.sqlite --format archive -o archived.sqlite
succeeds verify archived.sqlite
same_fingerprint archived.sqlite made/store.sqlite
succeeds report archived.sqlite --out archived --figures none
succeeds run slim2023 "${small[@]}" --set trace=best_error --only IK-BA --beside archived.sqlite --figures none --out beside
sqlite3 archived.sqlite "DELETE FROM solves WHERE run = 2"
refused "when it was archived" verify archived.sqlite

# The seal covers times, which no reader can compute again, and one that was printed elsewhere decides.
succeeds export made/store.sqlite --format archive -o archived.sqlite
[[ $out =~ ^archived\.sqlite:\ seal\ ([0-9a-f]{64})$ ]] || fail "no seal: $out"
seal=${BASH_REMATCH[1]}
succeeds verify archived.sqlite
has "$(xargs <.out)" "since somebody archived it, times and extras included (seal $seal)"
line=$(tail -n 1 .out)
succeeds verify archived.sqlite --seal "${seal^^}"
has "$(xargs <.out)" "It has the given seal"
refused "64 hexadecimal digits" verify archived.sqlite --seal 1234
refused 'no seal' verify made/store.sqlite --seal "$seal"
forge="UPDATE solves SET seconds = seconds * 0.8, wall_seconds = seconds * 0.8, cpu_seconds = cpu_seconds * 0.8 WHERE label = 'BA'"
cp archived.sqlite forged.sqlite
sqlite3 forged.sqlite "$forge"
refused "its seal was $seal when" verify forged.sqlite
succeeds export forged.sqlite --format archive -o again.sqlite # by somebody else
succeeds verify again.sqlite
refused "not the given $seal" verify again.sqlite --seal "$seal"

# Archives that have a line of each study instead say that times are not covered.
cp archived.sqlite older.sqlite
sqlite3 older.sqlite "UPDATE environment SET key = 'seal.slim2023', value = '$line' WHERE key = 'seal'"
sqlite3 older.sqlite "$forge"
succeeds verify older.sqlite
has "$(xargs <.out)" "does not cover times"
sqlite3 older.sqlite "DELETE FROM solves WHERE run = 2"
refused "was slim2023: 36 of 36 solves" verify older.sqlite
sqlite3 near/store.sqlite "UPDATE solves SET status = 'limit_violated'"
cp archived.sqlite before.sqlite
refused "status" export near/store.sqlite --format archive -o archived.sqlite
cmp archived.sqlite before.sqlite

#!/usr/bin/env bash
# The program never reports success over what others do to a store while it writes it, and reads no store that is damaged.
# store_faults.test.cpp and runner.test.cpp have all kinds of it; here is one of each as a user meets it.
source "$(dirname "$0")/common.sh"
study=(run slim2023 --set runs=6 --set path.points=10 --set stop.iterations=200 --set population=20 --figures none)

# The same study runs twice, for minutes: of two, one is refused, and the other goes on.
for which in first second; do
  "$program" "${study[@]/runs=6/runs=5000}" --out twice >.$which-out 2>.$which-err &
  processes+=($!)
done
wait -n -p refused_one "${processes[@]}"; code=$?
equal "exit code of one of two: $(<.first-err) $(<.second-err)" $code 1
has "$(cat .first-err .second-err)" "another ikbench is running the same study"
until [ "$(solves twice/store.sqlite 2>.polled)" -ge 5 ]; do sleep 0.02; done
kill "${processes[@]/$refused_one/}" 2>.killed
wait "${processes[@]}" 2>.waited
equal "standard output of a stopped run" "$(cat .first-out .second-out)" ""
succeeds "${study[@]}" --out twice

# A program that empties the store: the run counts what is there.
cp "$scripts/programs/thief.py" .
{
  printf 'name = "robbed"\nrobot = "ur5e"\nsearch = "all_joints"\nruns = 3\nrounds = 1\npath = { kind = "random", points = 3 }\n'
  printf 'stop = { iterations = 5 }\nsolvers = [{ label = "BA", solver = "bat" }, { label = "thief", process = ["python3", "thief.py"] }]\n'
} >robbed.toml
code=0; "$program" run robbed.toml --no-report --out robbed >.out 2>.err || code=$?
equal "exit code of a robbed run: $(<.err)" $code 2
has "$(<.err)" "of the 18 solves: another process"

# What lies in somebody else's folder is not run, and no link in it is written through.
succeeds run slim2023 "${small[@]}" --no-report --out theirs
mkdir linked
ln -s ../theirs/store.sqlite linked/store.sqlite
refused "link" "${study[@]}" --out linked
for folder in article tables figures; do
  ln -s ../theirs linked/$folder
  refused "linked/$folder' is a link" report theirs/store.sqlite twice/store.sqlite --out linked
  rm linked/$folder
done
refused "an earlier store has the same" report theirs/store.sqlite theirs/store.sqlite --out both
# Nothing is written where somebody else's file or link has a name of ours (report.test.cpp).
install -D thief.py own/tables/studies.csv
refused "own/tables/studies.csv' is there" report theirs/store.sqlite twice/store.sqlite --out own
cmp -s thief.py own/tables/studies.csv || fail "own/tables/studies.csv was written"
succeeds report theirs/store.sqlite
ln -s ../theirs/results.json own/results.json
refused "own/results.json' is there" report theirs/store.sqlite --out own

# A parent that ignores SIGCHLD takes no picture away.
(trap '' CHLD; exec "$program" report theirs/store.sqlite) >.out 2>.err || fail "a report without SIGCHLD: $(<.err)"
has_no "$(<.err)" "not drawn"

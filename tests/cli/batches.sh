#!/usr/bin/env bash
# Programs that solve in batches: each fault is that of all problems of its message, and nothing is lost by a stop.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
cp "$scripts"/programs/faulty.py "$root"/{solvers/helpers/ikbench,docs/examples/descent}.py .

# of LABEL FAULT SIZE [PATIENCE]
of() { entry "$1" "$2" "batch = $3" "${4:-60}"; }
batches() { # NAME ENTRY...
  study "$@"
  sed -i '1i start = "middle"\nrounds = 1' "$1.toml"
}

# A batch entry beside a single one: the same answers, compared; times apart.
batches both "$(entry single fine)" "$(of batch fine 5)" "$(of large fine 1000)" "$(of one fine 1)"
succeeds run both.toml --set rounds=6 --figures none --out both --json
for label in batch large one; do
  equal "answers of $label" "$(column both/store.sqlite position_error_cm $label)" "$(column both/store.sqlite position_error_cm single)"
done
json '{row["metric"] for row in of["comparisons"] if {row["first"], row["second"]} == {"single", "batch"} and row["p"] is not None} >= {"position error"}'
json 'all(row["p"] is None for row in of["comparisons"] if row["metric"] == "time" and {row["first"], row["second"]} & {"batch", "large", "one"})'
json '{row["n"] for row in of["groups"] if row["metric"] == "time" and row["solver"] in ("batch", "large", "one")} <= {0}'
json 'any("a debug build" in warning or "batch" in warning and "in batches" in warning for warning in of["warnings"])'
equal "times of a batch" "$(grep '^one' both/tables/batches.csv)" "one,1,5.0,5.0"
equal "timing" "$(column both/store.sqlite timing batch | counted)" "16 batch"
succeeds run both.toml --no-report --out whole
equal "sizes" "$(column whole/store.sqlite batch_size batch | counted | paste -sd' ')" "1 1 15 5"
equal "sizes" "$(column whole/store.sqlite batch_size large | counted | paste -sd' ')" "16 16"
equal "its own time, divided" "$(column whole/store.sqlite seconds batch | sort -u)" 0.005

# Shares of machines, two at once, and a stop in the middle of a batch: the same solves.
for shard in 1/2 2/2; do succeeds run both.toml --no-report --shard $shard --out shards/${shard%/*}; done
succeeds merge merged shards
same_fingerprint merged/store.sqlite both/store.sqlite
succeeds run both.toml --no-report --out parallel --jobs 2
same_fingerprint parallel/store.sqlite both/store.sqlite
batches stops "$(of sleeps sleeps 3)"
succeeds run stops.toml --no-report --out straight
"$program" run stops.toml --no-report --out stopped >/dev/null 2>&1 &
process=$!
until [ "$(column stopped/store.sqlite status sleeps 2>/dev/null | wc -l)" -ge 3 ]; do
  kill -0 $process || fail "it ended before it was stopped"
  sleep 0.02
done
kill -INT $process
wait $process
left=$(column stopped/store.sqlite status sleeps | wc -l)
((left < 16 && left % 3 == 0)) || fail "$left solves of a batch of 3 are stored"
succeeds run stops.toml --no-report --out stopped
same_fingerprint stopped/store.sqlite straight/store.sqlite
equal "sizes after a stop" "$(column stopped/store.sqlite batch_size sleeps | counted | paste -sd' ')" "1 1 15 3"

# Each fault is of one message, the second: whoever gives the others' answers loses none.
batches faults "$(of few "one too few" 5)" "$(of many "one too many" 5)" "$(of order "another order" 5)" \
  "$(of list "no list" 5)" "$(of year "seconds of a year" 5)" "$(of asks "a question" 5)" "$(of null "a null" 5)" \
  "$(of declines "declines one" 5)" "$(of falls falls 5)" "$(of never never 5 2)" "$(of stops "stops its parent" 5 2)" "$(of always "always falls" 5)" "$(of wrong "three wrong" 5)"
succeeds run faults.toml --no-report --out faults
for label in few many order list year asks; do is faults $label "(5 protocol_error $any|${any}5 protocol_error.*)"; done
is faults null ".*1 not_finite.*"
is faults declines "1 declined $any"
is faults falls "5 crashed $any"
for label in never stops; do is faults $label "${any}5 timed_out"; done
is faults always "16 crashed"
equal "wrong answers of a message" "$(column faults/store.sqlite status wrong | grep -c protocol_error)" 3
equal "of whom the others keep their time" "$(column faults/store.sqlite seconds wrong | grep -c NaN || true)" 0
equal "solves with a time, before it is given up" "$(column faults/store.sqlite seconds always | grep -vc NaN)" 10
err=$(tr -s '\n ' ' ' <.err)
has "$err" 'a list of 5'
has "$err" 'in the order of the problems'

# Who cannot be asked in batches is told before anything is solved (of whom it cannot be asked: foreign.sh).
batches mistake "$(of mine "one by one" 5)"
refused '"batch": true' run mistake.toml

# The helper: what solves one solves many, and check-solver asks for both.
sed 's/^ikbench.run(\(.*\))$/ikbench.run(\1, solve_batch=lambda arm, all: [solve(arm, each) for each in all])/' descent.py >many.py
batches helper '[[solvers]]' 'label = "one"' 'process = ["python3", "many.py"]' '[[solvers]]' 'label = "many"' 'process = ["python3", "many.py"]' 'batch = 4'
succeeds run helper.toml --no-report --out helper
equal "answers by the helper" "$(column helper/store.sqlite position_error_cm many)" "$(column helper/store.sqlite position_error_cm one)"
succeeds check-solver -- python3 many.py
has "$out" "batch of 20 poses"
sed 's/for each in all\]/for each in reversed(all)]/' many.py >turned.py
ends 1 check-solver -- python3 turned.py
has "$(grep FAILED <<<"$out")" "batch of 20 poses"

#!/usr/bin/env bash
# `ikbench store` shows what a store has, and removes from it without harm to the rest.
source "$(dirname "$0")/common.sh"
small=(--set runs=2 --set path.points=2 --set stop.iterations=3 --no-report --out made)
store=made/store.sqlite

succeeds run slim2023 "${small[@]}"
succeeds run slim2023-limits "${small[@]}"
succeeds store ls $store
[ "$(grep -cE '^slim2023(-limits)? +6 +2 +2 +24$' <<<"$out")" = 2 ] || fail "two studies of 24 solves: $out"
has_no "$out" unused
succeeds store show $store --study slim2023-limits
has "$out" "K-ABC"
[ "$(grep -cE '^[A-Z-]+ +[a-z_]+ +4 +[0-9a-f]{16}@' <<<"$out")" = 6 ] || fail "six solvers of 4 solves: $out"
[ "$(sed -n '/^SESSION/,$p' <<<"$out" | wc -l)" = 2 ] || fail "one session: $out"

# What no study uses any more: solves of an earlier setting, and a session that found nothing to do.
succeeds run slim2023-limits "${small[@]}" --set IK-BA.alpha=0.7
succeeds store ls $store
has "$out" "unused: 4 solves"
succeeds fingerprint $store
before=$out
succeeds store gc $store
has "$out" "removed 4 solves"
succeeds fingerprint $store
[ "$out" = "$before" ] || fail "gc changed a study: $before, then $out"
succeeds store gc $store
has "$out" "removed 0 solves and 0 sessions"

# A removed study leaves the other as it is, and no sign of a change.
succeeds store rm $store slim2023-limits
has "$out" "removed the study slim2023-limits, 24 solves"
succeeds fingerprint $store
[ "$out" = "$(grep ' slim2023$' <<<"$before")" ] || fail "rm changed the other study: $out"
succeeds report $store --no-figures --out report
has_no "$err" changed
refused "no study 'slim2023-limits'" store rm $store slim2023-limits
[ "$(sqlite3 $store "SELECT count(*) FROM meta WHERE key LIKE '%limits%'")" = 0 ] || fail "notes of the study stayed"
succeeds run slim2023-limits "${small[@]}"
succeeds run slim2023 "${small[@]}"
has_no "$err" changed

# What was edited is not made to look whole.
sqlite3 $store "UPDATE solves SET run = 9 WHERE run = 2 AND point = 1 AND solver = 'DE'"
cp $store edited.sqlite
refused "Nothing was removed." store gc $store
cmp $store edited.sqlite || fail "a refused store was changed"

# A store that a run writes stays as it is.
"$program" run slim2023 --set runs=2000 --no-report --out busy >/dev/null 2>&1 &
writer=$!
for _ in {1..100}; do [ -e busy/store.sqlite-wal ] && break || sleep 0.1; done
sleep 0.5
run_it store rm busy/store.sqlite slim2023
[ "$code" != 0 ] || fail "a store was emptied while a run wrote it"
kill -INT $writer
wait $writer
succeeds report busy/store.sqlite --no-figures --out busy-report
has_no "$err" "changed"

echo nonsense >no.sqlite
refused "is not an ikbench store" store ls no.sqlite

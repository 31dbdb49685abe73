#!/usr/bin/env bash
# The same store gives the same report, byte for byte: in another folder, at another time, in another time zone.
source "$(dirname "$0")/common.sh"

succeeds run slim2023 "${small[@]}" --no-report --out made
succeeds run slim2023-dobot "${small[@]}" --no-report --out made
succeeds run slim2023-limits "${small[@]}" --no-report --out made
succeeds report made/store.sqlite --study slim2023 --out first
sleep 1  # a picture that says when it was drawn says it in seconds
mkdir -p "another folder"/deep
cp made/store.sqlite "another folder"/theirs.sqlite
(
  cd "another folder" || exit 1
  export TZ=Asia/Kolkata HOME=$PWD USER=somebody SOURCE_DATE_EPOCH=1
  "$program" report theirs.sqlite --study slim2023 --out deep/second >/dev/null 2>&1
) || fail "no second report"
diff -r first "another folder"/deep/second >.differences || fail "two reports of one store differ: $(head -c 2000 .differences)"

types="html md json csv tex gp dat"
command -v gnuplot >/dev/null && types+=" svg pdf png"
for type in $types; do
  [ -n "$(find first -name "*.$type")" ] || fail "the report has no .$type"
done

for format in csv json; do
  succeeds export made/store.sqlite --study slim2023 --format $format -o "first.$format"
  succeeds export "another folder"/theirs.sqlite --study slim2023 --format $format -o "second.$format"
  cmp "first.$format" "second.$format" || fail "two exports of one store differ"
done

#!/usr/bin/env bash
# Each system call by which a run writes fails once: the run ends well or in one sentence and code 2, then the same command
# completes it, to the same bits.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
needs strace

study few
few=(run few.toml --figures none --out)
succeeds "${few[@]}" whole
strace -f -o calls "$program" "${few[@]}" counted >.out 2>.err || skip "strace may not trace"
for call in unlink fdatasync ftruncate fsync rename mkdir; do
  for ((i = 1; i <= $(grep -c " $call(" calls); i += i < 6 ? 1 : 7)); do
    rm -rf broken
    strace -f -o traced -e "inject=$call:error=EIO:when=$i" "$program" "${few[@]}" broken >.out 2>.err
    case $? in
      0) ;;
      2) equal "sentences where $call $i fails" "$(grep -c '^ikbench: ' .err)" 1 && succeeds "${few[@]}" broken ;;
      *) fail "$call $i fails: exit code $?: $(<.err)" ;;
    esac
    same_fingerprint broken/store.sqlite whole/store.sqlite
  done
done

# A page that cannot be read once is no damage, and no reason to make room; nor is a CSV shorter by what cannot be read.
export=("$program" export whole/store.sqlite --format fingerprint)
strace -o calls -P "$PWD/whole/store.sqlite" "${export[@]}" >.out 2>.err
for ((i = 1; i <= $(grep -c pread64 calls); ++i)); do
  strace -o traced -P "$PWD/whole/store.sqlite" -e inject=pread64:error=EIO:when=$i "${export[@]}" >.out 2>.err
  equal "code and sentence where page $i cannot be read" "$? $(tr -s ' \n' ' ' <.err)" \
    "2 ikbench: cannot read 'whole/store.sqlite': Input/output error; try again, or read a copy on another disk "
done
{ echo A,B; paste -d, <(seq 10000) <(seq 2 10001); } >long.csv
strace -o traced -P "$PWD/long.csv" -e inject=read:error=EIO:when=2 "$program" stats long.csv --better smaller >.out 2>.err
equal "code and sentence of a CSV that cannot be read" "$? $(grep -c "^ikbench: cannot read 'long.csv'" .err)" "2 1"
strace -o calls -e trace=read "$program" stats - --better smaller <long.csv >.out 2>.err
last=$(grep -c '^read(' calls)
strace -o traced -e inject=read:error=EIO:when="$last" "$program" stats - --better smaller <long.csv >.out 2>.err
equal "code and sentence of an input that cannot be read" "$? $(grep -c "^ikbench: cannot read 'standard input'" .err)" "2 1"

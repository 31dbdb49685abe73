#!/usr/bin/env bash
# Each system call by which a run writes fails once: the run ends well or in one sentence and code 2, then the same command
# completes it, to the same bits.
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
command -v strace >/dev/null || { echo "skipped: no strace"; exit 77; }

study few
few=(run few.toml --figures none --out)
succeeds "${few[@]}" whole
strace -f -o calls "$program" "${few[@]}" counted >.out 2>.err || { echo "skipped: strace may not trace"; exit 77; }
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

# A page that cannot be read once is no damage.
strace -o traced -P "$PWD/whole/store.sqlite" -e inject=pread64:error=EIO:when=5 "$program" export whole/store.sqlite --format fingerprint >.out 2>.err
equal "code and sentence of a page that cannot be read" "$? $(grep -c '^ikbench: cannot use' .err)" "2 1"

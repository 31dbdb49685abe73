#!/usr/bin/env bash
# hardening.sh PROGRAM: what a released program is linked and compiled with, read from its own bytes.
set -euo pipefail
export LC_ALL=C.UTF-8
program=$1
command -v readelf >/dev/null && command -v objdump >/dev/null || { echo "skipped: readelf and objdump are missing"; exit 77; }

has() {  # has WHAT PATTERN TEXT
  grep -qE "$2" <<<"$3" || { echo "$program has no $1: nothing matches '$2'"; exit 1; }
}
has "position-independent code" "Type: +DYN" "$(readelf -h "$program")"
dynamic=$(readelf -d "$program")
has "binding of every symbol at its start" "FLAGS.*BIND_NOW|FLAGS_1.*NOW" "$dynamic"
segments=$(readelf -lW "$program")
has "read-only relocations" "GNU_RELRO" "$segments"
has "stack that is no code" "GNU_STACK.* RW +0x" "$segments"
symbols=$(readelf --dyn-syms -W "$program")
has "stack protector" "__stack_chk_fail" "$symbols"
has "checked library function" "__[a-z]+_chk@" "$symbols"
if [[ $(uname -m) == x86_64 ]]; then
  has "marked target of jumps" "endbr64" "$(objdump -d --no-show-raw-insn --disassemble=main "$program")"
fi

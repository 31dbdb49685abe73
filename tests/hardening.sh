#!/usr/bin/env bash
# hardening.sh PROGRAM: what a released program is linked and compiled with, read from its own bytes.
source "$(dirname "$0")/cli/common.sh"
needs readelf objdump

has() {  # has WHAT PATTERN TEXT
  grep -qE "$2" <<<"$3" || fail "$program has no $1: nothing matches '$2'"
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
looks_in '(\$ORIGIN)?/[^:]+' "$program"

#!/usr/bin/env bash
# An object file of kernels defines one symbol that the linker sees: kernel_symbols.sh OBJECT SET
# The linker keeps any one definition of a weak symbol, such as an inline function: it might be compiled for another
# processor.
source "$(dirname "$0")/cli/common.sh"
object=$program set=$2
needs "${NM:=nm}"

# Type information, which clang's sanitizer adds, is data and has no instructions.
symbols=$("$NM" --extern-only --defined-only --demangle "$object" | cut -d ' ' -f 2- | grep -vE '^V (typeinfo |DW\.ref)' || true)
[[ $symbols =~ ^"T ikbench::"[a-z]+"::${set}::kernels()"$ ]] && exit
fail "expected the kernels of $set alone, found: $symbols"

#!/usr/bin/env bash
# An object file of kernels defines one symbol that the linker sees: kernel_symbols.sh SET OBJECT
# The linker keeps any one definition of a weak symbol, such as an inline function: it might be compiled for another
# processor.
set -euo pipefail
export LC_ALL=C.UTF-8
set=$1 object=$2
command -v "${NM:=nm}" >/dev/null || { echo "skipped: no nm"; exit 77; }

# Type information, which clang's sanitizer adds, is data and has no instructions.
symbols=$("$NM" --extern-only --defined-only --demangle "$object" | cut -d ' ' -f 2- | grep -vE '^V (typeinfo |DW\.ref)' || true)
[[ $symbols =~ ^"T ikbench::"[a-z]+"::${set}::kernels()"$ ]] && exit
echo "expected the kernels of $set alone, found:"
echo "$symbols"
exit 1

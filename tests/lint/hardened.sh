#!/usr/bin/env bash
# hardened.sh - the programs as built have the guards that tools/harden.sh asks the compiler and linker for.
. "$(dirname "$0")/../tap.sh"

has() { # FILE COMMAND PATTERN: what the command prints of the file
    $2 "$1" | grep -E -- "$3" || { echo "$1: no \"$3\" in what $2 prints"; return 1; }
}
lacks() { ! has "$@"; }
marked() { # OBJECT...: the C library's own objects may lack the marks, so the linked program cannot tell
    local o
    for o; do has "$o" "readelf -nW" 'IBT, SHSTK' || return; done
}
objects() { sed -n "s,^LOAD \($OUT/[^ ]*\.o\)$,\1,p" "$OUT/curtain-null.map"; }

for program in "$OUT"/curtain{,-null}; do
    check "$program: addresses are bound at its start" has "$program" "readelf -dW" '(BIND_NOW|FLAGS_1.*\bNOW\b)'
    check "$program: and read-only then" has "$program" "readelf -lW" GNU_RELRO
    check "$program: is loaded anywhere" has "$program" "readelf -hW" 'Type: *DYN'
    check "$program: no code is written to" lacks "$program" "readelf -dW" '(TEXTREL|RPATH|RUNPATH)'
    check "$program: the stack is not run" has "$program" "readelf -lW" 'GNU_STACK.* RW '
    check "$program: nothing is both written and run" lacks "$program" "readelf -lW" 'LOAD.* RWE '
    check "$program: its stack is watched" has "$program" "nm -D" '__stack_chk_fail'
    check "$program: calls of the C library are checked" has "$program" "nm -D" '__(mem|str|v?s?n?printf)[a-z]*_chk'
done
if tools/harden.sh compile "${CC:-cc}" -O2 | grep -q fcf-protection; then
    check "every object marks where jumps may land" marked $(objects)
fi
finish

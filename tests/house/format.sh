#!/usr/bin/env bash
# format.sh - every C file is as clang-format leaves it; no text has tabs, blanks at line ends or DOS line ends.
. "$(dirname "$0")/../tap.sh"

formatted() { clang-format --style=file --dry-run -Werror "$@"; }
check "all C files are formatted" formatted $(tree '*.c' '*.h')
cp .clang-format src/base/hash.c "$scratch"
echo 'int planted( void );' >>"$scratch/hash.c"
refuse "planted: a badly formatted line" "clang-format-violations" formatted "$scratch/hash.c"

clean() {
    local found
    found=$(grep -nIE $'[ \t]+$|\r' "$@"; grep -nI $'\t' "$@" | grep -vE '^(Makefile|docs/porting.md):')
    echo "$found"
    [ -z "$found" ]
}
check "no tabs, no blanks at line ends" clean $(tree '*.c' '*.h' '*.lua' '*.sh' '*.py' '*.md' Makefile .ci/run | grep -v /seeds/)
printf 'a line \n' >"$scratch/line.md"
refuse "planted: a blank at a line's end" "line.md" clean "$scratch/line.md" /dev/null
finish

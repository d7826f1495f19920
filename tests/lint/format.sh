#!/usr/bin/env bash
# format.sh - every C file is as clang-format leaves it; no text has tabs, blanks at line ends or DOS line ends; no line
# has more than 120 columns; and .editorconfig says the same.
. "$(dirname "$0")/../tap.sh"

formatted() { clang-format --style=file --dry-run -Werror "$@"; }
check "all C files are formatted" formatted $(tree '*.c' '*.h')
cp .clang-format src/base/hash.c "$scratch"
echo 'int planted( void );' >>"$scratch/hash.c"
detects "a badly formatted line" "clang-format-violations" formatted "$scratch/hash.c"

clean() {
    local found
    found=$(grep -nIE $'[ \t]+$|\r' "$@"; grep -nI $'\t' "$@" | grep -vE '^(Makefile|docs/internals/porting.md):')
    echo "$found"
    [ -z "$found" ]
}
check "no tabs, no blanks at line ends" clean \
    $(tree '*.c' '*.h' '*.lua' '*.sh' '*.py' '*.md' Makefile .ci/run | grep -v /seeds/)

# setting FILE-PATTERN NAME: what .editorconfig says in that section
setting() { sed -n "/^\[$1\]$/,/^$/s/^$2 = //p" .editorconfig; }
style() { sed -n "s/^$1: //p" .clang-format; }
agrees() {
    [ "$(setting '\*' indent_size)" = "$(style IndentWidth)" ] || { echo "indent_size is not IndentWidth"; return 1; }
    [ "$(setting '\*' max_line_length)" = "$(style ColumnLimit)" ] ||
        { echo "max_line_length is not ColumnLimit"; return 1; }
    [ "$(setting '\*' indent_style)" = space ] && [ "$(setting Makefile indent_style)" = tab ]
}
check ".editorconfig agrees with .clang-format" agrees
ends() { # FILE...: each ends in a line end
    local f
    for f in "$@"; do [ -z "$(tail -c 1 "$f")" ] || { echo "$f does not end in a line end"; return 1; }; done
}
check "every text ends in a line end" ends \
    $(tree '*.c' '*.h' '*.lua' '*.sh' '*.py' '*.md' Makefile .editorconfig '*.desktop' '*.xml' | grep -v /seeds/)
parses() {
    local f bad=0
    for f in "$@"; do bash -n "$f" || bad=1; done
    return $bad
}
check "every shell script parses" parses $(tree '*.sh' .ci/run)

# Scripts of games are left out: their bytes are in hashes that demos hold.
narrow() {
    local found
    found=$(LC_ALL=C.UTF-8 grep -nHP '^.{121,}' "$@" | cut -c 1-160)
    echo "$found"
    [ -z "$found" ]
}
sources() {
    tree '*.c' '*.h' '*.sh' '*.py' '*.lua' .ci/run | grep -vE '/seeds/|^(roms|scripts|examples|tests/demos)/.*lua$'
}
check "no line of more than 120 columns" narrow $(sources) CHANGELOG.md CONTRIBUTING.md
printf '# %0118d\n' 1 >"$scratch/line.sh"
printf '# %0119d\n' 1 >>"$scratch/line.sh"
detects "a line of 121 columns" "line.sh:2:" narrow "$scratch/line.sh"
finish

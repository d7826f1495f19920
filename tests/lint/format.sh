#!/usr/bin/env bash
# format.sh - every C file is as clang-format leaves it; no text has tabs, blanks at line ends or DOS line ends; no line
# has more than 120 columns; every shell script parses.
. "$(dirname "$0")/../tap.sh"

formatted() { clang-format --style=file --dry-run -Werror "$@"; }
check "all C files are formatted" formatted $(tree '*.c' '*.h')

texts() { tree '*.c' '*.h' '*.lua' '*.sh' '*.py' '*.md' Makefile .ci/run | grep -v /seeds/; }
blanks() { ! grep -nIE $'[ \t]+$|\r' "$@"; }
tabs() { ! grep -nI $'\t' "$@"; }
check "no blanks at line ends" blanks $(texts)
check "no tabs" tabs $(texts | grep -vx -e Makefile -e docs/internals/porting.md)
ends() { # FILE...: each ends in a line end
    local f
    for f in "$@"; do [ -z "$(tail -c 1 "$f")" ] || { echo "$f does not end in a line end"; return 1; }; done
}
check "every text ends in a line end" ends $(texts)
parse() { printf '%s\n' "$@" | xargs -n 1 bash -n; }
check "every shell script parses" parse $(tree '*.sh' .ci/run)

# Scripts of games are left out: their bytes are in hashes that demos hold.
narrow() { ! LC_ALL=C.UTF-8 grep -nHP '^.{121,}' "$@"; }
check "no line of more than 120 columns" narrow CHANGELOG.md CONTRIBUTING.md \
    $(texts | grep -vE '^(Makefile|docs/|roms/|scripts/|examples/|tests/demos/)|\.md$')
printf '# %0118d\n# %0119d\n' 1 1 >"$scratch/line.sh"
detects "a line of 121 columns" "line.sh:2:" narrow "$scratch/line.sh"
finish

#!/usr/bin/env bash
# names.sh - public functions have a prefix that says where they are from (names.py), and functions are short.
. "$(dirname "$0")/../tap.sh"

names() { python3 tests/lint/names.py "$@"; }
check "every public function has a prefix, and none has more than 100 lines" \
    names $(tree 'src/*.[ch]' 'fb/*.[ch]' 'platform/*.[ch]')
mkdir "$scratch/planted"
printf '/* struct other { */\nstruct thing {\n};\nint thing_make(void);\nint planted_too(void);\n' \
    >"$scratch/planted/planted.h"
echo 'int other_make(void);' >>"$scratch/planted/planted.h"
detects "a name from nowhere" "planted.h: other_make" names "$scratch/planted/planted.h"
{
    printf 'int f(void)\n{\n'
    for _ in $(seq 100); do echo '    f();'; done
    echo '}'
} >"$scratch/planted/long.c"
detects "a function of 101 lines" "long.c:2: a function of 101 lines" \
    names src/script/vm.h "$scratch/planted/long.c"
finish

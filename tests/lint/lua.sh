#!/usr/bin/env bash
# lua.sh - no file of the program or of a port sees Lua's headers or the board's insides, by way of other headers
# either.
. "$(dirname "$0")/../tap.sh"

# unseen FILE...: the preprocessor finds none to depend on them. -MG: headers that are not found are listed.
unseen() { ! ${CC:-cc} -std=c11 -M -MG "$@" | grep -E '(^|/)(lua|lauxlib|luaconf|lualib|machine)\.h\b'; }
check "no file of the program sees Lua or machine.h" unseen $(
    tree 'src/player/*.c' 'src/workbench/*.c' 'src/common/*.c' 'src/demo/*.c' |
    grep -v -e workbench/test/test_script -e 'pack/manifest_' -e pack/value.c
)
check "no file of a port does" unseen $(tree 'platform/*.c')
refuse "a file of the board does" "machine.h" unseen src/board/board.c
finish

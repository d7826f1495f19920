#!/usr/bin/env bash
# lua.sh - no file of the program or of a port sees Lua's headers or the board's insides, by way of other headers
# either.
. "$(dirname "$0")/../tap.sh"

# seen FILE...: fails for each that the preprocessor finds to depend on them. -MG: headers that are not found are
# listed.
seen() {
    local f found rc=0
    for f; do
        found=$(cd "$scratch" && ${CC:-cc} -std=c11 -M -MG "$f" | tr -s ' \\' '\n' |
            grep -E '(^|/)(lua|lauxlib|luaconf|lualib|machine)\.h$') || continue
        echo "$f sees" $found
        rc=1
    done
    [ $# -gt 0 ] && echo "$# files" && return $rc
}
cp -r --parents src fb platform "$scratch"
check "no file of the program sees Lua or machine.h" seen $(
    tree 'src/player/*.c' 'src/workbench/*.c' 'src/common/*.c' 'src/demo/*.c' |
    grep -v -e workbench/test/test_script -e 'pack/manifest_' -e pack/value.c
)
check "no file of a port does" seen $(tree 'platform/*.c')
check "a file of the board does" eval '! seen src/board/board.c'

# planted HEADER INCLUDE FILE: the same with one line more in a header that the file includes
planted() {
    cp "$1" "$scratch/kept"
    echo "#include $2" >>"$scratch/$1"
    seen "$3"
    local rc=$?
    cp "$scratch/kept" "$scratch/$1"
    return $rc
}
detects "Lua in the table that check reads" "check_lua.c sees lua.h" \
    planted src/script/api/api_table.h '<lua.h>' src/workbench/check/check_lua.c
finish

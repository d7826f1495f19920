#!/usr/bin/env bash
# layers.sh - every #include obeys the layers.
. "$(dirname "$0")/../tap.sh"

layers() { tree '*.c' '*.h' | xargs python3 tests/lint/layers.py; }
check "every include is of its own layer or below" layers

# planted FILE INCLUDE: the same check in a copy of the tree with one line more
planted() {
    local check=$PWD/tests/lint/layers.py
    cp -r --parents src fb platform "$scratch"
    echo "#include $2" >>"$scratch/$1"
    (cd "$scratch" && find src fb platform -name '*.[ch]' | xargs python3 "$check")
}
detects "the machine includes scripts" "higher layer" planted src/machine/work.c '"../script/vm.h"'
finish

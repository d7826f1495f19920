#!/usr/bin/env bash
# layers.sh - every #include obeys the layers.
. "$(dirname "$0")/../tap.sh"

layers() { tree '*.c' '*.h' | xargs python3 tests/lint/layers.py; }
check "every include is of its own layer or below, and no directory is large" layers
layers | sed 's/^/# /'
cycles() { python3 tests/lint/cycles.py "$OUT"; }
check "no symbol is used in a lower layer, and no cycle of objects or file is long" cycles
cycles | cut -c 1-180 | sed 's/^/# /'

long || finish

# planted FILE INCLUDE: the same checks in a copy of the tree with one line more
cp -r --parents src fb platform "$scratch"
planted() {
    cp "$1" "$scratch/kept"
    echo "#include $2" >>"$scratch/$1"
    (cd "$scratch" && find src fb platform -name '*.[ch]' | xargs python3 "$OLDPWD/tests/lint/layers.py")
    local rc=$?
    cp "$scratch/kept" "$scratch/$1"
    return $rc
}
detects "the machine includes scripts" "higher layer" planted src/machine/work.c '"../script/vm.h"'

# ---- symbols: in the copy, with the same objects ----

mkdir "$scratch/out"
cp -rs "$PWD/$OUT/src" "$PWD/$OUT/fb" "$scratch/out"
object() { # FILE TEXT: is built in the copy
    echo "$2" >"$scratch/$1"
    rm -f "$scratch/out/${1%c}o"
    ${CC:-gcc} -c -o "$scratch/out/${1%c}o" "$scratch/$1"
}
planted_cycles() { (cd "$scratch" && python3 "$OLDPWD/tests/lint/cycles.py" out); }
object src/base/up.c 'void board_tick(void); void up(void); void up(void) { board_tick(); }'
detects "base calls the board" "src/base/up.c uses board_tick of src/board/board.c, a higher layer" \
    planted_cycles
finish

#!/usr/bin/env bash
# levels.sh - what must be fast at every level of optimisation: stamps, pictures and tiles (fb/paint.h), of which
# sixteen bytes are a vector with gcc and clang, at -O2 and at -O3. Reads the compilers' output, and no clock.
. "$(dirname "$0")/../tap.sh"

vectors() { # COMPILER LEVEL FILE: instructions that work on a single byte; 110 are the rest's, 300 a loop taken apart
    local asm=$scratch/stamp.s single
    "$1" -m64 -std=c11 -fwrapv -ffp-contract=off -D_DEFAULT_SOURCE "$2" -I fb -S -o "$asm" "$3" || return
    single=$(grep -cE '[[:space:]](movb|andb|orb|movzbl)[[:space:]]' "$asm")
    [ "$single" -lt 150 ] ||
        { echo "$3: $1 $2 works on single bytes in $single instructions, expected fewer than 150"; return 1; }
    grep -qE '[[:space:]](pand|andps)[[:space:]]' "$asm" || { echo "$3: $1 $2 makes no vectors"; return 1; }
}
if [ "$(uname -m)" = x86_64 ]; then
    for compiler in gcc clang; do
        for level in -O2 -O3; do
            check "$compiler $level: stamps are vectors" vectors $compiler $level fb/stamp.c
            check "$compiler $level: tiles are vectors" vectors $compiler $level fb/tiles.c
        done
    done
    cp fb/*.h fb/stamp.c "$scratch"
    sed -i "s,\"../src,\"$PWD/src," "$scratch"/*.[ch]
    loop='for (int k = 0; k < 16; k++) to[k] = from[k] ? from[k] + add : to[k];'
    sed -i "s/^    to = paint_mix_pixels.*/$loop/" "$scratch/paint.h"
    detects "a loop over single bytes" "works on single bytes" vectors gcc -O3 "$scratch/stamp.c"
else
    check "nothing to read on $(uname -m): the instructions' names are x86-64's" true
fi
finish

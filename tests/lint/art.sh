#!/usr/bin/env bash
# art.sh - the pictures in roms/, the sandbox's own, those of the games that `curtain new` writes and the icons are what
# roms/glasstide/source/art/art.c draws, pixel by pixel, with gcc and clang.
. "$(dirname "$0")/../tap.sh"
sandbox

compare() { # WHAT ROM MODE
    local dir=$1-${2//\//-} picture
    mkdir -p "$dir"
    "./$1" "$dir" ${3:+"$3"} || { not_ok "$1 draws $2"; return; }
    for picture in "$repo/$2/art"/*.png; do
        python3 "$repo/tests/golden/png.py" "$picture" "$dir/$(basename "$picture")" difference.png >why 2>&1 ||
            { not_ok "$2/$(basename "$picture") is what $1 draws" "$(cat why)"; return; }
    done
    same "$2 has no picture that $1 does not draw" "$(cd "$repo/$2/art" && ls -- *.png)" "$(ls "$dir")"
}

parts() { # WHAT MODE DIR PICTURE...: these pictures of a folder are what the program draws in this mode
    local picture
    mkdir -p "$1-$2" && "./$1" "$1-$2" $2 || return
    for picture in "${@:4}"; do
        python3 "$repo/tests/golden/png.py" "$repo/$3/$picture.png" "$1-$2/$picture.png" difference.png || return
    done
}

for picture in "$repo"/examples/{pattern,bulletml}/art/*.png; do
    name=$(basename "$picture") game=${picture%/art/*}
    check "${game##*/}'s $name is the shooter's" cmp "$picture" "$repo/examples/shooter/art/$name"
done
for cc in gcc clang; do
    opt=-O2
    [ $cc = gcc ] || opt=-O0
    $cc -std=c11 $opt -ffp-contract=off -w "$repo"/roms/glasstide/source/art/*.c -lm -o art-$cc ||
        { not_ok "$cc builds roms/glasstide/source/art/art.c"; continue; }
    compare art-$cc roms/glasstide
    compare art-$cc roms/testcard card
    compare art-$cc roms/bench bench
    compare art-$cc roms/cookbook cookbook
    compare art-$cc examples/shooter night
    check "the sandbox's own pictures are what art-$cc draws" \
        parts art-$cc glow examples/sandbox/art glow items tiles
    check "the icons are what art-$cc draws" parts art-$cc icon share/icons 48 128 256
done
finish

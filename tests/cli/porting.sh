#!/usr/bin/env bash
# porting.sh - docs/porting.md: its commands run, the template links and ends at once, the seam's functions are all
# named.
. "$(dirname "$0")/../pages.sh"
compiler=${CC:-cc}

blocks docs/porting.md

template() {
    "$compiler" -std=c11 -Wall -Wextra -Werror -c platform/template.c -o "$scratch/template.o" &&
        "$compiler" "$OUT"/src/base/*.o "$OUT"/fb/*.o "$OUT"/src/snd/*.o "$OUT"/src/chips/*.o "$OUT"/src/chips/*/*.o \
            "$OUT"/src/board/*.o "$OUT"/src/board/*/*.o "$OUT"/src/board/*/*/*.o \
            "$OUT"/src/cab/*.o "$OUT"/src/cab/*/*.o \
            "$OUT/platform/stdio.o" "$OUT/gen/std.o" "$OUT/gen/rom.o" "$scratch/template.o" \
            $(pkg-config --libs lua5.4) -lm -pthread -o "$scratch/mine" &&
        "$scratch/mine" play roms/testcard
}
check "the template links, and its play ends at once" template

seam() {
    grep -oE "^[a-z0-9_ ]+ plat_[a-z]+\(" platform/platform.h | grep -v inline | grep -oE "plat_[a-z]+" | sort -u
}
named() { # PAGE
    local f bad=0
    for f in $(seam); do
        grep -q "$f" "$1" || { echo "$1: $f is not named"; bad=1; }
    done
    return $bad
}
count() { [ "$(seam | wc -l)" = 31 ]; }
check "the seam has 31 functions" count
check "README names them all" named README.md
check "the page on porting names them all" named docs/porting.md
grep -v plat_alarm README.md >"$scratch/bad.md"
refuse "planted: a function left out" "plat_alarm" named "$scratch/bad.md"
finish

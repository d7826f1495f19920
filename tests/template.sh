#!/usr/bin/env bash
# template.sh - the port to copy: it compiles without a warning, links, and its play ends at once; all that needs no
# window works.
. "$(dirname "$0")/tap.sh"
compiler=${CC:-cc}

template() {
    "$compiler" -std=c11 -Wall -Wextra -Werror -c platform/template.c -o "$scratch/template.o" &&
        "$compiler" "$OUT"/fb/*.o \
            $(find src -name '*.c' ! -path 'src/lib/*' ! -path src/player/main.c | sed "s,^,$OUT/,; s,c\$,o,") \
            "$OUT"/platform/{stdio,posix,posix_process}.o "$OUT/gen/std.o" "$OUT/gen/rom.o" "$scratch/template.o" \
            $(pkg-config --libs lua5.4) -lm -pthread -o "$scratch/mine" &&
        "$scratch/mine" play roms/testcard
}
check "the template links, and its play ends at once" template
same "the test card has the hash that it has everywhere" "$("$OUT/curtain-null" hash roms/testcard --frames 60)" \
    "$("$scratch/mine" hash roms/testcard --frames 60)"
finish

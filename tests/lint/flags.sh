#!/usr/bin/env bash
# flags.sh - flags that change results are refused: by the compiler, or by a sentence when the program starts.
. "$(dirname "$0")/../tap.sh"

flags="-std=c11 -fwrapv -ffp-contract=off -O2"
cat >"$scratch/main.c" <<'EOL'
#include <stdio.h>
#include "src/base/ieee.h"
int main(void)
{
    const char *wrong = ieee_find_fault();
    if (wrong)
        puts(wrong);
    return wrong ? 3 : 0;
}
EOL
# Without these macros the compiler does not report its flags, and the program itself must find them.
silent="-U__FAST_MATH__ -U__ASSOCIATIVE_MATH__ -U__RECIPROCAL_MATH__ -U__NO_SIGNED_ZEROS__ -U__FINITE_MATH_ONLY__"

built() { # COMPILER FLAG...: compiles the sums, then does them
    $1 $flags "${@:2}" -I. "$scratch/main.c" src/base/ieee.c -o "$scratch/sums" -lm && "$scratch/sums"
}
for compiler in gcc clang; do
    for level in -O0 -O3 '-O3 -march=native -fno-math-errno -fno-trapping-math'; do
        check "$compiler $level is fine" built $compiler $level
    done
    refuse "$compiler -ffast-math does not compile" "build without -ffast-math" built $compiler -ffast-math
    while read -r changes sentence; do
        refuse "$compiler ${changes//,/ }, silent" "$sentence" built $compiler ${changes//,/ } $silent
    done <<'END'
-ffinite-math-only NaN or infinity is ignored
-fno-signed-zeros NaN or infinity is ignored
-freciprocal-math divisions become multiplications by reciprocals
-fassociative-math,-fno-signed-zeros,-fno-trapping-math sums are reordered
END
    ! grep -qw fma /proc/cpuinfo ||
        refuse "$compiler -ffp-contract=fast" "multiplications and additions are fused" \
            built $compiler -mfma -ffp-contract=fast
done
refuse "gcc -fsingle-precision-constant" "build without -fsingle-precision-constant" built gcc \
    -fsingle-precision-constant
[ "$(uname -m)" != x86_64 ] ||
    refuse "gcc -mfpmath=387" "evaluated without excess precision" built gcc -mfpmath=387

# The program, of which only the sums were compiled so, refuses every command that powers a board.
objects() { sed -n "s,^LOAD \($OUT/.*\.o\)$,\1,p" "$OUT/curtain-null.map" | grep -v base/ieee.o; }
link() {
    clang $flags -freciprocal-math -c src/base/ieee.c -o "$scratch/sums.o" &&
        ${CC:-cc} $(objects) "$scratch/sums.o" $(pkg-config --libs lua5.4) -lm -pthread -o "$scratch/curtain"
}
check "a program with such sums links" link
for command in "hash roms/testcard --frames 1" "pack roms/testcard -o $scratch/x.rom" "check roms/testcard"; do
    refuse "it refuses to ${command%% *}" "curtain: built with flags that change results: divisions become" \
        "$scratch/curtain" $command
done
# So does a board that another program powers on.
cat >"$scratch/power.c" <<'EOL'
#include <stdio.h>
#include "src/board/board.h"
int main(void)
{
    static _Alignas(64) uint8_t bytes[1 << 20], ram[64 << 20];
    struct board_start start = { .difficulty = -1, .dip = { 1, 1, 1, 1 } };
    char err[512] = "";
    struct rom rom;
    FILE *f = fopen("tests/demos/frozen.rom", "rb");
    if (rom_open(&rom, bytes, fread(bytes, 1, sizeof bytes, f), err, sizeof err))
        board_power_on(ram, sizeof ram, &rom, &start, err, sizeof err);
    puts(err);
    return *err != 0;
}
EOL
powers() { # OBJECT: the sums
    ${CC:-cc} $flags -I. "$scratch/power.c" $(objects | grep -v workbench/main.o) "$1" \
        $(pkg-config --libs lua5.4) -lm -pthread -o "$scratch/power" && "$scratch/power"
}
check "a board is powered on" powers "$OUT/src/base/ieee.o"
refuse "a board with such sums is not" "built with flags that change results: divisions become" \
    powers "$scratch/sums.o"
check "it has help" "$scratch/curtain" help
check "it reports its flags" bash -c "'$scratch/curtain' version | grep '^flags'"
finish

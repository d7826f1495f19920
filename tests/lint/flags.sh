#!/usr/bin/env bash
# flags.sh - flags that change results are refused: by the compiler, or by a sentence when the program starts. And those
# that change none are not.
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
# What the compiler tells by macros is asked once more of the program, as if it told nothing.
silent="-U__FAST_MATH__ -U__ASSOCIATIVE_MATH__ -U__RECIPROCAL_MATH__ -U__NO_SIGNED_ZEROS__ -U__FINITE_MATH_ONLY__"

built() { # COMPILER FLAG...: compiles the sums; then does them
    $1 $flags "${@:2}" -I. "$scratch/main.c" src/base/ieee.c -o "$scratch/sums" -lm && "$scratch/sums"
}
fma() { grep -qw fma /proc/cpuinfo; }

for compiler in gcc clang; do
    for level in -O0 -O1 -O2 -O3 -Os; do
        check "$compiler $level is fine" built $compiler $level
    done
    check "$compiler -O3 -march=native is fine" built $compiler -O3 -march=native
    check "$compiler -fno-math-errno -fno-trapping-math is fine" built $compiler -fno-math-errno -fno-trapping-math
    check "$compiler -frounding-math is fine" built $compiler -frounding-math
    for flag in -ffast-math -Ofast; do
        refuse "$compiler $flag does not compile" "build without -ffast-math" built $compiler $flag
        refuse "$compiler $flag, silent, divides" "divisions become multiplications by reciprocals" \
            built $compiler $flag $silent
    done
    while read -r flags_of sentence; do
        refuse "$compiler ${flags_of//,/ }, silent" "$sentence" built $compiler ${flags_of//,/ } $silent
    done <<'END'
-ffinite-math-only NaN or infinity is ignored
-fno-signed-zeros NaN or infinity is ignored
-freciprocal-math divisions become multiplications by reciprocals
-fassociative-math,-fno-signed-zeros,-fno-trapping-math sums are reordered
END
    if fma; then
        refuse "$compiler -ffp-contract=fast" "multiplications and additions are fused" \
            built $compiler -mfma -ffp-contract=fast
    fi
done
for flag in -freciprocal-math -funsafe-math-optimizations -fno-signed-zeros; do
    refuse "gcc $flag does not compile" "build without -ffast-math" built gcc $flag
    refuse "clang $flag compiles and is refused" "built with flags that change results" built clang $flag
done
refuse "clang -fno-honor-nans" "NaN or infinity is ignored" built clang -fno-honor-nans
refuse "clang -fno-honor-infinities" "NaN or infinity is ignored" built clang -fno-honor-infinities
if fma; then
    refuse "clang -ffp-contract=on" "multiplications and additions are fused" built clang -mfma -ffp-contract=on
fi
refuse "gcc -fsingle-precision-constant" "build without -fsingle-precision-constant" built gcc \
    -fsingle-precision-constant
if [ "$(uname -m)" = x86_64 ]; then
    refuse "gcc -mfpmath=387" "evaluated without excess precision" built gcc -mfpmath=387
    refuse "gcc -mfpmath=both" "evaluated without excess precision" built gcc -mfpmath=both
fi

# The program, of which only the sums were compiled so: it says why it does nothing.
whole() { # WORD...: what it prints, and its exit code
    "$scratch/curtain" "$@" 2>&1
    echo "exit $?"
}
objects() { sed -n "s,^LOAD \($OUT/.*\.o\)$,\1,p" "$OUT/curtain-null.map" | grep -v base/ieee.o; }
link() {
    clang $flags -freciprocal-math -c src/base/ieee.c -o "$scratch/sums.o" &&
        ${CC:-cc} $(objects) "$scratch/sums.o" $(pkg-config --libs lua5.4) -lm -pthread -o "$scratch/curtain"
}
said="curtain: built with flags that change results: divisions become multiplications by reciprocals \
(-freciprocal-math, -funsafe-math-optimizations, -ffast-math)
exit 3"
check "a program with such sums links" link
for command in "hash roms/testcard --frames 1" "pack roms/testcard -o $scratch/x.rom" \
    "verify roms/testcard roms/testcard/demos/card.demo" \
    "check roms/testcard" "play roms/testcard"; do
    check "it refuses to ${command%% *}" [ "$(whole $command)" = "$said" ]
done
check "it tells its flags" bash -c "'$scratch/curtain' version | grep '^flags'"
check "it helps" "$scratch/curtain" help

# A program of somebody else's that powers a board.
cat >"$scratch/power.c" <<'EOL'
#include <stdio.h>
#include <stdlib.h>
#include "src/board/board.h"
int main(void)
{
    static uint8_t bytes[1 << 20];
    struct board_start start = { .difficulty = -1, .dip = { 1, 1, 1, 1 } };
    char err[512] = "";
    struct rom rom;
    size_t size;
    FILE *f = fopen("tests/demos/frozen.rom", "rb");
    if (!rom_open(&rom, bytes, fread(bytes, 1, sizeof bytes, f), err, sizeof err) ||
        !board_size(&rom, &size, err, sizeof err) ||
        !board_power_on(aligned_alloc(64, (size + 63) / 64 * 64), size, &rom, &start, err, sizeof err))
        puts(err);
    return *err != 0;
}
EOL
host() { # OBJECT: the sums
    ${CC:-cc} $flags -I. "$scratch/power.c" $(objects | grep -v workbench/main.o) "$1" \
        $(pkg-config --libs lua5.4) -lm -pthread -o "$scratch/host" && "$scratch/host"
}
check "a board is powered" host "$OUT/src/base/ieee.o"
refuse "a board with such sums is not" "built with flags that change results: divisions become" host "$scratch/sums.o"
check "the program as built is fine" "$OUT/curtain-null" hash roms/testcard --frames 1
finish

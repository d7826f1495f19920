#!/usr/bin/env bash
# sound.sh - docs/measured/sound.md says what the ear measures: every figure and plot is computed again.
measured=sound
. "$(dirname "$0")/../measured.sh"
ear=$OUT/ear

same_page() { diff -B -I "^Measured at commit" "$1" "$scratch/new/sound.md"; }
same_plots() { diff -r "$1" "$scratch/new/sound"; }

mkdir "$scratch/new"
check "no figure is below its mark" "$ear" --out "$scratch/new"
check "docs/measured/sound.md has the figures the ear finds" same_page "$page"
check "docs/measured/sound has the plots the ear draws" same_plots docs/measured/sound
plots_hold 3 1 polyline

planted "another alias" "-99.9 dB" '/^| alias of a saw/s/-[0-9.]* dB/-99.9 dB/' same_page
planted "another click" "167" '/stolen by another note/s/168/167/' same_page
cp -r docs/measured/sound "$scratch/plots"
sed -i '0,/ [0-9]*\.[0-9],/s// 1.1,/' "$scratch/plots/limiter.svg"
detects "another plot" "limiter" same_plots "$scratch/plots"

# An engine without tails: the voice that is taken clicks.
mkdir -p "$scratch/copy/src"
ln -s "$PWD/src/base" "$scratch/copy/src/"
cp -r src/sound "$scratch/copy/src/sound"
sed -i 's/copy_slots(s, VOICES + voice, voice, 1);/& s->inst[VOICES + voice] = 0;/' \
    "$scratch/copy/src/sound/voices.c"
without_tails() {
    ! cmp -s src/sound/voices.c "$scratch/copy/src/sound/voices.c" || return 2
    ${CC:-cc} -std=c11 -fwrapv -ffp-contract=off -O2 -w -D_DEFAULT_SOURCE -c "$scratch/copy/src/sound/voices.c" \
        -o "$scratch/voices.o" || return 2
    # shellcheck disable=SC2046
    ${CC:-cc} -o "$scratch/ear" "$OUT"/tools/sound/*.o "$OUT"/tools/report/*.o "$scratch/voices.o" \
        $(find src -name '*.c' ! -path 'src/lib/*' ! -name voices.c ! -name main.c | sed "s,^,$OUT/,; s,c\$,o,") \
        "$OUT"/fb/*.o "$OUT"/gen/std.o "$OUT"/gen/no_rom.o "$OUT"/platform/{null,stdio,posix,posix_process}.o \
        $(pkg-config --libs lua5.4) -lm -pthread || return 2
    "$scratch/ear" --out "$scratch/new" clicks
}
detects "voices without tails" "does not hold: largest second difference when a voice is stolen" without_tails
finish

#!/usr/bin/env bash
# builds.sh - the unit tests in other builds than make test's: with clang and UBSan, where undefined behaviour, an
# overflow too, ends the program, and in 32 bits where this machine can; and the sound of a whole run, the same bytes
# with gcc and clang, at -O0 to -O3, and for this processor alone.
#
#     tests/builds.sh
#
# No warning is allowed. 32 bits are those of gcc -m32 with i386's libraries; or else of the cross compiler that make
# cross has, whose program runs every demo instead. A machine with neither says so in one line. Needs what make test
# needs. The last line is "N passed, N failed". Exit 1: something failed.
set -u
cd "$(dirname "$0")/.." || exit 2
passed=0 failed=0
cc32=${CC32:-gcc -m32 -msse2 -mfpmath=sse} # CC32: another compiler, to try this script with
mkdir -p build

unit() { # NAME COMPILER [VARIABLE=VALUE...]: builds the unit tests and test_extremes in build/NAME and runs them
    local name=$1 compiler=$2 said=build/$1.said p=0 f=1 programs
    shift 2
    programs="$(ls tests/unit/test_*.c | sed "s,^tests/,build/$name/,; s,\.c\$,,") build/$name/machine/test_extremes"
    if make --no-print-directory -s -j2 CONFIG="$name" CC="$compiler" BUILD_CC=gcc CFLAGS=-Werror "$@" $programs \
        >"$said" 2>&1; then
        OUT=build/$name tests/run.sh sanitizer | tee "$said" | sed "\$d; s,^unit/,$name/,"
        read -r p f < <(sed -n '$s/^\([0-9]*\) passed, \([0-9]*\) failed$/\1 \2/p' "$said")
    else
        grep -v '^  ' "$said" | tail -n 20
        echo "$name: the unit tests do not build"
    fi
    passed=$((passed + ${p:-0})) failed=$((failed + ${f:-1}))
}

# Does a program with the unit tests' libraries link?
links_32() {
    echo 'int main(void) { return 0; }' |
        $cc32 -x c - -o build/probe32 $(pkg-config --libs lua5.4) -lcmocka -lquadmath -lm -pthread >/dev/null 2>&1 &&
        build/probe32
}

cross_32() { # every demo, in the i386 build of make cross
    if tools/lab/cross/run.sh i386; then passed=$((passed + 1)); else failed=$((failed + 1)); fi
}

game=roms/glasstide
demo=$game/demos/run.demo

heard() { # NAME COMPILER OPT: builds the program in build/NAME; $digest: of the sound of the demo's whole run
    local program=build/$1/curtain-bare wav=build/$1.wav
    digest=none
    make --no-print-directory -s -j2 CONFIG="$1" CC="$2" BUILD_CC=gcc OPT="$3" "$program" >"$wav.said" 2>&1 || return
    frames=${frames:-$("$program" hash $game --demo $demo 2>/dev/null | tail -n 1 | cut -d ' ' -f 1)}
    "$program" render $game --demo $demo --frames "$frames" --wav "$wav" -o "$wav.frames" >"$wav.said" 2>&1 || return
    [ -s "$wav" ] && digest=$(sha256sum <"$wav")
    rm -r "$wav" "$wav.frames"
}

same_sound() { # NAME COMPILER OPT
    heard "$@"
    if [ "$digest" = "$want" ] && [ "$digest" != none ]; then
        echo "ok   $1: the sound of the run, ${digest%% *}"
        passed=$((passed + 1))
    else
        echo "FAIL $1: the sound of the run is ${digest%% *}, expected ${want%% *}"
        failed=$((failed + 1))
    fi
}

heard release gcc -O2
want=$digest
# These three are there already where tests/cli/roundtrip.sh has run.
same_sound cross-o0 gcc -O0
same_sound cross-o3 gcc "-O3 -ftree-vectorize"
same_sound cross-clang clang -O2
same_sound gcc-native gcc "-O2 -march=native"
same_sound clang-O3 clang -O3
undefined=undefined,float-cast-overflow
unit clang clang SEMANTIC="-std=c11 -ffp-contract=off" OPT="-O1 -fsanitize=$undefined -fno-sanitize-recover=$undefined"
if links_32; then
    unit m32 "$cc32"
elif tools/deps.sh --say cross >/dev/null 2>&1; then
    cross_32
else
    echo "32 bits: not built; it takes gcc-multilib and i386's liblua5.4-dev and libcmocka-dev, or make deps-cross"
fi
echo "$passed passed, $failed failed"
[ $failed = 0 ]

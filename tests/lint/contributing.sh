#!/usr/bin/env bash
# contributing.sh - CONTRIBUTING.md and docs/internals/how-to.md are true: the files they name exist; the API function,
# the chip and the tests compile without a warning and work; the commit message follows its own rule.
. "$(dirname "$0")/../tap.sh"
cat CONTRIBUTING.md docs/internals/how-to.md >"$scratch/both.md"
page=$scratch/both.md

names() { # PAGE: files that are not the examples' own
    local file bad=0
    for file in $(grep -oE '`(src|fb|docs|roms|scripts|tests|tools)/[A-Za-z0-9_./-]+`' "$1" | tr -d '`' | sort -u); do
        case $file in *ripples.[ch] | *NAME* | *GAME*) continue ;; esac
        [ -e "$file" ] || { echo "$1: there is no $file"; bad=1; }
    done
    return $bad
}
check "the files it names are there" names $page
for internal in docs/internals/*.md; do
    check "the files that $internal names are there" names "$internal"
done
echo 'See `src/entities/gone.c`.' >"$scratch/page.md"
detects "one is not" "src/entities/gone.c" names "$scratch/page.md"

# find_block KIND TEXT: the block of C or shell that has the text, without its indent
find_block() {
    python3 -c '
import re, sys, textwrap
page, kind, text = open(sys.argv[1]).read(), sys.argv[2], sys.argv[3]
blocks = re.findall("^ *```%s\\n(.*?)^ *```$" % kind, page, re.M | re.S)
print(textwrap.dedent(next(block for block in blocks if text in block)), end="")' $page "$@"
}

# The sample of style is a function as it is.
sample() { # FILE
    find_block c 'void pal_fade' >"$scratch/sample" &&
        python3 -c 'import sys; sys.exit(open(sys.argv[1]).read() not in open(sys.argv[2]).read())' \
            "$scratch/sample" "$1"
}
check "the sample of code is src/machine/video/pal.c's" sample src/machine/video/pal.c

# What the examples add, in a copy of the source.
copy=$scratch/copy
mkdir -p "$copy/tests"
cp -r src fb platform "$copy/"
cp -r tests/machine tests/test.h "$copy/tests/"
lua=$(pkg-config --cflags lua5.4)
compile() { # ARGUMENT...: by the Makefile's flags, without a warning
    gcc -std=c11 -fwrapv -ffp-contract=off -D_DEFAULT_SOURCE \
        $(sed -n 's/^WARN *:= //p' Makefile) -Werror ${lua//-I/-isystem } "$@"
}
# The program's objects, but for those named, which are the copy's.
objects() { # NAME...
    local not
    not=$(printf -- '-e /%s ' workbench/main.o gen/rom.o "$@")
    sed -n "s,^LOAD \($OUT/.*\.o\)$,\1,p" "$OUT/curtain-null.map" | grep -v $not
}
libraries() { pkg-config --libs lua5.4; echo -lm -pthread; }

chip() {
    { echo '#include "../base/fx.h"'; echo '#include "../base/slots.h"'; find_block c 'struct ripples {'; } \
        >"$copy/src/entities/ripples.h" &&
        { echo '#include "ripples.h"'; find_block c 'COLUMN(ripples, x)'; } >"$copy/src/entities/ripples.c" &&
        compile -c "$copy/src/entities/ripples.c" -o "$scratch/ripples.o"
}
check "its chip compiles" chip

# The function of the API, in a program that says what three calls give.
signs='local n = 0 for i = 1, 1000 do local s = rng.sign() assert(s == 1 or s == -1) n = n + s end '
signs+='assert(n > -200 and n < 200)'
api() {
    find_block c 'int rng_sign(' >"$scratch/sign.c" && find_block c '"rng.sign"' >"$scratch/row" &&
        sed -e "/^#include \"api.h\"/r $scratch/sign.c" -e "/^static const struct api_entry entries/r $scratch/row" \
            src/script/api/api_rng.c >"$copy/src/script/api/api_rng.c" || return
    compile "$copy/src/script/api/api_rng.c" $(objects script/api/api_rng.o) \
        "$OUT/gen/no_rom.o" "$OUT/src/workbench/main.o" $(libraries) -o "$scratch/curtain" &&
        mkdir -p "$scratch/game" && cp -r examples/first/* "$scratch/game/" &&
        echo "$signs" >"$scratch/game/main.lua" && "$scratch/curtain" hash "$scratch/game" --frames 2 &&
        "$scratch/curtain" help lua rng.sign | grep -q -- '-1 or 1'
}
check "its function of the API does what it says" api

unit() {
    { printf '#include "%s"\n' test.h ../src/base/rng.h; find_block c 'TEST(seed'; } \
        >"$copy/tests/unit.c" &&
        compile "$copy/tests/unit.c" -lcmocka -o "$scratch/unit" && "$scratch/unit"
}
check "its unit test passes" unit
root=$PWD
script() {
    mkdir -p "$scratch/script/tests/scripts" &&
        find_block lua 'bullet.def(' >"$scratch/script/tests/scripts/orb.lua" || return
    (cd "$scratch/script" && "$root/$OUT/machine/test_scripts")
}
check "its script test passes" script
machine() {
    { echo '#include "rig.h"'; find_block c 'TEST(leaves'; } >"$copy/tests/machine/leaves.c" &&
        compile "$copy/tests/machine/leaves.c" $(objects) "$OUT/gen/no_rom.o" $(libraries) -lcmocka \
            -o "$scratch/machine" && "$scratch/machine"
}
check "its test of a board passes" machine
shell() {
    mkdir -p "$scratch/shell/tests/lint" "$scratch/shell/docs/reference"
    cp tests/tap.sh "$scratch/shell/tests/" && cp docs/reference/api.md "$scratch/shell/docs/reference/" &&
        find_block sh 'tap.sh' >"$scratch/shell/tests/lint/first.sh" &&
        bash "$scratch/shell/tests/lint/first.sh"
}
check "its shell test passes" shell
finish

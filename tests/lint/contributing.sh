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

# The n-th block of C or shell, without its indent, into a file.
block() { # KIND N
    awk -v kind="$1" -v want="$2" '
        $0 ~ "^ *```" kind "$" { on = ++n == want; match($0, /^ */); indent = RLENGTH; next }
        /^ *```$/ { on = 0 }
        on { print substr($0, indent + 1) }' $page
}
# Each example by something that only it has.
find_block() { # WORDS
    local n
    for n in $(seq 30); do
        block c "$n" | grep -qF -- "$1" && { block c "$n"; return; }
    done
    echo "there is no block with $1" >&2
    return 1
}

# The sample of style is a function as it is.
sample() {
    find_block 'void pal_fade' >"$scratch/sample" &&
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
    { echo '#ifndef R'; echo '#define R'; echo '#include "../base/fx.h"'; echo '#include "../base/slots.h"'
        find_block 'struct ripples {'; echo '#endif'; } >"$copy/src/entities/ripples.h" &&
        { echo '#include "ripples.h"'; find_block 'COLUMN(ripples, x)'; } >"$copy/src/entities/ripples.c" &&
        compile -c "$copy/src/entities/ripples.c" -o "$scratch/ripples.o" &&
        clang-format --style=file:.clang-format --dry-run -Werror \
            "$copy/src/entities/ripples.c" "$copy/src/entities/ripples.h"
}
check "its chip compiles" chip

# The function of the API, in a program that says what three calls give.
signs='local n = 0 for i = 1, 1000 do local s = rng.sign() assert(s == 1 or s == -1) n = n + s end '
signs+='assert(n > -200 and n < 200)'
api() {
    find_block 'int rng_sign(' >"$scratch/sign.c" && find_block '"rng.sign"' >"$scratch/row" &&
        awk -v sign="$scratch/sign.c" -v row="$scratch/row" '
            /^static const struct api_entry entries/ { while ((getline line <sign) > 0) print line }
            { print }
            /^static const struct api_entry entries/ { while ((getline line <row) > 0) print line }' \
            src/script/api/api_rng.c >"$copy/src/script/api/api_rng.c" || return
    grep -q '^static int rng_sign' "$copy/src/script/api/api_rng.c" || return
    compile "$copy/src/script/api/api_rng.c" $(objects script/api/api_rng.o) \
        "$OUT/gen/no_rom.o" "$OUT/src/workbench/main.o" $(libraries) -o "$scratch/curtain" &&
        mkdir -p "$scratch/game" && cp -r examples/first/* "$scratch/game/" &&
        echo "$signs" >"$scratch/game/main.lua" && "$scratch/curtain" hash "$scratch/game" --frames 2 &&
        "$scratch/curtain" help lua rng.sign | grep -q -- '-1 or 1'
}
check "its function of the API does what it says" api

unit() {
    { printf '#include "%s"\n' test.h ../src/base/rng.h; find_block 'TEST(seed'; } \
        >"$copy/tests/unit.c" &&
        compile "$copy/tests/unit.c" -lcmocka -o "$scratch/unit" && "$scratch/unit"
}
check "its unit test passes" unit
root=$PWD
script() {
    mkdir -p "$scratch/script/tests/scripts" && block lua 2 >"$scratch/script/tests/scripts/orb.lua" &&
        grep -q '^--case' "$scratch/script/tests/scripts/orb.lua" || return
    (cd "$scratch/script" && "$root/$OUT/machine/test_scripts")
}
check "its script test passes" script
machine() {
    { echo '#include "rig.h"'; find_block 'TEST(leaves'; } >"$copy/tests/machine/leaves.c" &&
        compile "$copy/tests/machine/leaves.c" $(objects) "$OUT/gen/no_rom.o" $(libraries) -lcmocka \
            -o "$scratch/machine" && "$scratch/machine"
}
check "its test of a board passes" machine
shell() {
    mkdir -p "$scratch/shell/tests/lint" "$scratch/shell/docs/reference"
    cp tests/tap.sh "$scratch/shell/tests/" && cp docs/reference/api.md "$scratch/shell/docs/reference/" &&
        block sh 5 >"$scratch/shell/tests/lint/first.sh" &&
        bash "$scratch/shell/tests/lint/first.sh"
}
check "its shell test passes" shell
mutant() {
    sed -n '/^### Mutant/,/^### Fuzz/s/^    //p' $page >"$scratch/list" && tests/mutants.py check "$scratch/list"
}
check "its mutant has the list's format" mutant
subject() {
    local line
    line=$(sed -n '/^## Commits/,/^## /s/^    //p' $page | head -n 1)
    [ ${#line} -le 60 ] && [[ $line =~ ^[a-z_-]+:\ .+ ]]
}
check "its subject follows its own rule" subject
finish

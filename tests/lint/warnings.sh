#!/usr/bin/env bash
# warnings.sh - every C file that make compiles is free of warnings by the Makefile's own flags (WARN and its
# exceptions).
. "$(dirname "$0")/../tap.sh"

# commands [VARIABLE=VALUE...]: a line for each file that make compiles: its flags and its name
commands() {
    local proofs
    proofs=$(basename -s .c tools/lab/prove/{roots,sines,polar,directions,products,shapes,digest}.c)
    make -n -B CONFIG=release V=1 CC=gcc "$@" programs tools build/release/given/fuzz_rom \
        $(printf 'build/release/prove/%s ' $proofs) | grep '^gcc ' |
        sed -E 's/ -o [^ ]+//; s/ [^ ]+\.o\b//g; s/ -(MMD|MP|c|pie|Wl,[^ ]*|l[a-z0-9.]+)\b//g' |
        grep -E ' [a-z0-9_/]+\.c( |$)' | grep -v ' build/release/gen/' | sort -u
}
quiet() { xargs -P 2 -d '\n' -I LINE sh -c 'LINE -Werror -fsyntax-only' <"$1"; }
commands >"$scratch/commands"
check "no warning" quiet "$scratch/commands"
printf 'void f(void);\nvoid g(void);\nvoid g(void)\n{\n    return f();\n}\n' >"$scratch/planted.c"
sed -n "s,src/base/hash\.c,$scratch/planted.c,p" "$scratch/commands" >"$scratch/planted"
detects "what ISO C forbids" "Werror=pedantic" quiet "$scratch/planted"
finish

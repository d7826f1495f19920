#!/usr/bin/env bash
# unsorted.sh - that a build which diverges is found out: one of today's objects in which pairs leaves strings in the
# order Lua has them in, another in every run, must not hold a demo, and the first frame and part that differ are named.
#
#     tools/lab/cross/unsorted.sh OUT DEMO      OUT: a build folder; DEMO: of tests/cross/keys
#
# Prints what verify said. Exit 1: it was not found out.
set -eu
cd "$(dirname "$0")/../../.."
out=$1 demo=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

sorted='if (k.has_strings || !k.is_ascending)'
[ "$(grep -cF "$sorted" src/script/lua/luatable.c)" = 1 ] ||
    { echo "unsorted.sh: src/script/lua/luatable.c has no line to change"; exit 1; }
sed 's/if (k\.has_strings || !k\.is_ascending)/if (!k.has_strings \&\& !k.is_ascending)/' src/script/lua/luatable.c \
    >"$scratch/luatable.c"
# shellcheck disable=SC2046
${CC:-cc} -std=c11 -fwrapv -ffp-contract=off -O2 -D_DEFAULT_SOURCE -iquote src/script/lua \
    $(pkg-config --cflags lua5.4) "$scratch/luatable.c" \
    $(find "$out/src" "$out/fb" -name '*.o' ! -name luatable.o) "$out"/gen/{std,no_rom}.o \
    "$out"/platform/{null,stdio,posix,posix_process}.o $(pkg-config --libs lua5.4) -lm -pthread -o "$scratch/unsorted"

# Three runs, for each has another order.
for run in 1 2 3; do
    code=0
    "$scratch/unsorted" verify tests/cross/keys "$demo" >"$scratch/said" || code=$?
    if [ $code != 1 ] || ! grep -qE ': frames? [0-9]+.*: .*(script|bullets).* differs?' "$scratch/said"; then
        echo "unsorted pairs are not found out: exit code $code, $(cat "$scratch/said")"
        exit 1
    fi
done
cat "$scratch/said"

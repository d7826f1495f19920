#!/usr/bin/env bash
# prove.sh - the proof programs in their sampled form: nothing is misrounded, in doubles and in integers, and
# every build gives the same results.
. "$(dirname "$0")/../tap.sh"
CC=${CC:-cc}
FLAGS="-std=c11 -fwrapv -ffp-contract=off -D_DEFAULT_SOURCE"

for f in prove oracle; do
    "$CC" $FLAGS -O2 -c "tools/lab/prove/$f.c" -o "$scratch/$f.o" || { echo "Bail out! $f.c does not compile"; exit 2; }
done
check "the oracles include nothing of src" eval '! grep -n "include.*src/" tools/lab/prove/{oracle,prove}.[ch]'

# proved TREE PROGRAM FLAG [OPTION...]: TREE holds src/base and tools/lab/prove
proved() {
    "$CC" $FLAGS -O1 "$3" "$1/tools/lab/prove/$2.c" "$1/src/base/trig.c" "$scratch"/{prove,oracle}.o \
        -lmpfr -lgmp -lm -pthread -o "$scratch/$2" && "$scratch/$2" --sample --seed 1 "${@:4}"
}
for program in roots sines polar directions products; do
    for flag in -DPLAIN -DFX_INTEGER; do
        check "$program, sampled, $flag: none misrounded" proved . $program $flag
    done
done

# A product that is rounded one unit too low.
cp -r --parents src/base tools/lab/prove tools/lab/numbers.h "$scratch"
sed -i 's/(int64_t)a \* b + 0x8000)/(int64_t)a * b + 0x7fff)/' "$scratch/src/base/fx.h"
detects "a product rounded down" "fx_mul" proved "$scratch" products -DPLAIN --only fx_mul

# Every build gives the same. The last two must find no undefined behaviour, overflow included.
digest() { # COMPILER FLAG...
    "$@" -std=c11 -ffp-contract=off tools/lab/prove/digest.c src/base/trig.c -lm -o "$scratch/digest" &&
        "$scratch/digest" --each 2>&1
}
digest gcc -O0 >"$scratch/want"
while read -r build; do
    same "the same results: $build" "$(cat "$scratch/want")" "$(digest $build)"
done <<'END'
gcc -O3 -DFX_INTEGER
clang -O0 -DFX_INTEGER -DFX_NO_INT128
clang -O3
clang -O3 -DFX_NO_INT128
gcc -O1 -fsanitize=undefined -fno-sanitize-recover=all
gcc -O1 -DFX_INTEGER -fsanitize=undefined -fno-sanitize-recover=all
END
finish

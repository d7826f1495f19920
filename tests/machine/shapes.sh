#!/usr/bin/env bash
# shapes.sh - the contact tests against 256-bit integers (tools/lab/prove/shapes.c, sampled): no mismatch, however they
# can be built, and no overflow without -fwrapv; and a planted fault, which shows as a mismatch.
. "$(dirname "$0")/../tap.sh"

cp --parents src/base/fx.h src/base/int.h src/base/geom.h src/base/geom.c tools/lab/prove/shapes.c \
    tools/lab/prove/shapes_oracle.h "$scratch"
# shapes FLAGS [ARGUMENT...]: built in the copy with the flags, and run
shapes() {
    local flags=$1
    shift
    (cd "$scratch" && ${CC:-cc} -std=c11 -ffp-contract=off -D_DEFAULT_SOURCE $flags tools/lab/prove/shapes.c \
        src/base/geom.c -o shapes -lm -pthread &&
        ./shapes --sample --threads 1 "$@")
}
check "no mismatch" shapes "-O2 -fwrapv"
check "no mismatch without 128-bit integers" shapes "-O2 -fwrapv -DFX_NO_INT128"
check "no mismatch and no undefined behaviour without -fwrapv" shapes \
    "-O1 -fsanitize=undefined -fno-sanitize-recover=all"

# A capsule one unit too wide.
sed -i 's/(int64_t)r + cr/& + 1/' "$scratch/src/base/geom.h"
detects "a capsule one unit too wide" "wrong for" shapes "-O1 -fwrapv" --only capsule-circle
finish

#!/usr/bin/env bash
# shapes.sh - the contact tests against 256-bit integers (tools/lab/prove/shapes.c, sampled): no mismatch, however they
# can be built, and no overflow without -fwrapv; and planted faults, which show as mismatches.
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

# planted SHAPE FILE OLD NEW: the shape with OLD replaced in the file
planted() {
    local text rc
    text=$(cat "$2")
    case $text in *"$3"*) ;; *) echo "$2 has no \"$3\""; return 1 ;; esac
    printf '%s\n' "${text/"$3"/"$4"}" >"$scratch/$2"
    shapes "-O1 -fwrapv" --only "$1"
    rc=$?
    cp "$2" "$scratch/$2"
    return $rc
}
detects "a capsule one unit too wide" "wrong for" planted capsule-circle src/base/geom.h "(int64_t)r + cr" \
    "(int64_t)r + cr + 1"
detects "a swept box one unit too narrow" "wrong for" planted swept-circle-box src/base/geom.c \
    "comes_within(dx, wx, hw + r)" "comes_within(dx, wx, hw + r - 1)"
finish

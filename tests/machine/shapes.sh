#!/usr/bin/env bash
# shapes.sh - the contact tests against 256-bit integers (tools/prove/shapes.c, sampled): no mismatch, in any way they
# can be built, and no overflow without -fwrapv; and planted faults, which show as mismatches.
. "$(dirname "$0")/../tap.sh"

cp --parents src/base/fx.h src/base/int.h src/base/geom.h src/base/geom.c tools/prove/shapes.c \
    tools/prove/shapes_oracle.h "$scratch"
# shapes FLAGS [ARGUMENT...]: built in the copy with the flags, and run
shapes() {
    local flags=$1
    shift
    # shellcheck disable=SC2086
    (cd "$scratch" && ${CC:-cc} -std=c11 -ffp-contract=off -D_DEFAULT_SOURCE $flags tools/prove/shapes.c \
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
fault() { # SHAPE, FILE below src/base, OLD, NEW
    detects "$1, \"$4\" for \"$3\"" "wrong for" planted "$1" "src/base/$2" "$3" "$4"
}
fault circle-circle geom.h "dx * dx + dy * dy <= limit" "dx * dx + dy * dy < limit"
fault circle-circle geom.h "& (dx <= limit) & (dy <= limit) &" "&"
fault box-box geom.h "(dy <= h)" "(dy < h)"
fault circle-box geom.c "int64_abs(y) - hh;" "int64_abs(y) - hh + 1;"
fault swept-circles geom.c "a * a <= b * c" "a * a < b * c"
fault swept-circles geom.c "if (dot >= ww)" "if (dot >= ww + ww)"
fault capsule-circle geom.h "(int64_t)r + cr" "(int64_t)r + cr + 1"
fault swept-circle-box geom.c "(wx ^ wy) < 0" "(wx ^ wy) > 0"
fault swept-circle-box geom.c "comes_within(dx, wx, hw + r)" "comes_within(dx, wx, hw + r - 1)"
fault swept-boxes geom.c "dy * wx) <= " "dy * wx) < "
fault swept-capsule geom.c "bar_covers_origin(dx, dy, wx, wy, hx, hy)" "false"
fault swept-capsule geom.c "comes_within(dx, wx, int64_abs(hx)) && comes_within(dy, wy, int64_abs(hy))" "true"
fault swept-capsule geom.c "side_touches(dx + wx - hx, dy + wy - hy" "side_touches(dx - hx, dy - hy"
fault swept-capsule geom.c "abs_difference(mx * hy, my * hx) <= area" "true"
fault swept-capsules geom.c "hx, hy, r, 0, 0) ||" "hx, hy, r, 0, 0); return"
fault turned-bar geom.c "px * qy > qx * py" "px * qy >= qx * py + 1000000"
fault turned-bar geom.c "(py <= 0) == (qy <= 0)" "(py <= 0) != (qy <= 0)"
fault turned-bar geom.c "winding_step(cx, cy, b->ax, b->ay)" "0"
fault turned-bar geom.c "geom_swept_circles(cx, cy, dx - cx, dy - cy, r) ||" ""
fault turned-bar geom.c "are_all_beyond(b->ay, b->by, cy, dy, r)" "are_all_beyond(b->ay, b->by, cy, dy, r - 1)"
check "the copy is as it was" shapes "-O1 -fwrapv" --only swept-boxes
finish

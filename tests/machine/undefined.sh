#!/usr/bin/env bash
# undefined.sh - the unit tests and test_extremes in a build where undefined behaviour, an overflow too, ends the
# program. (`make ubsan` runs all other programs so.)
. "$(dirname "$0")/../tap.sh"
sandbox

if (cd "$repo" && make ubsan-short) >made 2>&1; then
    ok "it builds without -fwrapv, under UBSan"
else
    not_ok "it builds without -fwrapv, under UBSan" "$(tail -n 20 made)"
fi
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1 CMOCKA_MESSAGE_OUTPUT=TAP
cd "$repo" || exit 2

# Every test holds, and there are some.
holds_whole() { # PROGRAM
    "build/ubsan/$1" >"$scratch/ran" 2>&1 </dev/null && grep -q '^ok' "$scratch/ran" &&
        ! grep -q '^not ok' "$scratch/ran"
}
whole() { # PROGRAM NAME
    if holds_whole "$1"; then ok "$2"; else not_ok "$2" "$(grep -av '^ok' "$scratch/ran" | tail -n 20)"; fi
}

whole machine/test_extremes "scripts at the ends of what they may pass: nothing undefined, nothing that is not there"
for test in tests/unit/test_*.c; do
    name=unit/$(basename "$test" .c)
    whole "$name" "$name: nothing undefined"
done
finish

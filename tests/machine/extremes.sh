#!/usr/bin/env bash
# extremes.sh - test_extremes in a build where undefined behaviour, an overflow too, ends the program.
. "$(dirname "$0")/../tap.sh"

if (cd "$repo" && make ubsan-extremes) >made 2>&1; then
    ok "it builds without -fwrapv, under UBSan"
else
    not_ok "it builds without -fwrapv, under UBSan" "$(tail -n 20 made)"
fi
cd "$repo" || exit 2
if UBSAN_OPTIONS=halt_on_error=1 CMOCKA_MESSAGE_OUTPUT=TAP build/ubsan/machine/test_extremes >"$tmp/ran" 2>&1; then
    ok "scripts at the ends of what they may pass: nothing undefined, nothing that is not there"
else
    not_ok "scripts at the ends of what they may pass" "$(tail -n 20 "$tmp/ran")"
fi
finish

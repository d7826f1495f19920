#!/usr/bin/env bash
# speed.sh - docs/measured/speed.md is a whole page of `make bench`. Times are not compared. What the bench checks
# besides its times holds.
measured=speed
. "$(dirname "$0")/../measured.sh"
bench=$OUT/bench

whole() { # PAGE: all sections up to the last one, and the machine
    grep -qx '## A boss fight' "$1" && grep -qx '## The most expensive frames' "$1" &&
        grep -qE '^Measured on: .+; (gcc|clang) .+; `-std=c11 .+`' "$1"
}
check "docs/measured/speed.md has its sections and the machine" whole "$page"
plots_hold polyline

# A section ends with exit code 1 when the engine does not do what it must.
check "shots hit the nearest enemy, every sprite is drawn, and steps back find the frames that were" \
    "$bench" battle pictures rewind
refuse "a section it does not have" "sections: machine boss crowd prices" "$bench" nothing
finish

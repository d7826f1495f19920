#!/usr/bin/env bash
# accuracy.sh - docs/accuracy.md says what the lab measures: every figure and plot that does not depend on the machine
# is computed again. Figures that do begin with "≈" and end before the next blank or bar (tools/lab/lab.h).
. "$(dirname "$0")/../tap.sh"
lab=$OUT/lab

# A page with its times taken out.
masked() { sed -e 's/≈[^ |]*/≈/g' -e 's/^Measured on: .*/Measured on: ≈/' "$1"; }
same_page() { diff <(masked "$1") <(masked "$scratch/new/accuracy.md"); }
same_plot() { diff -q "$1" "$scratch/new/accuracy/$(basename "$1")"; }

mkdir "$scratch/new"
check "the figures bear out what the engine does" "$lab" --exact --out "$scratch/new"
check "docs/accuracy.md has the figures the lab finds" same_page docs/accuracy.md

# Without times the lab draws only what is exact; the rest of what the page shows has to be there.
plots() {
    local f ok=0
    for f in "$scratch"/new/accuracy/*.svg; do
        same_plot "docs/accuracy/$(basename "$f")" || ok=1
    done
    return $ok
}
check "the plots of exact figures are those the lab draws" plots
shown() { grep -o '](accuracy/[a-z0-9_-]*\.svg)' docs/accuracy.md | sed 's/.*\///; s/)//' | sort; }
kept() { basename -a docs/accuracy/* | sort; }
all_shown() { diff <(shown) <(kept) && [ "$(kept | wc -l)" -ge 5 ]; }
check "every plot is shown, and every plot shown is there" all_shown
well_formed() { python3 -c 'import sys, xml.dom.minidom as x; [x.parse(f) for f in sys.argv[1:]]' docs/accuracy/*.svg; }
check "plots are well-formed" well_formed

# Another figure, another plot, another time.
planted() { # NAME WORDS SED
    sed "$3" docs/accuracy.md >"$scratch/planted.md"
    if cmp -s docs/accuracy.md "$scratch/planted.md"; then
        not_ok "planted: $1" "nothing was planted"
        return
    fi
    refuse "planted: $1" "$2" same_page "$scratch/planted.md"
}
planted "another drift" "0.37 px" '/^| \*\*▶ Q15.16/s/0\.38 px/0.37 px/'
planted "another share" "61.4 %" 's/61\.3 %/61.4 %/'
planted "another edge" "0x20000002" "/^D: /s/0x20000001/0x20000002/"
planted "another default" "▶ Q11.20" '/^| Q11.20/s/Q11.20/▶ Q11.20/'
sed -E 's/≈[0-9.,]+/≈1.23/' docs/accuracy.md >"$scratch/planted.md"
timed() { ! cmp -s docs/accuracy.md "$scratch/planted.md" && same_page "$scratch/planted.md"; }
check "other times are no difference" timed
sed '0,/cx="\([0-9]*\)\.[0-9]"/s//cx="\1.77"/' docs/accuracy/drift.svg >"$scratch/drift.svg"
refuse "planted: another plot" "differ" same_plot "$scratch/drift.svg"

# An engine that is not what the tables justify: hits are not swept. It is built beside the one there is.
engine_copy
sed 's/= swept ?/= false ?/g' src/board/hits/hit_parts.h >"$copy/src/board/hits/hit_parts.h"
unswept() {
    ! cmp -s src/board/hits/hit_parts.h "$copy/src/board/hits/hit_parts.h" || return 2
    engine_build lab 'hit*' -llibfixmath || return 2
    "$scratch/lab" --exact --out "$scratch/new" collision
}
refuse "planted: an engine that does not sweep" "does not hold: hit test" unswept
finish

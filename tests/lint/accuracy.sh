#!/usr/bin/env bash
# accuracy.sh - docs/measured/accuracy.md says what the lab measures: every figure and plot that does not depend on the
# machine is computed again. Figures that do begin with "≈" and end before the next blank or bar
# (tools/lab/accuracy/lab.h).
measured=accuracy
. "$(dirname "$0")/../measured.sh"
lab=$OUT/lab

# A page without its times, commit and machine.
masked() { sed -e 's/≈[^ |]*/≈/g' -e '/^Measured /d' "$1"; }
same_page() { diff -B <(masked "$1") <(masked "$scratch/new/accuracy.md"); }

mkdir "$scratch/new"
check "the figures bear out what the engine does" "$lab" --exact --out "$scratch/new"
check "docs/measured/accuracy.md has the figures the lab finds" same_page "$page"

# Without times the lab draws only what is exact; the rest of what the page shows has to be there.
plots() {
    local plot bad=0
    for plot in "$scratch"/new/accuracy/*.svg; do
        cmp "$plot" "docs/measured/accuracy/$(basename "$plot")" || bad=1
    done
    return $bad
}
check "the plots of exact figures are those the lab draws" plots
plots_hold circle

planted "another drift" "0.37 px" '/^| \*\*▶ Q15.16/s/0\.38 px/0.37 px/' same_page
finish

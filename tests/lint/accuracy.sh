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
same_plot() { diff -q "$1" "$scratch/new/accuracy/$(basename "$1")"; }

mkdir "$scratch/new"
check "the figures bear out what the engine does" "$lab" --exact --out "$scratch/new"
check "docs/measured/accuracy.md has the figures the lab finds" same_page "$page"

# Without times the lab draws only what is exact; the rest of what the page shows has to be there.
plots() {
    local f ok=0
    for f in "$scratch"/new/accuracy/*.svg; do
        same_plot "docs/measured/accuracy/$(basename "$f")" || ok=1
    done
    return $ok
}
check "the plots of exact figures are those the lab draws" plots
plots_hold circle

# Another figure, another plot, another time.
planted "another drift" "0.37 px" '/^| \*\*▶ Q15.16/s/0\.38 px/0.37 px/' same_page
sed -E 's/≈[0-9.,]+/≈1.23/' "$page" >"$scratch/planted.md"
timed() { ! cmp -s "$page" "$scratch/planted.md" && same_page "$scratch/planted.md"; }
check "other times are no difference" timed
finish

#!/usr/bin/env bash
# sound.sh - docs/measured/sound.md says what the ear measures: every figure and plot is computed again.
measured=sound
. "$(dirname "$0")/../measured.sh"
ear=$OUT/ear

same_page() { diff -B -I "^Measured at commit" "$1" "$scratch/new/sound.md"; }
same_plots() { diff -r "$1" "$scratch/new/sound"; }

mkdir "$scratch/new"
check "no figure is below its mark" "$ear" --out "$scratch/new"
check "docs/measured/sound.md has the figures the ear finds" same_page "$page"
check "docs/measured/sound has the plots the ear draws" same_plots docs/measured/sound
plots_hold polyline

planted "another alias" "-99.9 dB" '/^| alias of a saw/s/-[0-9.]* dB/-99.9 dB/' same_page
finish

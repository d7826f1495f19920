#!/usr/bin/env bash
# readme.sh - README's commands run, its game is examples/first to the letter, and that game's pictures are Glass
# Tide's.
. "$(dirname "$0")/../pages.sh"

rm -r "$bench/mygame" # which the page makes
blocks README.md
check "README's new game is the shooter" cmp "$bench/mygame/main.lua" examples/shooter/main.lua
for art in examples/*/art/*.png; do
    case $art in # their own: tests/lint/art.sh, tests/cli/art.sh
    */glow.png | */items.png | */tiles.png | */shooter/* | */pattern/* | */bulletml/* | \
        */moth/art/palette.png | */canyon/*) continue ;;
    esac
    check "$art is the one of roms/glasstide" cmp "$art" "roms/glasstide/art/${art##*/}"
done
files() { ls "$scratch/blocks" | grep -c '\.file$'; }
scripts() { find examples/first -name '*.lua' ! -path '*/tests/*' | wc -l; }
check "README shows all of the game in examples/first" test "$(files)" = "$(scripts)"
check "the sandbox runs" run examples/sandbox try 600
finish

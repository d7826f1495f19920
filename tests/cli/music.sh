#!/usr/bin/env bash
# music.sh - the music of Glass Tide is in the key, on the chords and of the form that its files declare, as loud as
# one another, wide, without a click; its sounds are short and heard, and a boss's death is louder than its fight. The
# game's source/music.py measures it.
. "$(dirname "$0")/../tap.sh"
sandbox
game=$repo/roms/glasstide
checker=$repo/roms/glasstide/source/music.py
music() { python3 "$checker" --curtain "$curtain" "$@"; }

# What follows is measured, and is another with another engine.
declared() { sed '/^## Levels/,$d; /^Measured at commit/d' "$1" | cat -s; }

(cd "$repo" && music --page roms/glasstide) >page 2>faults
same "pieces are what their files declare; levels are equal, centred, wide, without a click; fights sound right" \
    "" "$(cat faults)"
same "the page has what the files declare, and what is played" "$(declared page)" \
    "$(declared "$repo/docs/measured/music.md")"
# One piece in a game of its own, changed by sed.
planted() { # PIECE SED... : makes the game x
    local piece=$1
    shift
    rm -rf x && mkdir -p x/music
    printf 'return { title = "-", music = { %s = { file = "music/%s.mml" } } }\n' "$piece" "$piece" >x/rom.lua
    : >x/main.lua
    sed "$@" "$game/music/$piece.mml" >"x/music/$piece.mml"
}
planted over -e 's/^;= key .*/;= key Eb major/'
detects "another key" "of the notes in Eb major" music x over
planted over -e 's/^I @deep/I D100 K1 @deep/'
detects "a bass a semitone off" "of the bass's time on the chords" music x over
planted over -E -e 's/ p[0-9]+//' -e 's/^(#echo.*),[0-9]+$/\1/'
detects "a piece in mono" "below the mid channel" music --levels x over
finish

#!/usr/bin/env bash
# Records the demos of the built-in game and of the test card anew: needed when their scripts, the standard library or
# the core version change. All that reaches a game is buttons: no practice start, no help. JOBS at a time (2).
set -eu
cd "$(dirname "$0")/.."
OUT=${OUT:-build/release}
bot=$OUT/bot
game=roms/glasstide at=tests/demos/glasstide
mkdir -p $game/demos roms/testcard/demos $at

# record DEMO OPTION...
record() {
    local demo=$1 from=$SECONDS said
    shift
    said=$("$bot" $game "$demo" --quiet --prints seconds --first one --wait 900 "$@" 2>&1) ||
        { echo "$demo: $said" && return 1; }
    printf '%s: %s, %d s, %d bytes\n' "$demo" "$said" $((SECONDS - from)) "$(stat -c %s "$demo")"
}
# A whole game, from the title to the score table; what it unlocked is there for the next.
clear_of() { # DIFFICULTY SHIP [BEFORE]
    record $at/clear-"$1".demo --difficulty "$1" --ship "$2" --frames 140000 --finish ${3:+--after "$at/clear-$3.demo"}
}

lane() {
    case $1 in
    0)
        record $game/demos/attract.demo --stage one --frames 2400 --seed 3
        record $game/demos/run.demo --difficulty normal --lose 240 --frames 40000 --finish
        record $at/lose.demo --difficulty hard --ship petrel --lose 30 --frames 20000 --finish
        record $at/two-players.demo --difficulty normal --players 2 --ship heron --ship petrel --frames 140000 --finish
        ;;
    1)
        clear_of easy heron
        clear_of normal petrel easy
        clear_of hard tern normal # that craft has to be found first
        clear_of abyss heron hard
        ;;
    esac
}
if [ $# = 1 ]; then
    lane "$1"
    exit
fi
"$bot" roms/testcard roms/testcard/demos/card.demo --frames 600 --seed 1 --quiet
printf '%s\n' 0 1 | OUT=$OUT xargs -P "${JOBS:-2}" -I{} bash -eu "$0" {}

#!/usr/bin/env bash
# speed.sh - docs/measured/speed.md is a whole page of `make bench`: its sections and plots are there. No
# figure is looked at, for each machine has its own. What the bench checks besides its times holds.
measured=speed
. "$(dirname "$0")/../measured.sh"
bench=$OUT/bench

cat >"$scratch/sections" <<'END'
Targets
The machine
A boss fight
The crowd
Cost per bullet
Shots against enemies
Pictures
Lasers
All together
Threads
The built-in game
Snapshots and rewind
Replay and reload
Whole games
Memory
Sound
Endless loops
The most expensive frames
END
whole() { # PAGE
    diff "$scratch/sections" <(sed -n 's/^## //p' "$1") &&
        grep -qE '^Measured on: .+; (gcc|clang) .+; `-std=c11 .+`' "$1"
}
check "docs/measured/speed.md has all sections and the machine" whole "$page"
planted "a section that is missing" "< Pictures" '/^## Pictures/d' whole
plots_hold polyline

# What holds whatever the clock says: a section ends with exit code 1 when the engine does not do what it must.
check "shots hit the nearest enemy, every sprite is drawn, and steps back find the frames that were" \
    "$bench" battle pictures rewind
refuse "a section it does not have" "sections: machine boss crowd prices" "$bench" nothing
finish

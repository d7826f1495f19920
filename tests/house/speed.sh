#!/usr/bin/env bash
# speed.sh - docs/speed.md is a whole page of `make bench`: its sections, tables and plots are there. No figure is
# looked at, for each machine has its own. What the bench checks beside its times holds, and it finds an engine that is
# wrong.
. "$(dirname "$0")/../tap.sh"
bench=$OUT/bench

cat >"$scratch/sections" <<'END'
Targets
The machine
A boss fight
The crowd
What a bullet costs
Shots against enemies
Pictures
Lasers
All together
Threads
The built-in game
Snapshots and going back
Playing again
Memory
Sound
Endless loops
END
whole() { # PAGE
    diff "$scratch/sections" <(sed -n 's/^## //p' "$1") &&
        grep -qE '^Measured on: .+; (gcc|clang) .+; `-std=c11 .+`; .+ %' "$1" || return 1
    local rows
    rows=$(awk '/^## /{ in_it = /Targets/ } in_it && /\| (met|\*\*missed\*\*) \|$/' "$1" | wc -l)
    [ "$rows" = 27 ] || { echo "$rows targets"; return 1; }
    local n
    for n in 1,024 4,096 16,384 65,536 262,144 1,048,576; do
        [ "$(grep -c "^| $n |" "$1")" -ge 6 ] || { echo "the crowd of $n is not in every table"; return 1; }
    done
}
check "docs/speed.md has all sections, targets and crowds" whole docs/speed.md
sed '/^## Pictures/d' docs/speed.md >"$scratch/a.md"
refuse "planted: a section that is missing" "< Pictures" whole "$scratch/a.md"
sed '/| met |$/{x;s/^/x/;/^x$/{x;d};x}' docs/speed.md >"$scratch/a.md"
refuse "planted: a target that is missing" "26 targets" whole "$scratch/a.md"
sed '0,/^| 65,536 |/{/^| 65,536 |/d}' docs/speed.md >"$scratch/a.md"
refuse "planted: a row that is missing" "the crowd of 65,536" whole "$scratch/a.md"

shown() { grep -o '](speed/[a-z0-9_-]*\.svg)' "$1" | sed 's/.*\///; s/)//' | sort; }
all_shown() { diff <(shown "$1") <(basename -a docs/speed/* | sort) && [ "$(shown "$1" | wc -l)" = 4 ]; }
check "every plot is shown, and every plot shown is there" all_shown docs/speed.md
sed '/speed\/run.svg/d' docs/speed.md >"$scratch/a.md"
refuse "planted: a plot that is not shown" "> run.svg" all_shown "$scratch/a.md"
well_formed() {
    python3 -c '
import sys, xml.dom.minidom as x
for f in sys.argv[1:]:
    assert len(x.parse(f).getElementsByTagName("polyline")) >= 2, f + ": too few lines"' "$@"
}
check "plots are well-formed and hold their lines" well_formed docs/speed/*.svg
sed 's/<polyline.*//' docs/speed/crowd.svg >"$scratch/crowd.svg"
refuse "planted: a plot without its lines" "too few lines" well_formed "$scratch/crowd.svg"

# What holds whatever the clock says: a section ends with exit code 1 when the engine does not do what it must.
check "shots hit the nearest enemy, every sprite is drawn, and steps back find the frames that were" \
    "$bench" battle pictures rewind
refuse "a section it does not have" "sections: machine boss crowd prices" "$bench" nothing
engine_copy
sed 's/\(events_push(.*EV_SHOT, who, whom\))/\1 ^ 1)/' \
    src/board/hits/hit_shots.c >"$copy/src/board/hits/hit_shots.c"
another() {
    ! cmp -s src/board/hits/hit_shots.c "$copy/src/board/hits/hit_shots.c" || return 2
    engine_build bench hit_shots || return 2
    "$scratch/bench" battle
}
refuse "planted: an engine that hits the enemy beside" "did not hit the nearest enemy" another
finish

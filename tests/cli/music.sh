#!/usr/bin/env bash
# music.sh - the music of Glass Tide is in the key, on the chords and of the form that its files declare, as loud as one
 without a click; its sounds are short and heard. tools/music.py measures it., without a click; its sounds are short and heard. tools/music.py measures it.
. "$(dirname "$0")/../tap.sh"
sandbox
game=$repo/roms/glasstide
checker=$repo/roms/glasstide/source/music.py
music() { python3 "$checker" --curtain "$curtain" "$@"; }

# What follows is measured, and is another with another engine.
declared() { sed '/^## Levels/,$d; /^Measured at commit/d' "$1" | cat -s; }

(cd "$repo" && music --page roms/glasstide) >page 2>faults
same "pieces are what their files declare; levels are equal, unclipped, centred, without a click" "" "$(cat faults)"
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

cat >measures.py <<'END'
import importlib.util, math, sys
spec = importlib.util.spec_from_file_location("music", sys.argv[1])
m = importlib.util.module_from_spec(spec)
spec.loader.exec_module(m)

def tone(seconds, level, offset=0):
    return [round(level * math.sin(i // 2 * 440 * 2 * math.pi / 48000)) + offset for i in range(int(96000 * seconds))]

at = 5 * 48000
good = tone(10, 8000)
here, near = m.click(good, at)
assert here <= near, (here, near)
bad = good[:2 * at] + [-x for x in good[2 * at + 40:]]
here, near = m.click(bad, at)
assert here > near, (here, near)
assert m.flaws("x", good)[1] == []
assert "its peak" in " ".join(m.flaws("x", tone(1, 32000))[1])
assert "limiter's curve" in " ".join(m.flaws("x", tone(1, 28000))[1])
assert "its mean" in " ".join(m.flaws("x", tone(1, 8000, 100))[1])
assert m.measure(good)[2] == 0 and m.measure([16384, -16384, 16385, -16385])[2] == 0.5
assert m.spread({"a": -16.0, "b": -13.9}) == ["b is 2.1 LU louder than a, 2 at most"]
assert m.spread({"a": -16.0, "b": -14.1}) == []
assert m.spread({"a": -float("inf"), "b": -14.0}) != []
assert m.heard(tone(1, 8000) + [0] * 96000) in range(47900, 48001)
END
check "the measures find a click, an offset, what is cut, what is louder" python3 measures.py "$checker"
finish

#!/usr/bin/env bash
# music.sh - the music of Glass Tide is in the key, on the chords and of the form that its files declare, as loud as one
# another, without a click; its sounds are short and heard. source/music.py of the game
# measures it; every planted fault is found.
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
same "seventeen pieces" 17 "$(grep -c '^| `' page)"
check "forty-four sounds at least" [ "$(sed -n '/^## Sounds/,/^## Cost/p' page | grep -c '^| [a-z]')" -ge 44 ]

# One piece in a game of its own, changed by sed.
planted() { # PIECE SED... : makes the game x
    local piece=$1
    shift
    rm -rf x && mkdir -p x/music
    printf 'return { title = "-", music = { %s = { file = "music/%s.mml" } } }\n' "$piece" "$piece" >x/rom.lua
    : >x/main.lua
    sed "$@" "$game/music/$piece.mml" >"x/music/$piece.mml"
}
fault() { # NAME WORDS PIECE SED...
    local name=$1 words=$2
    shift 2
    planted "$@"
    ! cmp -s "x/music/$1.mml" "$game/music/$1.mml" || { not_ok "planted: $name" "nothing is changed"; return; }
    detects "$name" "$words" music x "$1"
}

planted over -e ''
check "the piece that faults are planted in is good" music x over
fault "another key" "of the notes in Eb major" over -e 's/^;= key .*/;= key Eb major/'
fault "another tempo" "expected tempo 90, got 76" over -e 's/^;= tempo .*/;= tempo 90/'
fault "another tempo in the notes" "expected tempo 76, got 99" over -e 's/ t76 / t99 /'
fault "a section that is not there" "expected 6 bars, as the form says" over -e 's/still rest$/still/'
fault "a section without chords" "the form has deep" over -e 's/^;= form fall/;= form deep/'
fault "no key" 'expected a line ";= key"' over -e '/^;= key/d'
fault "a key that is none" 'expected ";= key D minor", got "E moody"' over -e 's/^;= key .*/;= key E moody/'
fault "a chord that is none" 'expected a chord like Am7 or C/E, got "Hm"' over -e 's/^;= fall .*/;= fall Hm | Bm/'
fault "a role that is none" "got \"singer A\"" over -e 's/melody A/singer A/'
fault "a bass a semitone off" "of the bass's time on the chords" over -e 's/^I @deep/I D100 K1 @deep/'
fault "a bass on the fifths" "of chords begun by the bass's root" over -e 's/^I @deep/I K7 @deep/'
fault "a harmony a tone off" "of the harmony's time on the chords" over -e 's/^\([EFG]\) @haze/\1 K2 @haze/'
fault "a melody a tone off" "of the melody's strong beats on the chords" over -e 's/^A p60/A K2 p60/'
fault "no bass" "expected a bass" over -e '/^I /d'
fault "no drums" "expected a drums" over -e 's/drums J$/drums N/'
fault "a piece that is over too soon" "last 8 to 20 seconds" over -e 's/tempo 76/tempo 400/' -e 's/ t76 / t400 /'
fault "a short loop" "60 seconds before it repeats" scores -e 's/tempo 88/tempo 150/' -e 's/ t88 / t150 /'
fault "the same bars again and again" "of the bars are as an earlier one" over -e '/^A /d' \
    -e '$a A t76 o5 [b4.g8 e4]8'
fault "a melody of leaps" "of the melody's moves in steps" over -e '/^A /d' -e '$a A t76 o5 [b4<e4>b4]8'
fault "a second part that rubs" "melody and second are a semitone apart for a beat in bar 1" over \
    -e 's/^C p88 .*/C p88 l8 @glass v12 o5 a+2r4 r2./'
fault "a melody that falls silent" "the melody rests" over -e '/^A /d' -e '$a A t76 o5 b2e4 [r2.]6 b2.'

cp -r "$game" twice
cp twice/music/over.mml twice/music/clear.mml
detects "two pieces of one key, tempo and chords" "over: key, tempo and chords are those of clear" \
    music twice clear over
planted over -e 's/v1[0-9]/v15/g; s/v[5-9]/v15/g'
detects "too loud" "in the limiter's curve" music --levels x over
detects "a piece that there is not" "there is no x/music/tune.mml" music x tune

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

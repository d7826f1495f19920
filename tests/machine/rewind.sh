#!/usr/bin/env bash
# rewind.sh - `play` backwards: the pictures come back in reverse, play goes on from there, scores are kept from before
# alone, and a demo only goes forward. The port is a script's (port_keys.c): no window, no clock.
. "$(dirname "$0")/../tap.sh"
${CC:-cc} -std=c11 -O1 -o player "$repo/tests/machine/port_keys.c" \
    $(find "$OUT/src" -name '*.o') "$OUT"/fb/*.o "$OUT/gen/std.o" "$OUT/gen/no_rom.o" "$OUT/platform/stdio.o" \
    $(pkg-config --libs lua5.4) -lm || exit 2

# A picture of its own every frame, also of what was pressed; and a save that counts frames.
game g <<'LUA'
local seen, dot = 0, sprite.put { sprite = 'dot', x = 0, y = 0 }
task.go(function()
  for i = 1, forever do
    seen = (seen * 31 + i + (pad.down 'fire' and 7 or 0) + rng.int(0, 99)) % 100000007
    dot.x, dot.y = 8 + seen % 240, 20 + seen % 37
    if i == 30 or i == 150 then save.set('frame', i) end
    wait(1)
  end
end)
LUA
sed -i 's/screen = { w = 64/screen = { w = 256/' g/rom.lua # the cabinet's words stand on one line

BACKSPACE=42 Z=29 P=19
keys() { # N [USAGE...]: so many polls with these held
    local n=$1
    shift
    for _ in $(seq "$n"); do echo "$*"; done
}
plays() { # OUT ARGUMENT...: standard input are the keys
    local out=$1
    shift
    ./player play g --seed 5 "$@" >"$out" 2>err
}
part() { sed -n "$2,$3p" "$1"; } # FILE FIRST LAST: picture n is of frame n

# ---- backwards ----

{ keys 100; keys 40 $BACKSPACE; keys 60; } | plays once
same 'it ends well' 0 $?
same 'as many pictures as polls, and the one of quitting' 201 "$(wc -l <once)"
same 'every picture is another' 100 "$(part once 1 100 | sort -u | wc -l)"
same 'the pictures come back in reverse' "$(part once 60 99 | tac)" "$(part once 101 140)"
same 'and forward again' "$(part once 61 100)" "$(part once 141 180)"
keys 200 | plays straight
same 'then on, as if nothing had been' "$(part straight 101 120)" "$(part once 181 200)"

{ keys 100; keys 40 $BACKSPACE; keys 50 $Z; } | plays other
{ keys 60; keys 50 $Z; } | plays direct
same 'with other keys it is another future' "$(part direct 61 110)" "$(part other 141 190)"
same 'which differs from the first' '' "$(comm -12 <(part other 141 190 | sort) <(part once 61 180 | sort))"

{ keys 20; keys 100 $BACKSPACE; keys 20; } | plays power
same 'back to power-on, and no further' "$(part power 140 140)" "$(part power 20 20)"
same 'it waits there' 1 "$(part power 41 120 | sort -u | wc -l)"

{ keys 50; keys 1 $P; keys 10; keys 20 $BACKSPACE; keys 10; } | plays paused
same 'in a pause too' "$(part paused 30 30)" "$(part paused 91 91)"

# ---- scores ----

rm -rf data
keys 200 | plays out
cp data/curtain/probe.nv straight.nv
rm -rf data
keys 100 | plays out
cp data/curtain/probe.nv before.nv
refuted() { ! cmp -s "$1" "$2"; }
holds 'the two saves differ' refuted straight.nv before.nv
rm -rf data
{ keys 40; keys 5 $BACKSPACE; keys 200; } | plays out
holds 'what was saved before going back is kept, what came later is not' cmp data/curtain/probe.nv before.nv
rm -rf data

# ---- demos only go forward ----

{ keys 50; keys 10 $BACKSPACE; keys 40; } | plays recorded --record one.demo
same 'while recording it goes forward' "$(part straight 1 100)" "$(part recorded 1 100)"
same 'and says why' 'curtain: g: no way back while a demo is recorded or played' "$(cat err)"
same 'the demo holds' "one.demo: holds, 100 frames" "$("$curtain" verify g one.demo)"
{ keys 50; keys 10 $BACKSPACE; keys 40; } | ./player play g --demo one.demo >shown 2>err
same 'while a demo is shown too' "$(part straight 1 100)" "$(part shown 1 100)"
same 'and says it' 'curtain: g: no way back while a demo is recorded or played' "$(cat err)"
finish

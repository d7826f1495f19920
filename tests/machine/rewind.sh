#!/usr/bin/env bash
# rewind.sh - `play` and time: backwards, step by step, from moment to moment, in play and in a playback; taking over;
# what is recorded and saved meanwhile. The port is a script's (port_keys.c): no window, no clock.
. "$(dirname "$0")/../scripted.sh"
# A picture of its own every frame, also of what was pressed; and a save that counts frames.
game g <<'LUA'
local seen, dot = 0, sprite.put { sprite = 'dot', x = 0, y = 0 }
task.go(function()
  for i = 1, forever do
    seen = (seen * 31 + i + (pad.down 'fire' and 7 or 0) + rng.int(0, 99)) % 100000007
    dot.x, dot.y = 8 + seen % 240, 13 + seen % 29
    if i == 30 or i == 150 then save.set('frame', i) end
    wait(1)
  end
end)
stage.def('one', function() wait(40) stage.mark('a') wait(30) stage.mark('b') wait(1000) end)
task.go(stage.play, 'one')
LUA
sed -i 's/screen = { w = 64/screen = { w = 256/' g/rom.lua # the program's words stand on one line

plays() { # OUT ARGUMENT...: standard input are the keys
    local out=$1
    shift
    ./player play g --seed 5 "$@" >"$out" 2>err
}

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
check 'the two saves differ' files_differ straight.nv before.nv
rm -rf data
{ keys 40; keys 5 $BACKSPACE; keys 200; } | plays out
check 'what was saved before going back is kept, what came later is not' cmp data/curtain/probe.nv before.nv
rm -rf data
{ keys 40; keys 1 $DOT; keys 1; keys 1 $P; keys 200; } | plays out
check 'the same before a step' cmp data/curtain/probe.nv before.nv
rm -rf data

# ---- step by step, and from moment to moment ----

{ keys 50; for _ in 1 2 3; do keys 1 $B; keys 1; done; for _ in 1 2 3 4; do keys 1 $DOT; keys 1; done; } | plays steps
same 'a step back a press' "$(part straight 47 49 | tac)" "$(part steps 51 56 | uniq)"
same 'steps forward are as it was, and then go on' "$(part straight 48 51)" "$(part steps 57 64 | uniq)"
{ keys 110; keys 1 $BEFORE; keys 1 $P; keys 5; keys 1 $BEFORE; keys 5; keys 1 $AFTER; keys 5; } | plays moments
same 'to the moment before, and on: mark b' "$(part straight 72 72)" "$(part moments 111 111)"
same 'again, to the one before that' "$(part straight 41 41)" "$(part moments 123 123)"
same 'and to the one after' "$(part straight 71 71)" "$(part moments 129 129)"

# ---- recording ----

{ keys 100; keys 40 $BACKSPACE; keys 50 $Z; } | plays recorded --record one.demo
same 'while recording too' "$(part direct 61 110)" "$(part recorded 141 190)"
same 'the demo is of the branch' "one.demo: holds, 110 frames" "$("$curtain" verify g one.demo)"
{ keys 60; keys 50 $Z; } | plays out --record two.demo
same 'and is as one that went there straight' '' \
    "$(diff <("$curtain" hash g --demo one.demo) <("$curtain" hash g --demo two.demo) 2>&1)"
check 'but it knows that it branched' files_differ one.demo two.demo
{ keys 100; keys 40 $BACKSPACE; } | plays out --record three.demo
same 'who stops in the past ends there' "three.demo: holds, 60 frames" "$("$curtain" verify g three.demo)"

# ---- a playback ----

keys 200 | plays out --record whole.demo
watches() { # OUT ARGUMENT...: whole.demo is shown
    local out=$1
    shift
    ./player play g --demo whole.demo "$@" >"$out" 2>err
}
{ keys 100; keys 40 $BACKSPACE; keys 60; } | watches shown
same 'a playback goes back' "$(part straight 60 99 | tac)" "$(part shown 101 140)"
same 'and on, whatever is pressed' "$(part straight 61 120)" "$(part shown 141 200)"
{ keys 10; keys 1 @200,63; keys 1; } | watches click
at=$(grep -n "^$(part click 11 11)$" straight | cut -d: -f1)
check 'a click on the bar of time leads far ahead' test "${at:-0}" -gt 150
{ keys 10; keys 1 @0,63; keys 1 $P; keys 3; } | watches click
same 'and to the start' "$(part straight 1 1)" "$(part click 12 12)"
{ keys 20; keys 1 $AFTER; keys 1 $AFTER; keys 1; keys 1 $AFTER; keys 1 $P; keys 3; } | watches click
same 'the moments of the demo are known before they come' "$(part straight 71 71)" "$(part click 26 26)"
{ keys 20; keys 1 74; keys 1; keys 1 31; keys 1; keys 1 39; keys 1; keys 1 42; keys 1; keys 1 34; keys 2; keys 1 40
    keys 3; } | watches ask
same 'asked for, frame 25 comes: 2, 0, Backspace, 5, Enter' "$(part straight 25 25)" "$(part ask 34 34)"
same 'time stands still meanwhile' 1 "$(part ask 21 31 | sort -u | wc -l)"
{ keys 20; keys 1 74; keys 1; keys 1 41; keys 10; } | watches ask
same 'Escape asks no more' "$(part straight 21 30)" "$(part ask 23 32)"
{ keys 20; keys 1 74; keys 1; keys 5 41; keys 10; } | watches ask
same 'and does not leave the game, however long it is held' 38 "$(wc -l <ask)"
{ keys 250; } | watches shown
same 'it ends with the demo' 201 "$(wc -l <shown)"
{ keys 100; keys 10 $BACKSPACE; keys 200; } | watches shown
same 'but waits at its end for who went back' "$(part straight 200 200)" "$(tail -1 shown)"

{ keys 100; keys 63 $BACKSPACE; } | watches shown --record copy.demo
same 'a copy of it ends where one left it' "copy.demo: holds, 37 frames" "$("$curtain" verify g copy.demo)"

# A demo that ends in a fault: gone back from, taken over at it.
cp -R g faulty
sed -i "s/if i == 30/if i == 71 then error 'ends here' end\n    if i == 30/" faulty/main.lua
keys 90 | ./player play faulty --seed 5 --record fault.demo >/dev/null 2>&1
same 'a run that faults' "fault.demo: holds, 71 frames, ends in the recorded fault" \
    "$("$curtain" verify faulty fault.demo)"
{ keys 90; keys 1 $BEFORE; keys 3; keys 1 $P; } | ./player play faulty --demo fault.demo --record before.demo >out 2>&1
check 'who went back from the fault and left has a demo without it' grep -q ': holds, [0-9]* frames$' \
    <("$curtain" verify faulty before.demo)
{ keys 90; keys 1 $T; keys 5; } | ./player play faulty --demo fault.demo --record over.demo >out 2>&1
same 'taken over at the fault, it ends in it' "over.demo: holds, 71 frames, ends in the recorded fault" \
    "$("$curtain" verify faulty over.demo)"

# ---- another run than was recorded ----

cp -R g other_game
sed -i 's/i == 150 then/i == 150 or i == 60 then/' other_game/main.lua # saves once more
mkdir -p data2
XDG_DATA_HOME=$scratch/data2 ./player play other_game --demo whole.demo >shown 2>err < <(keys 100)
check 'a playback that is not what was recorded says so' grep \
    -q '^curtain: other_game: Playback diverged from the recording at frame 6[01]$' err
same 'once' 1 "$(grep -c 'diverged' err)"
keys 100 | watches shown
same 'and one that is does not' '' "$(cat err)"

# ---- taking over ----

{ keys 62; keys 49 $Z; } | plays taken
{ keys 61; keys 1 $T; keys 49 $Z; } | watches shown --record over.demo
same 'who takes over plays' "$(part taken 1 111)" "$(part shown 1 111)"
same 'the demo is one of its own' "over.demo: holds, 111 frames" "$("$curtain" verify g over.demo)"
rm -f probe-*.demo
{ keys 61; keys 1 $T; keys 49 $Z; } | watches shown
same 'without --record under a name of its own' "probe-1.demo: holds, 111 frames" "$("$curtain" verify g probe-1.demo)"
same 'which it tells' "curtain: g: You are playing from here. Recording: $scratch/probe-1.demo" "$(cat err)"
same 'the demo that was shown is untouched' "whole.demo: holds, 200 frames" "$("$curtain" verify g whole.demo)"
finish

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
screen_of g 256x64 # the program's words have one line
play() { plays "$1" --seed 5 "${@:2}"; } # OUT ARGUMENT...: standard input are the keys
verify() { "$curtain" verify "${2:-g}" "$1"; } # DEMO [GAME]

# ---- backwards ----

keys 200 | play straight
cp data/curtain/probe.nv straight.nv
{ keys 100; keys 40 $BACKSPACE; keys 60; } | play once
same 'the pictures come back in reverse' "$(part straight 60 99 | tac)" "$(part once 101 140)"
same 'and forward again, and on' "$(part straight 61 120)" "$(part once 141 200)"

{ keys 100; keys 40 $BACKSPACE; keys 50 $Z; } | play other --record branch.demo
{ keys 60; keys 50 $Z; } | play direct --record direct.demo
same 'with other keys it is another future' "$(part direct 61 110)" "$(part other 141 190)"
same 'the demo is of the branch' "branch.demo: holds, 110 frames" "$(verify branch.demo)"
same 'as a demo that went there straight' "$("$curtain" hash g --demo direct.demo)" \
    "$("$curtain" hash g --demo branch.demo)"
check 'but it says that it branched' files_differ direct.demo branch.demo
{ keys 100; keys 40 $BACKSPACE; } | play out --record past.demo
same 'who stops in the past ends there' "past.demo: holds, 60 frames" "$(verify past.demo)"

{ keys 20; keys 100 $BACKSPACE; keys 20; } | play power
same 'back to power-on, and no further' "$(part power 20 20)" "$(part power 140 140)"
{ keys 50; keys 1 $P; keys 10; keys 20 $BACKSPACE; keys 10; } | play paused
same 'in a pause too' "$(part paused 30 30)" "$(part paused 91 91)"

# ---- scores ----

rm -rf data
keys 100 | play out
cp data/curtain/probe.nv before.nv
check 'the two saves differ' files_differ straight.nv before.nv
rm -rf data
{ keys 40; keys 5 $BACKSPACE; keys 200; } | play out
check 'saves from before going back stay, later ones are discarded' cmp data/curtain/probe.nv before.nv
rm -rf data
{ keys 40; keys 1 $DOT; keys 1; keys 1 $P; keys 200; } | play out
check 'the same before a step' cmp data/curtain/probe.nv before.nv

# ---- step by step, and from moment to moment ----

{ keys 50; press $B $B $B $DOT $DOT $DOT $DOT; } | play steps
same 'a step back a press' "$(part straight 47 49 | tac)" "$(part steps 51 56 | uniq)"
same 'steps forward' "$(part straight 48 51)" "$(part steps 57 64 | uniq)"
{ keys 110; keys 1 $BEFORE; keys 1 $P; keys 5; keys 1 $BEFORE; keys 5; keys 1 $AFTER; keys 5; } | play moments
same 'to the moment before: mark b' "$(part straight 72 72)" "$(part moments 111 111)"
same 'again, to the one before that' "$(part straight 41 41)" "$(part moments 123 123)"
same 'and to the one after' "$(part straight 71 71)" "$(part moments 129 129)"

# ---- a playback ----

keys 200 | play out --record whole.demo
watch() { plays shown --demo whole.demo "$@"; } # standard input are the keys
{ keys 100; keys 40 $BACKSPACE; keys 60; } | watch
same 'a playback goes back' "$(part straight 60 99 | tac)" "$(part shown 101 140)"
same 'and on' "$(part straight 61 120)" "$(part shown 141 200)"
{ keys 10; keys 1 @200,63; keys 1; } | watch
at=$(grep -n "^$(part shown 11 11)$" straight | cut -d: -f1)
check 'a click on the bar of time leads far ahead' test "${at:-0}" -gt 150
{ keys 20; press $AFTER; keys 1 $AFTER; keys 1 $P; keys 3; } | watch
same 'the moments of the demo are known before they come' "$(part straight 71 71)" "$(part shown 25 25)"
{ keys 20; press 74 31 39 $BACKSPACE 34; keys 1; keys 1 $ENTER; keys 3; } | watch
same 'asked for, frame 25 comes: 2, 0, Backspace, 5, Enter' "$(part straight 25 25)" "$(part shown 34 34)"
same 'time stands still meanwhile' 1 "$(part shown 21 31 | sort -u | wc -l)"
{ keys 20; press 74; keys 5 $ESCAPE; keys 10; } | watch
same 'Escape asks no more, and does not leave the game' 38 "$(pictures shown)"
keys 250 | watch
same 'it ends with the demo' 201 "$(pictures shown)"
{ keys 100; keys 10 $BACKSPACE; keys 200; } | watch
same 'but waits at its end for who went back' "$(part straight 200 200)" "$(tail -1 shown)"
{ keys 100; keys 63 $BACKSPACE; } | watch --record copy.demo
same 'a copy of it ends where one left it' "copy.demo: holds, 37 frames" "$(verify copy.demo)"

# A demo that ends in a fault.
cp -R g faulty
sed -i "s/if i == 30/if i == 71 then error 'ends here' end\n    if i == 30/" faulty/main.lua
keys 90 | ./player play faulty --seed 5 --record fault.demo >/dev/null 2>&1
{ keys 90; keys 1 $BEFORE; keys 3; keys 1 $P; } | ./player play faulty --demo fault.demo --record before.demo >out 2>&1
check 'who went back from the fault and left has a demo without it' grep -q ': holds, [0-9]* frames$' \
    <(verify before.demo faulty)
{ keys 90; keys 1 $T; keys 5; } | ./player play faulty --demo fault.demo --record over.demo >out 2>&1
same 'taken over at the fault, it ends in it' "over.demo: holds, 71 frames, ends in the recorded fault" \
    "$(verify over.demo faulty)"

# ---- taking over ----

{ keys 62; keys 49 $Z; } | play taken
rm -f probe-*.demo
{ keys 61; keys 1 $T; keys 49 $Z; } | watch
same 'who takes over plays' "$(part taken 1 111)" "$(part shown 1 111)"
same 'the recording has its own name' "probe-1.demo: holds, 111 frames" "$(verify probe-1.demo)"
same 'which is printed' "curtain: g: You are playing from here. Recording: $scratch/probe-1.demo" "$(cat err)"
same 'the demo that was shown is untouched' "whole.demo: holds, 200 frames" "$(verify whole.demo)"
finish

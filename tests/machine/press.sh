#!/usr/bin/env bash
# press.sh - how players press, in play: what a tick gets is what is recorded, in every mode, and the demo holds without
# them. The port is a script's (port_keys.c): no window, no clock. The game prints, in each frame, what it sees of
# player 1's (and then player 2's) buttons: F fire, B bomb, f focus, s special, L left, and . for none.
. "$(dirname "$0")/../scripted.sh"

game g <<'LUA'
player.def("ship", { sprite = "dot", hit = { circle = 2 }, safe = 9, lives = 9 })
stage.def("one", function() wait(100000) end)
local letters = { fire = "F", bomb = "B", focus = "f", special = "s", left = "L" }
local function seen(p)
  local s = ""
  for _, name in ipairs { "fire", "bomb", "focus", "special", "left" } do
    if pad.down(name, p) then s = s .. letters[name] end
  end
  return s == "" and "." or s
end
task.go(function()
  while true do
    if player.get(1).alive then print("sees " .. seen(1) .. (player.get(2).alive and "|" .. seen(2) or "")) end
    wait(1)
  end
end)
boot.run { stages = { "one" }, players = { "ship" } }
LUA

SHIFT=225 A=4 SPACE=44 Q=20 E=8
SOUTH=10 L1=100 L3=8000 STICK=80000 # masks of a controller

# seen SKIP: what the game saw, a letter or more a frame, after so many frames of it.
seen() { sed -n 's/^sees //p' err | tail -n +$(($1 + 1)) | tr '\n' ' ' | sed 's/ $//'; }
# pressing NAME WANT SETTINGS: with these settings, separated by "; ", and the keys of standard input the game sees WANT
# and the demo holds for a program without any settings. The game's first frames are left out: the ship is there from
# the second one on.
pressing() {
    settings "${3//; /$'\n'}"
    plays out --seed 5 --stage one --record run.demo
    same "$1" "$2" "$(seen 3)"
    check "$1: the demo holds" env -u XDG_DATA_HOME HOME="$scratch/nobody" "$curtain" verify g run.demo
}

fires() { keys 5; keys 10 $Z; keys 3; }
plain='. F F F F F F F F F F . . .'
pressing 'as it is held' "$plain" '' < <(fires)
pressing 'the second player has settings of their own' "$plain" \
    'autofire2 = yes; focus2 = toggle; one_hand2 = left' < <(fires)
pressing 'in bursts' '. F F . . F F . . F F . . .' 'autofire = yes' < <(fires)
pressing 'focus that stays' '. f f f f f F F F . .' 'focus = toggle' \
    < <(keys 5; keys 1 $SHIFT; keys 4; keys 3 $SHIFT $Z; keys 2)
pressing 'a left hand' '. FL FL F F . . Bf FsL F' 'one_hand = left' \
    < <(keys 5; keys 2 $A; keys 2; keys 1 $SPACE; keys 1; keys 1 $SHIFT $Q; keys 1 $E $A; keys 1)
pressing 'a left hand on a controller' '. FL FL s Fs . B .' 'one_hand = left' \
    < <(keys 5; keys 2 c1:$STICK; keys 2 c1:$L1; keys 1; keys 1 c1:$L3; keys 1)
pressing 'a controller' '. F F . .' '' < <(keys 5; keys 2 c1:$SOUTH; keys 2)

# ---- ticks are counted, and not polls ----

pressing 'bursts in slow motion' '. . F F . . F F .' 'autofire = yes' \
    < <(keys 5; keys 1 $COMMA; keys 1; keys 13 $Z; keys 2)
pressing 'bursts through a pause' '. F F . . F F . .' 'autofire = yes' \
    < <(keys 5; keys 3 $Z; keys 1 $Z $P; keys 7 $Z; keys 1 $Z $P; keys 2 $Z; keys 2)
pressing 'a step at a time' '. F F . . F' 'autofire = yes' \
    < <(keys 5; for _ in 1 2 3 4 5; do keys 1 $Z $DOT; keys 2 $Z; done)
pressing 'focus through the menu' '. f f f f f f . . .' 'focus = toggle' \
    < <(keys 5; keys 1 $SHIFT; keys 2; keys 1 $ESCAPE; keys 2; keys 2 $SHIFT; keys 2; keys 1 $ESCAPE; keys 3
        keys 1 $SHIFT; keys 2)
pressing 'focus after a rewind' '. f f f f f f f f f f . . . . . . . . . . f f f f . . . .' 'focus = toggle' \
    < <(keys 5; keys 1 $SHIFT; keys 9; keys 1 $SHIFT; keys 9; keys 12 $BACKSPACE; keys 4; keys 1 $SHIFT; keys 3)

# Who takes over a demo in which focus is held has it held.
settings 'focus = hold'
{ keys 5; keys 30 $SHIFT; } | plays out --seed 5 --stage one --record held.demo
settings 'focus = toggle'
{ keys 15; keys 1 $T; keys 3; keys 1 $SHIFT; keys 3; } | plays out --demo held.demo --record taken.demo
same 'focus that was held goes on when a demo is taken over' 'f f f f . . . .' "$(seen 0 | tail -c 15)"
check 'and the new demo holds' "$curtain" verify g taken.demo
finish

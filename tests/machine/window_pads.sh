#!/usr/bin/env bash
# window_pads.sh - controllers in a real (virtual) X server: who plays with which, plugged in and pulled out while
# playing. SDL's virtual joysticks stand in for them (tests/pads.sh). The game prints what each player's pad does, so
# that nothing depends on time. What belongs to whom is tested by unit/test_controllers.c.
. "$(dirname "$0")/../xserver.sh"
. "$repo/tests/pads.sh"
export SDL_AUDIODRIVER=dummy SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS=1

game g <<'LUA'
local was = { "", "" }
task.go(function()
  while true do
    for p = 1, 2 do
      local now = (pad.down("fire", p) and "fire" or "") .. (pad.down("right", p) and "right" or "")
      if now ~= was[p] then print(("player %d: %s"):format(p, now)) end
      was[p] = now
    end
    wait(1)
  end
end)
LUA
printed() { [ "$(grep '^player ' err | tail -n 1)" = "$1" ]; }
# sees LINE COMMAND...: a player does this, and then the game's last line is this
sees() { pad "${@:2}" && wait_until printed "$1"; }
silent() { # COMMAND...: nothing of it reaches the game
    local before
    before=$(grep -c '^player ' err)
    pad "$@" && pad wait 8 && [ "$(grep -c '^player ' err)" = "$before" ]
}
pads_none
if start "Probe" "${padded[@]}" "$OUT/curtain" play g --mute --scale 4 --record run.demo; then
    for p in 1 2 3; do check "controller $p" pad plug $p xbox; done
    check "the one that is used is player 1's" sees 'player 1: fire' down 2 south
    check "another is nobody's" silent tap 1 south
    check "its START takes the second place" silent tap 1 start
    check "and it plays" sees 'player 2: right' down 1 right
    check "a third one's START takes nothing" silent tap 3 start
    check "player 1's is pulled out, and the game waits" silent unplug 2
    check "it comes back, and the game still waits" silent plug 2 xbox
    check "START goes on, and what was held is released" sees 'player 1: ' down 2 start
    check "player 2's is pulled out, and the game waits" silent unplug 1
    check "the third takes its place" sees 'player 2: ' tap 3 start
    check "and plays" sees 'player 2: fire' down 3 south
    check "a key plays player 1" eval 'xdotool keydown z && wait_until printed "player 1: fire"'
    xdotool keyup z
    kill -TERM "$child"
    wait "$child"
    check "it ends well" [ $? = 0 ]
    check "the demo holds" "$curtain" verify g run.demo
    kill_program
fi
finish

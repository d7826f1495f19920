#!/usr/bin/env bash
# window_pads.sh - controllers in a real (virtual) X server: who plays with which, plugged in and pulled out while
# playing, what hints call their buttons. SDL's virtual joysticks stand in for them (tests/pads.sh). The game prints
# what each player's pad does, so that nothing depends on time.
. "$(dirname "$0")/../xserver.sh"
. "$repo/tests/pads.sh"
export SDL_AUDIODRIVER=dummy SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS=1

game g <<'LUA'
local fix = { "up", "down", "left", "right", "fire", "bomb", "focus", "special", "start", "select" }
local was = { "", "" }
task.go(function()
  while true do
    for p = 1, 2 do
      local held = {}
      for _, name in ipairs(fix) do
        if pad.down(name, p) then held[#held + 1] = name end
      end
      local now = table.concat(held, "+")
      if now ~= was[p] then print(("player %d: %s"):format(p, now)) end
      was[p] = now
    end
    wait(1)
  end
end)
LUA
sed 's/players = 2/players = 1/' g/rom.lua >alone.lua

# said LINE: it has been printed, after what was looked for before. The lines up to it are done with.
seen_to=0
said() {
    local at
    wait_until line_after "$1" || { tail -n +$((seen_to + 1)) err >&2; return 1; }
    at=$(tail -n +$((seen_to + 1)) err | grep -nxF -- "$1" | head -1 | cut -d: -f1)
    seen_to=$((seen_to + at))
}
line_after() { tail -n +$((seen_to + 1)) err | grep -qxF -- "$1"; }
# The player does this, and the game sees that; nothing else of a player is printed meanwhile.
sees() { # LINE COMMAND...
    local line=$1
    shift
    pad "$@" && said "$line"
}
silent() { ! tail -n +$((seen_to + 1)) err | grep '^player '; }
play() {
    pads_none
    seen_to=0
    start "Probe" "${padded[@]}" "$OUT/curtain" play g --mute --scale 4 --record run.demo "$@"
}
over() {
    kill -TERM "$child"
    wait "$child"
    check "$1: it ends well" [ $? = 0 ]
    check "$1: the demo holds" "$curtain" verify g run.demo
    kill_program
}

# ---- two players ----
if play; then
    for p in 1 2 3; do check "controller $p" pad plug $p xbox; done
    check "the one that is used is player 1's" sees 'player 1: fire' down 2 south
    check "and lets go" sees 'player 1: ' up 2 south
    check "another is nobody's" pad tap 1 south east
    pad wait 8
    check "nothing of it reaches the game" silent
    check "its START takes the second place" pad tap 1 start
    pad wait 8
    check "and is not the game's" silent
    check "the next one is" sees 'player 2: start' down 1 start
    check "player 2 plays" sees 'player 2: bomb+start' down 1 east
    check "each for themselves" sees 'player 1: left+focus' down 2 lleft r2
    check "a third one's START takes nothing" pad tap 3 start
    check "player 1's is pulled out" pad unplug 2
    # The game stands: nothing is released until it goes on.
    pad wait 8
    check "the game waits" silent
    check "another game's is not theirs" pad tap 1 south
    check "it comes back" pad plug 2 xbox
    pad wait 8
    check "the game still waits" silent
    check "START goes on" pad down 2 start
    check "what player 1 held is released" said 'player 1: '
    check "and START was not the game's" sees 'player 1: right' down 2 right
    check "player 2's is pulled out" pad unplug 1
    check "the third takes its place" pad tap 3 start
    check "and the game goes on" said 'player 2: '
    check "with it" sees 'player 2: up' down 3 up
    over 'two players'
fi

# ---- one player: no ceremony, a keyboard beside it, another controller ----
mv alone.lua g/rom.lua
if play; then
    check "a PlayStation's" pad plug 1 ps4
    check "plays" sees 'player 1: fire' down 1 south
    check "until it is pulled out" pad unplug 1
    pad wait 8
    check "the game waits for its player" silent
    xdotool key Return
    check "a key goes on too" said 'player 1: '
    xdotool keydown z
    check "with the keyboard" said 'player 1: fire'
    xdotool keyup z
    check "which lets go" said 'player 1: '
    check "plugged in again" pad plug 1 ps4
    check "it is player 1's" sees 'player 1: bomb' down 1 east
    check "and lets go" sees 'player 1: ' up 1 east
    xdotool key x
    check "whose keys are in use" said 'player 1: bomb'
    check "and let go" said 'player 1: '
    check "then it may go" pad unplug 1
    pad wait 8
    xdotool keydown z
    check "without a pause" said 'player 1: fire'
    xdotool keyup z
    check "and let go again" said 'player 1: '
    check "another" pad plug 2 nintendo
    check "plays" sees 'player 1: fire' down 2 south
    check "and lets go" sees 'player 1: ' up 2 south
    check "a third" pad plug 3 xbox360
    check "takes over by START" pad tap 3 start
    check "from the second" sees 'player 1: select' down 3 select
    check "which plays no more" pad tap 2 south
    pad wait 8
    check "for nobody" silent
    over 'one player'
fi
finish

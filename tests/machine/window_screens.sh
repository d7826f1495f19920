#!/usr/bin/env bash
# window_screens.sh - the program's screens as a player sees them (driven.sh says how); the controllers' is in
# window_pads.sh.
. "$(dirname "$0")/../driven.sh"
export SDL_AUDIODRIVER=alsa AUDIODEV=none

# Nothing moves, so that it is the same picture whenever a screen is opened.
game still <<'LUA'
for i = 0, 8 do sprite.put { sprite = "dot", x = 24 * i + 12, y = 30 + 9 * i, screen = true } end
LUA
# With pieces to practise; a screen hides the rest.
game pieces <<'LUA'
enemy.def("e", { sprite = "dot", hit = { box = { 4, 4 } } })
player.def("ship", { sprite = "dot", hit = { circle = 2 }, registers = { power = 1 } })
boss.def("queen", { title = "Queen of Glass", kind = "e", x = 32, y = 20, phases = {
  { id = "weak", hp = 5, time = 600, run = function(e) wait(forever) end },
  { id = "strong", spell = "Sign of Sand: a long name that is cut", hp = 5, time = 60,
    run = function(e) wait(forever) end } } })
stage.def("one", function() wait(50) stage.mark "late" wait(40) end)
local function title() -- that stands still
  wait_until(function() return pad.take("start", 0, 1) end)
  return "start", 1
end
boot.run { stages = { "one" }, players = { "ship" }, screens = { title = title } }
LUA

# A run that was left: begun from the title, and 200 frames of fire. Its date is always the same.
cat >date.c <<'C'
#include <time.h>
time_t time(time_t *t)
{
    if (t)
        *t = 1800000000;
    return 1800000000;
}
C
cc -shared -fPIC date.c -o date.so || exit 2
build_player
leaves_run() { # in the data folder
    local enter=40 z=29
    { keys 30; keys 1 $enter; keys 60; keys 200 $z; } |
        TZ=UTC LD_PRELOAD=$scratch/date.so XDG_DATA_HOME=$scratch/data ./player play pieces --seed 5 >/dev/null 2>&1
}

opens() { # GAME: at this size and turn
    set_size "$1"
    [ "$1" = still ] || leaves_run
    TZ=UTC XDG_DATA_HOME=$scratch/data start Probe "${padded[@]}" "$OUT/curtain" play "$1" --seed 1 || return 1
    [ "$by" = keys ] || pad plug 1 xbox
}

screens() {
    if opens still; then
        press_each menu
        expect_screen menu
        press_each down yes
        expect_screen no-replays
        press_each no down yes
        expect_screen settings
        press_each down down down down down right
        expect_screen settings-changed
        press_each no
        check "and it is written" grep -qx 'border = no' data/curtain/curtain.conf
        press_each down yes
        expect_screen keys
        kill_program
    fi
    if opens pieces; then
        expect_screen resume
        press_each down yes menu down yes
        expect_screen replays
        press_each yes
        expect_screen replay
        press_each no no down down down down yes
        expect_screen practice
        press_each down right
        expect_screen practice-changed
        kill_program
    fi
}
for_each_way screens
finish

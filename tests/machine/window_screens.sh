#!/usr/bin/env bash
# window_screens.sh - the cabinet's screens in a real (virtual) X server, driven by keys and by a controller, at
# three sizes, upright and turned: to the last pixel as tests/golden/screens has it. CURTAIN_UPDATE=1 writes those anew;
# look at them. The controllers' is in window_pads.sh.
. "$(dirname "$0")/../xserver.sh"
. "$repo/tests/pads.sh"
export SDL_AUDIODRIVER=alsa AUDIODEV=none SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS=1
cd "$scratch" || exit 2
goldens=$repo/tests/golden/screens
mkdir -p "$goldens"

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
${CC:-cc} -std=c11 -O1 -o player "$repo/tests/machine/port_keys.c" \
    $(find "$OUT/src" -name '*.o') "$OUT"/fb/*.o "$OUT/gen/std.o" "$OUT/gen/no_rom.o" "$OUT/platform/stdio.o" \
    $(pkg-config --libs lua5.4) -lm -pthread || exit 2
keys() { yes "${*:2}" | head -n "$1"; } # N [USAGE...]: so many polls with these held
leaves_run() { # in the data folder
    local enter=40 z=29
    { keys 30; keys 1 $enter; keys 60; keys 200 $z; } |
        TZ=UTC LD_PRELOAD=$scratch/date.so XDG_DATA_HOME=$scratch/data ./player play pieces --seed 5 >/dev/null 2>&1
}

shot() {
    xwd -silent -id "$win" -out shot.xwd 2>/dev/null && convert xwd:shot.xwd -depth 8 rgb:shot.rgb 2>/dev/null
}
as_golden() { shot && cmp -s shot.rgb want.rgb; }
# It stands still: two looks that are alike, and not what was seen last.
stands() {
    shot && ! cmp -s shot.rgb last.rgb && cp shot.rgb before.rgb && sleep 0.3 && shot && cmp -s shot.rgb before.rgb
}
# looks NAME: the window shows the golden picture of that name.
looks() {
    if [ "${CURTAIN_UPDATE:-}" ]; then
        soon stands
        cp shot.rgb last.rgb
        convert xwd:shot.xwd -strip -define png:exclude-chunks=date,time png:- >"$goldens/$size$turned-$1-$by.png"
    fi
    convert "$goldens/$size$turned-$1-$by.png" -depth 8 rgb:want.rgb 2>/dev/null || : >want.rgb
    check "$size$turned: $1, by $by" soon as_golden
}
# does WHAT...: one press each: up down left right yes no menu, of whoever drives.
does() {
    local what
    for what in "$@"; do
        if [ "$by" = keys ]; then
            case $what in
            yes) what=Return ;;
            no | menu) what=Escape ;;
            *) what=${what^} ;;
            esac
            xdotool key --delay 60 "$what"
        else
            case $what in
            yes) what=south ;;
            no) what=east ;;
            menu) what=guide ;;
            esac
            pad tap 1 "$what"
        fi
    done
}
key() { [ "$by" = pad ] || xdotool key --delay 60 "$1"; }

opens() { # GAME: at this size and turn
    sed -i "s/screen = { w = [0-9]*, h = [0-9]*/screen = { w = ${size%x*}, h = ${size#*x}/" "$1/rom.lua"
    rm -rf data
    mkdir -p data/curtain
    printf 'scale = 1\naway = go-on\n%s' "${turned:+turn = left}" >data/curtain/curtain.conf
    pads_none
    [ "$1" = still ] || leaves_run
    TZ=UTC XDG_DATA_HOME=$scratch/data start Probe "${padded[@]}" "$OUT/curtain" play "$1" --seed 1 || return 1
    [ "$by" = keys ] || pad plug 1 xbox
}

for size in ${SIZES:-240x320 320x240 384x448}; do
    for turned in '' -turned; do
        for by in keys pad; do
            : >last.rgb
            if opens still; then
                does menu
                looks menu
                does down yes
                looks no-replays
                does no down yes
                looks settings
                does down down down down down right
                looks settings-changed
                does no
                check "and it is written" grep -qx 'border = no' data/curtain/curtain.conf
                does down yes
                looks keys
                leave
            fi
            if opens pieces; then
                looks resume
                does down yes menu down yes
                looks replays
                does yes
                looks replay
                does no no down down down down yes
                looks practice
                does down right
                looks practice-changed
                leave
            fi
        done
    done
done
finish

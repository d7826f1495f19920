#!/usr/bin/env bash
# program_screens.sh - the program's screens, reached by keys, in three sizes, upright and turned: the pictures are
# those of tests/golden/screens. The port is a script's (port_keys.c); looks.sh compares such pictures with a real
# window.
#
#     CURTAIN_UPDATE=1 tests/machine/program_screens.sh     writes the golden pictures; look at them
. "$(dirname "$0")/../scripted.sh"
export TZ=UTC
ENTER=40 ESCAPE=41 UP=82 DOWN=81 RIGHT=79 NORTH=80 START=1000 R2=800 L3_R2=8800
goldens=$repo/tests/golden/screens start=(--seed 1)

# Nothing moves, so that it is the same picture whenever a screen is opened.
game still <<'LUA'
for i = 0, 8 do sprite.put { sprite = "dot", x = 24 * i + 12, y = 30 + 9 * i, screen = true } end
LUA
# With sections to practise; a screen hides the rest.
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
cp -r still pads
: >pads/main.lua

# An unfinished run: begun from the title, and 200 frames of fire. Its date is always the same.
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
leave_run() {
    { keys 30; keys 1 $ENTER; keys 60; keys 200 $Z; } |
        LD_PRELOAD=$scratch/date.so ./player play pieces --seed 5 >/dev/null 2>&1
}

# begin GAME SIZE TURN: the next screens are of this game, from its start
begin() {
    game=$1 size=$2 turn=$3
    sed -i "s/screen = { w = [0-9]*, h = [0-9]*/screen = { w = ${size%x*}, h = ${size#*x}/" "$game/rom.lua"
    rm -rf data was
    mkdir -p data/curtain
    [ "$game" != pieces ] || leave_run
    printf 'scale = 1\naway = go-on\n%s' "${turn:+turn = left}" >data/curtain/curtain.conf
    cp -R data was
    keys 20 >script
}
press_each() { for key; do keys 1 "$key"; keys 4; done >>script; } # KEY...
expect_screen() { # NAME [WORD...]: the picture after these keys, with the words held
    local golden=$goldens/$size$turn-$1.png
    keys 20 "${@:2}" >>script
    rm -rf data
    cp -R was data
    KEYS_PPM=$(wc -l <script) ./player play "$game" "${start[@]}" <script >out 2>err
    [ -z "${CURTAIN_UPDATE:-}" ] ||
        convert picture.ppm -strip -define png:exclude-chunks=date,time "png:$golden"
    check "$size$turn: $1" cmp <(convert picture.ppm -depth 8 rgb:-) <(convert "$golden" -depth 8 rgb:-)
}

for size in 240x320 320x240 384x448; do
    for turn in '' -turned; do
        begin still $size "$turn"
        press_each $ESCAPE
        expect_screen menu
        press_each $DOWN $DOWN $DOWN $ENTER
        expect_screen no-replays
        press_each $ESCAPE $UP $UP $ENTER
        expect_screen settings
        press_each $ENTER $DOWN $DOWN $DOWN $DOWN $DOWN $RIGHT
        expect_screen settings-changed
        press_each $ESCAPE $DOWN $DOWN $ENTER
        expect_screen accessibility
        press_each $ESCAPE $DOWN $DOWN $ENTER
        expect_screen keys
        check "the setting is written" grep -qx 'border = no' data/curtain/curtain.conf
        begin pieces $size "$turn"
        expect_screen resume
        press_each $DOWN $ENTER $ESCAPE $DOWN $DOWN $DOWN $ENTER
        expect_screen replays
        press_each $ENTER
        expect_screen replay
        press_each $ESCAPE $ESCAPE $UP $ENTER
        expect_screen practice
        press_each $DOWN $RIGHT
        expect_screen practice-changed
        begin pads $size "$turn"
        keys 1 +1:1 +2:4 +3:6 >>script
        press_each c1:$NORTH c2:$START $ESCAPE $DOWN $ENTER $UP $ENTER
        expect_screen controllers
        press_each $DOWN $RIGHT
        expect_screen controllers-changed
        expect_screen controllers-pressed c3:$L3_R2 c2:$R2
    done
done

# A playback, paused at its fourth marker: the bar of time and the message are over the demo's frame.
game=$repo/roms/glasstide size=240x320 turn='' start=(--demo "$repo/roms/glasstide/demos/run.demo")
rm -rf was && mkdir was
keys 20 >script
press_each $P $AFTER $AFTER $AFTER $AFTER
expect_screen playback
finish

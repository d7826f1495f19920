#!/usr/bin/env bash
# window.sh - the desktop port in a real (virtual) X server: pixels, keys, sizes, controllers, no sound card; and, with a
# program and a game, that a played frame is the frame `curtain render` makes.
#
#     tests/window.sh [CURTAIN GAME_FOLDER]
#
# Prints TAP. Needs Xvfb, xdotool, xwd, xprop, ImageMagick, openbox, SDL2; exit code 77 and a line when one is missing.
. "$(dirname "$0")/tap.sh"
for tool in Xvfb xdotool xwd xprop convert openbox sdl2-config; do
    command -v $tool >/dev/null || { echo "window.sh: no $tool" >&2; exit 77; }
done
child= xvfb= wm=
trap 'for p in $child $wm $xvfb; do kill -KILL $p 2>/dev/null; done; rm -rf "$scratch"' EXIT
# A card that cannot be there, and nobody's settings.
export SDL_AUDIODRIVER=alsa AUDIODEV=none XDG_DATA_HOME=$scratch/data

# soon COMMAND...: tries for 10 s
soon() { for _ in $(seq 200); do "$@" && return 0; sleep 0.05; done; return 1; }
says() { grep -qx -- "$1" "$scratch/out"; }
gone() { ! kill -0 "$child" 2>/dev/null; }

for program in port_probe port_pads; do
    ${CC:-cc} -std=c11 -O1 $(sdl2-config --cflags) -o "$scratch/$program" tests/machine/$program.c platform/sdl2.c \
        platform/stdio.c $(sdl2-config --libs) || exit 2
done
probe=$scratch/port_probe

# X picks a free display number and writes it down.
Xvfb -displayfd 3 -screen 0 1100x900x24 -nolisten tcp 3>"$scratch/display" >/dev/null 2>&1 &
xvfb=$!
soon test -s "$scratch/display" || { echo "window.sh: Xvfb does not start" >&2; exit 2; }
DISPLAY=:$(cat "$scratch/display")
export DISPLAY

# start TITLE COMMAND...: sets child, title and win (SDL may replace its window by another)
start() {
    title=$1
    shift
    "$@" >"$scratch/out" 2>"$scratch/err" &
    child=$!
    if ! soon found; then
        check "a window for: $*" cat "$scratch/err" /none
        finish
        return 1
    fi
    timeout 5 xdotool windowfocus --sync "$win"
    xdotool windowmove "$win" 0 0
}
found() { win=$(xdotool search --onlyvisible --name "^$title\$" 2>/dev/null | head -1) && [ -n "$win" ]; }
finish() {
    kill -KILL "$child" 2>/dev/null
    wait "$child" 2>/dev/null
    child=
}
stop() {
    xdotool key Escape
    check "ends on Escape" soon gone
    wait "$child"
    check "with exit code 0" [ $? = 0 ]
    finish
}

# same_pixels W H WIN_W WIN_H: the window shows the probe's picture so; it may take a few frames to.
same_pixels() {
    "$probe" expect "$@" >"$scratch/want.rgb"
    soon settled || { cmp "$scratch/shot.rgb" "$scratch/want.rgb"; return 1; }
}
settled() {
    found && xwd -silent -id "$win" -out "$scratch/shot.xwd" 2>/dev/null &&
        convert "xwd:$scratch/shot.xwd" -depth 8 "rgb:$scratch/shot.rgb" 2>/dev/null &&
        cmp -s "$scratch/shot.rgb" "$scratch/want.rgb"
}
size_is() { [ "$(xdotool getwindowgeometry --shell "$win" | sed -n 's/^WIDTH=//p;s/^HEIGHT=//p' | paste -sd x)" = "$1" ]; }

# ---- pictures ----
for scale in 1 2 3; do
    if start "port probe" "$probe" show 240 160 $scale; then
        check "the window at scale $scale" size_is $((240 * scale))x$((160 * scale))
        check "pixels at scale $scale" same_pixels 240 160 $((240 * scale)) $((160 * scale))
        stop
    fi
done
if start "port probe" "$probe" show 240 160 2; then
    for size in 501x333 777x481 479x700 240x161 719x479 1000x163; do
        timeout 5 xdotool windowsize --sync "$win" ${size/x/ }
        check "pixels in a window of $size" same_pixels 240 160 ${size/x/ }
    done
    stop
fi
if start "port probe" "$probe" show 64 1000 0; then
    check "a picture taller than the screen gets scale 1" size_is 64x1000
    stop
fi

# ---- fullscreen: X has it only with a window manager ----
managed() { xprop -root _NET_SUPPORTING_WM_CHECK 2>/dev/null | grep -q "window id"; }
openbox --sm-disable >/dev/null 2>&1 &
wm=$!
check "a window manager" soon managed
if start "port probe" "$probe" show 240 160 2; then
    check "pixels before fullscreen" same_pixels 240 160 480 320
    xdotool key --delay 100 f
    check "pixels in fullscreen" same_pixels 240 160 1100 900
    xdotool key --delay 100 f
    check "pixels after fullscreen" same_pixels 240 160 480 320
    stop
fi
if start "port probe" "$probe" show 240 160 1 full; then
    check "pixels in fullscreen from the start" same_pixels 240 160 1100 900
    stop
fi
kill $wm
wait $wm 2>/dev/null
wm=

# ---- switches ----
if start "port probe" "$probe" show 240 160 2; then
    # HID usages: A 4, Left 80, Shift 225, Enter 40, keypad 5 93, F12 69
    for pair in a:4 Left:80 Shift_L:225 Return:40 KP_5:93 F12:69; do
        xdotool keydown "${pair%:*}"
        check "${pair%:*} arrives" soon says "key ${pair#*:} down"
        xdotool keyup "${pair%:*}"
        check "${pair%:*} is let go" soon says "key ${pair#*:} up"
    done
    kill -STOP $child
    xdotool key --delay 1 z
    kill -CONT $child
    check "a tap between two polls arrives" soon says "key 29 down"
    check "and is over" soon says "key 29 up"
    xdotool keydown x
    check "x arrives" soon says "key 27 down"
    xdotool windowfocus "$(xdotool search --maxdepth 0 '.*' 2>/dev/null | head -1)" 2>/dev/null
    check "a window that loses the keyboard lets go" soon says "key 27 up"
    xdotool keyup x
    timeout 5 xdotool windowfocus --sync "$win"
    xdotool type q
    check "typed text arrives" soon says "text q"
    xdotool mousemove --window "$win" 101 51 click 1
    check "the mouse is in picture pixels" soon says "mouse 1 at 50 25"
    check "no card, no sound" says "sound 0"
    check "which is mentioned" grep -q "no sound" "$scratch/err"
    stop
    check "closing twice is harmless" says closed
fi
if SDL_AUDIODRIVER=dummy start "port probe" "$probe" show 64 64 1; then
    check "with a card there is sound" says "sound 1"
    kill -TERM $child
    check "SIGTERM is a quit" soon says closed
    finish
fi
check "controllers" env SDL_VIDEODRIVER=dummy "$scratch/port_pads"
refuse "no display is refused" "cannot open a window" env DISPLAY=:9999 SDL_VIDEODRIVER=x11 "$probe" show 64 64 1

# ---- a game: the picture played is the picture rendered ----
# Our own words stand on the first 8 lines of a paused picture; below them each pixel must be the picture's, four times.
below_words() { convert "$1" $2 -gravity south -crop "x$((2 * h - 16))+0+0" +repage -depth 8 "rgb:$3"; }
window_is_shot() {
    local h
    h=$(identify -format %h "$play/$shot")
    below_words "xwd:$play/window.xwd" "" "$play/window.rgb"
    below_words "$play/$shot" "-scale 200%" "$play/shot.rgb"
    cmp "$play/window.rgb" "$play/shot.rgb"
}
if [ $# -ge 2 ]; then
    curtain=$(realpath "$1") rom=$(realpath "$2") play=$scratch/play
    mkdir -p "$play"
    cd "$play" || exit 2
    name=$(sed -n 's/^ *title *= *"\([^"]*\)".*/\1/p' "$rom/rom.lua")
    if start "$name" "$curtain" play "$rom" --seed 0 --scale 2 --mute --record one.demo; then
        sleep 1
        for key in p period F12; do
            xdotool key --delay 100 $key
            sleep 0.2
        done
        check "a screenshot" soon grep -q "^wrote " "$scratch/err"
        shot=$(sed -n 's/^wrote //p' "$scratch/err" | head -1)
        xwd -silent -id "$win" -out window.xwd
        stop
        frame=$("$curtain" hash "$rom" --demo one.demo | tail -1 | cut -d' ' -f1)
        check "renders frame $frame of the demo" "$curtain" render "$rom" --demo one.demo --frames "$frame" -o out
        check "the screenshot is that frame" cmp "$shot" "$(echo out/*.png)"
        check "the window shows that frame" window_is_shot
        check "the demo holds" "$curtain" verify "$rom" one.demo
    fi
fi
done_testing

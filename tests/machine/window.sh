#!/usr/bin/env bash
# window.sh - the desktop port in a real (virtual) X server: pixels, keys, sizes, controllers, no sound card; and that a
# played frame is the frame `curtain render` makes.
. "$(dirname "$0")/../xserver.sh"
play_rom=$repo/roms/glasstide
# A card that cannot be there, and nobody's settings.
export SDL_AUDIODRIVER=alsa AUDIODEV=none

for program in port_probe port_pads; do
    ${CC:-cc} -std=c11 -D_DEFAULT_SOURCE -O1 $(sdl2-config --cflags) -o $program "$repo/tests/machine/$program.c" \
        "$repo"/platform/{sdl2,stdio,posix,posix_process}.c $(sdl2-config --libs) || exit 2
done

# same_pixels NAME WIN_W WIN_H: the window shows the probe's picture of 240x160 so; it may take a few frames to.
same_pixels() {
    ./port_probe expect 240 160 "$2" "$3" >want.rgb
    check "$1" wait_until is_shown
}
is_shown() { screenshot rgb:shot.rgb && cmp shot.rgb want.rgb; }
start_openbox # fullscreen needs a window manager

# ---- pictures ----
if start "port probe" ./port_probe show 240 160 2; then
    check "the window at scale 2" window_size_is 480x320
    same_pixels "pixels at scale 2" 480 320
    for size in 501x333 479x700 240x161; do
        timeout 100 xdotool windowsize --sync "$win" ${size/x/ }
        same_pixels "pixels in a window of $size" ${size/x/ }
    done
    xdotool key --delay 100 f
    same_pixels "pixels in fullscreen" 1100 1000
    xdotool key --delay 100 f
    same_pixels "pixels after fullscreen" 240 161
    stop Escape
fi
if start "port probe" ./port_probe show 64 1000 0; then
    check "a picture taller than the screen gets scale 1" window_size_is 64x1000
    stop Escape
fi

# ---- switches ----
labels() { [ "$(sed -n 's/^label //p' out | paste -sd ' ')" = "W A" ]; }
setxkbmap fr
if start "port probe" ./port_probe show 240 160 1; then
    xdotool key --delay 100 52 24 37 # by place: the first of the lowest row, the first of the upper one, Ctrl
    check "what is printed on three keys, one of which has no character" wait_until labels
    stop Escape
fi
setxkbmap us
if start "port probe" ./port_probe show 240 160 2; then
    # HID usages: A 4, Left 80, Shift 225, keypad 5 93
    for pair in a:4 Left:80 Shift_L:225 KP_5:93; do
        xdotool keydown "${pair%:*}"
        check "${pair%:*} arrives" wait_until says "key ${pair#*:} down"
        xdotool keyup "${pair%:*}"
        check "${pair%:*} is released" wait_until says "key ${pair#*:} up"
    done
    kill -STOP $child
    xdotool key --delay 1 z
    kill -CONT $child
    check "a tap between two polls arrives" wait_until says "key 29 down"
    check "and is over" wait_until says "key 29 up"
    xdotool keydown x
    check "x arrives" wait_until says "key 27 down"
    xdotool windowfocus "$(xdotool search --maxdepth 0 '.*' 2>/dev/null | head -1)" 2>/dev/null
    check "a window that loses the keyboard releases it" wait_until says "key 27 up"
    xdotool keyup x
    timeout 100 xdotool windowfocus --sync "$win"
    xdotool type q
    check "typed text arrives" wait_until says "text q"
    xdotool mousemove --window "$win" 101 51 click 1
    check "the mouse is in picture pixels" wait_until says "mouse 1 at 50 25"
    check "no card, no sound" says "sound 0"
    check "which is reported" grep -q "no sound" err
    stop Escape
    check "closing twice is harmless" says closed
fi
if SDL_AUDIODRIVER=dummy start "port probe" ./port_probe show 64 64 1; then
    check "with a card there is sound" says "sound 1"
    kill -TERM $child
    check "SIGTERM is a quit" wait_until says closed
    kill_program
fi
check "controllers" env SDL_VIDEODRIVER=dummy ./port_pads
refuse "no display is refused" "cannot open a window" env DISPLAY=:9999 SDL_VIDEODRIVER=x11 ./port_probe show 64 64 1

# ---- a game: the picture played is the picture rendered, as the settings show it; screenshot and demo are plain ----
# While paused our own words stand on the last 8 lines; above them every pixel of the window must be the picture's.
picture() { # FILE SIZE: raw pixels without the words; a frame is scaled by 2 and centred
    convert "$1" -background black -gravity center -extent 601x777 -gravity north \
        -fill black -draw 'rectangle 60,692 539,707' -depth 8 rgb:-
}
rendered() { # FOLDER OPTION...: the demo's last frame
    local frame
    frame=$("$curtain" hash "$play_rom" --demo one.demo | tail -1 | cut -d' ' -f1)
    "$curtain" render "$play_rom" --demo one.demo --frames "$frame" "${@:2}" -o "$1"
}
mkdir -p data/curtain
printf '%s\n' 'dim = half' 'colours = protan' 'flashes = soft' 'border = no' >data/curtain/curtain.conf
if start "Glass Tide" "$OUT/curtain" play "$play_rom" --seed 0 --scale 2 --mute --record one.demo; then
    timeout 100 xdotool windowsize --sync "$win" 601 777
    for key in Return Return z z z z z z z z; do # more than there are menus: in the game it is fire
        xdotool key --delay 120 $key
        wait_cpu 16
    done
    for key in p period F12; do
        xdotool key --delay 100 $key
        wait_cpu 5
    done
    check "a screenshot" wait_until grep -q "^saved " err
    screenshot png:paused.png
    stop
    rm data/curtain/curtain.conf
    check "the demo holds" "$curtain" verify "$play_rom" one.demo
    check "its last frame" rendered plain
    check "the screenshot is that frame" cmp "$(sed -n 's/^saved //p' err)" plain/*.png
    check "as the settings show it" rendered seen --dim half --colours protan --flashes soft
    convert seen/*.png -scale 200% want.png
    check "the window shows it" cmp <(picture paused.png) <(picture want.png)
    "$curtain" hash "$play_rom" --demo one.demo --parts | grep -o ' player=[0-9a-f]*' | sort -u >players
    check "keys start the game" test "$(wc -l <players)" -gt 1
fi

# ---- a folder that is wrong at launch: a window of its own until it is right ----
game g <<<'local x = = 3'
if start "Curtain" "$OUT/curtain" play g --scale 2; then
    check "the mistake has a window" wait_until window_size_is 800x600
    check "and a line in the log" grep -q "^curtain: g: main.lua:1: unexpected symbol near '='$" err
    echo 'print "it runs"' >g/main.lua
    title=Probe
    check "when it is right, the game has its own window" wait_until find_window
    check "of its own size" wait_until window_size_is 128x128
    check "and runs" wait_until grep -qx 'it runs' err
    kill_program
fi
finish

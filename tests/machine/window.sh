#!/usr/bin/env bash
# window.sh - the desktop port in a real (virtual) X server: pixels, keys, sizes, controllers, no sound card; and that a
# played frame is the frame `curtain render` makes, at every scale.
. "$(dirname "$0")/../xserver.sh"
play_rom=$repo/roms/glasstide
cd "$repo" || exit 2
# A card that cannot be there, and nobody's settings.
export SDL_AUDIODRIVER=alsa AUDIODEV=none

for program in port_probe port_pads; do
    ${CC:-cc} -std=c11 -D_DEFAULT_SOURCE -O1 $(sdl2-config --cflags) -o "$scratch/$program" \
        tests/machine/$program.c platform/{sdl2,stdio,posix,posix_process}.c $(sdl2-config --libs) || exit 2
done
probe=$scratch/port_probe

# same_pixels W H WIN_W WIN_H: the window shows the probe's picture so; it may take a few frames to.
same_pixels() {
    "$probe" expect "$@" >"$scratch/want.rgb"
    wait_until settled || { cmp "$scratch/shot.rgb" "$scratch/want.rgb"; return 1; }
}
settled() { screenshot "rgb:$scratch/shot.rgb" && cmp -s "$scratch/shot.rgb" "$scratch/want.rgb"; }

# ---- pictures ----
for scale in 1 2 3; do
    if start "port probe" "$probe" show 240 160 $scale; then
        check "the window at scale $scale" window_size_is $((240 * scale))x$((160 * scale))
        check "pixels at scale $scale" same_pixels 240 160 $((240 * scale)) $((160 * scale))
        stop Escape
    fi
done
if start "port probe" "$probe" show 240 160 2; then
    for size in 501x333 777x481 479x700 240x161 719x479 1000x163; do
        timeout 100 xdotool windowsize --sync "$win" ${size/x/ }
        check "pixels in a window of $size" same_pixels 240 160 ${size/x/ }
    done
    stop Escape
fi
if start "port probe" "$probe" show 64 1000 0; then
    check "a picture taller than the screen gets scale 1" window_size_is 64x1000
    stop Escape
fi

# ---- fullscreen: X has it only with a window manager ----
start_openbox

# ---- what is printed on keys: the window manager is there all the time, for a server without a client forgets it ----
labels() { [ "$(sed -n 's/^label //p' "$scratch/out" | paste -sd ' ')" = "$1" ]; }
for layout in fr:W:A de:Y:Q us:Z:Q; do
    setxkbmap "${layout%%:*}"
    if start "port probe" "$probe" show 240 160 1; then
        xdotool key --delay 100 52 24 37 # by place: the first of the lowest row, the first of the upper one, Ctrl
        wanted=${layout#*:}
        check "${layout%%:*}: what is printed on three keys, one of which has no character" \
            wait_until labels "${wanted/:/ }"
        stop Escape
    fi
done

if start "port probe" "$probe" show 240 160 2; then
    check "pixels before fullscreen" same_pixels 240 160 480 320
    xdotool key --delay 100 f
    check "pixels in fullscreen" same_pixels 240 160 1100 1000
    xdotool key --delay 100 f
    check "pixels after fullscreen" same_pixels 240 160 480 320
    stop Escape
fi
if start "port probe" "$probe" show 240 160 1 full; then
    check "pixels in fullscreen from the start" same_pixels 240 160 1100 1000
    stop Escape
fi
kill $wm
wait $wm 2>/dev/null
wm=

# ---- switches ----
if start "port probe" "$probe" show 240 160 2; then
    # HID usages: A 4, Left 80, Shift 225, Enter 40, keypad 5 93, F12 69
    for pair in a:4 Left:80 Shift_L:225 Return:40 KP_5:93 F12:69; do
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
    check "a window that loses the keyboard lets go" wait_until says "key 27 up"
    xdotool keyup x
    timeout 100 xdotool windowfocus --sync "$win"
    xdotool type q
    check "typed text arrives" wait_until says "text q"
    xdotool mousemove --window "$win" 101 51 click 1
    check "the mouse is in picture pixels" wait_until says "mouse 1 at 50 25"
    check "no card, no sound" says "sound 0"
    check "which is mentioned" grep -q "no sound" "$scratch/err"
    stop Escape
    check "closing twice is harmless" says closed
fi
if SDL_AUDIODRIVER=dummy start "port probe" "$probe" show 64 64 1; then
    check "with a card there is sound" says "sound 1"
    kill -TERM $child
    check "SIGTERM is a quit" wait_until says closed
    kill_program
fi
check "controllers" env SDL_VIDEODRIVER=dummy "$scratch/port_pads"
refuse "no display at all is refused" "no display" env -u DISPLAY -u WAYLAND_DISPLAY "$probe" show 64 64 1
refuse "no display is refused" "cannot open a window" env DISPLAY=:9999 SDL_VIDEODRIVER=x11 "$probe" show 64 64 1

# ---- a game: the picture played is the picture rendered ----
# While paused our own words stand on the last 8 lines; above them every pixel of the window must be the picture's.
window_rgb() { screenshot "rgb:$1"; }
expected_rgb() { # SHOT SCALE WIN_W WIN_H OUT: the picture by whole pixels, centred on black
    convert "$1" -scale "${2}00%" -background black -gravity center -extent "${3}x$4" -depth 8 "rgb:$5"
}
# Blackens the words' lines of a window: rows TOP to TOP + 8 SCALE, columns LEFT to LEFT + W SCALE.
without_words() { # FILE WIN_W WIN_H LEFT TOP W H
    convert -size "$2x$3" -depth 8 "rgb:$1" -fill black -draw "rectangle $4,$5 $(($4 + $6 - 1)),$(($5 + $7 - 1))" \
        -depth 8 "rgb:$1"
}
shows() { # SHOT SCALE WIN_W WIN_H
    local left=$((($3 - 240 * $2) / 2)) top=$((($4 - 320 * $2) / 2 + 312 * $2))
    window_rgb got.rgb && expected_rgb "$1" "$2" "$3" "$4" want.rgb &&
        without_words got.rgb "$3" "$4" $left $top $((240 * $2)) $((8 * $2)) &&
        without_words want.rgb "$3" "$4" $left $top $((240 * $2)) $((8 * $2)) && cmp got.rgb want.rgb
}
play_at() { # SCALE [WIN_W WIN_H]
    local scale=$1 w=${2:-$((240 * $1))} h=${3:-$((320 * $1))} shot frame
    rm -rf "$scratch/play" && mkdir -p "$scratch/play" && cd "$scratch/play" || exit 2
    start "Glass Tide" "$OUT/curtain" play "$play_rom" --seed 0 --scale "$scale" --mute --record one.demo || return
    [ $# = 1 ] || timeout 100 xdotool windowsize --sync "$win" "$w" "$h"
    xdotool key --delay 150 Return key --delay 150 z # the title is left: keys play the game
    wait_cpu 20
    for key in p period F12; do
        xdotool key --delay 100 $key
        wait_cpu 5
    done
    check "a screenshot at ${w}x$h" wait_until grep -q "^saved " "$scratch/err"
    shot=$(sed -n 's/^saved //p' "$scratch/err" | head -1)
    check "the window of ${w}x$h shows it" wait_until shows "$shot" "$scale" "$w" "$h"
    stop
    frame=$("$curtain" hash "$play_rom" --demo one.demo | tail -1 | cut -d' ' -f1)
    check "renders frame $frame of the demo" "$curtain" render "$play_rom" --demo one.demo --frames "$frame" -o out
    check "the screenshot is that frame" cmp "$shot" "$(echo out/*.png)"
    check "the demo holds" "$curtain" verify "$play_rom" one.demo
}
play_at 2
play_at 2 601 777

# How a player sees the picture is the window's: neither a screenshot nor the demo knows of it.
seen_as() { # BYTES-AT-LEAST BYTES-AT-MOST: the window is seen/*.png above three lines of words, but for so many bytes
    local n
    expected_rgb "$(echo seen/*.png)" 1 240 320 want.rgb && without_words want.rgb 240 320 0 296 240 24 &&
        without_words got.rgb 240 320 0 296 240 24 || return 1
    n=$(cmp -l got.rgb want.rgb | wc -l)
    [ "$n" -ge "$1" ] && [ "$n" -le "$2" ] || { echo "$n bytes differ"; return 1; }
}
view_at() { # SETTINGS LEAST MOST OPTIONS-OF-RENDER...
    local shot frame
    rm -rf "$scratch/view" && mkdir -p "$scratch/view" "$scratch/data/curtain" && cd "$scratch/view" || exit 2
    tr , '\n' <<<"$1" >"$scratch/data/curtain/curtain.conf"
    start "Glass Tide" "$OUT/curtain" play "$play_rom" --seed 0 --scale 1 --mute --stage one --record one.demo || return
    wait_cpu 20
    for key in p period F12; do
        xdotool key --delay 100 $key
        wait_cpu 5
    done
    check "$1: a screenshot" wait_until grep -q "^saved " "$scratch/err"
    shot=$(sed -n 's/^saved //p' "$scratch/err" | head -1)
    check "$1: the window" window_rgb got.rgb
    stop
    rm "$scratch/data/curtain/curtain.conf"
    frame=$("$curtain" hash "$play_rom" --demo one.demo | tail -1 | cut -d' ' -f1)
    check "$1: frame $frame" "$curtain" render "$play_rom" --demo one.demo --frames "$frame" -o plain
    check "$1: the same seen so" "$curtain" render "$play_rom" --demo one.demo --frames "$frame" "${@:4}" -o seen
    check "$1: the window shows it" seen_as "$2" "$3"
    check "$1: the screenshot is the plain picture" cmp "$shot" "$(echo plain/*.png)"
    check "$1: the demo holds" "$curtain" verify "$play_rom" one.demo
}
view_at "dim = half,colours = protan,flashes = soft" 0 0 --dim half --colours protan --flashes soft
view_at "hitbox = yes" 60 156 # its 52 pixels, of three bytes each, where they are other than the ship's

# Keys start the game: from the title through the menus into the stage.
cd "$scratch" || exit 2
if start "Glass Tide" "$OUT/curtain" play "$play_rom" --seed 0 --scale 1 --mute --record keys.demo; then
    for key in Return Return z z z z z z z z; do # more than there are menus: in the game it is fire
        xdotool key --delay 120 $key
        wait_cpu 16
    done
    xdotool keydown z keydown Left
    wait_cpu 40
    xdotool keyup z keyup Left
    stop
    "$curtain" hash "$play_rom" --demo keys.demo --parts >parts
    "$curtain" hash "$play_rom" --parts --frames 1 | tail -1 >idle
    # The last shots may have left the field before the window was gone.
    check "keys start the game and fire" grep -qv "$(grep -o ' shots=[0-9a-f]*' idle)" parts
    check "a player is in it" \
        [ "$(tail -1 parts | grep -o ' player=[0-9a-f]*')" != "$(grep -o ' player=[0-9a-f]*' idle)" ]
fi
finish

#!/usr/bin/env bash
# looks.sh - turned, smooth, with the look of a tube, in a border, with panels beside it: what a window of the desktop
# port shows in a real (virtual) X server is, pixel by pixel, what the program composes for one of that size on a port
# that is none (port_keys.c); as a window, in another size, and in fullscreen.
. "$(dirname "$0")/../xserver.sh"
export SDL_AUDIODRIVER=dummy
build_player

# A picture that stands, with 256 colours and no symmetry.
game g <<'LUA'
for i = 1, 255 do palette.set(i, i * 0x9E3779 % 0x1000000) end
for i = 1, 16 do sprite.put { sprite = 'dot', x = i * 13 % 117, y = i * 29 % 91, bank = i % 16 } end
LUA
sed -i 's/screen = { w = 64, h = 64/screen = { w = 128, h = 96/' g/rom.lua
convert -size 400x440 'gradient:#802020-#204080' -alpha set \( -size 256x192 xc:white \) -geometry +80+60 \
    -compose DstOut -composite g/art/border.png || exit 2
sed -i 's|^  board =|  border = "art/border.png",\n&|' g/rom.lua

settings() { mkdir -p data/curtain && printf '%b' "$1" >data/curtain/curtain.conf; }
compose() { # WxH: want.rgb is what the program shows there, after keys as in `pressed`
    { for _ in $(seq 5); do echo; done; echo "$pressed"; for _ in $(seq 9); do echo; done; } |
        KEYS_WHOLE=1 KEYS_WINDOW=$1 KEYS_PPM=15 ./player play g >none 2>none.err || return
    local w h scale
    read -r w h < <(sed -n '1s/P6 \([0-9]*\) \([0-9]*\).*/\1 \2/p' picture.ppm)
    scale=$((${1%x*} / w < ${1#*x} / h ? ${1%x*} / w : ${1#*x} / h)) # 1 of what was composed
    convert picture.ppm -scale "${scale}00%" -background black -gravity center -extent "$1" -depth 8 rgb:want.rgb
}
is_shown() { screenshot rgb:shot.rgb && cmp shot.rgb want.rgb; }
shows() { # WxH
    wait_until window_size_is "$1" && compose "$1" && wait_until is_shown
}
looks() { # SETTINGS NATURAL: the window opens in that size; then as large as another, and fullscreen
    local natural=$2
    pressed=${3:-}
    settings "$1"
    start Probe "$OUT/curtain" play g --mute || return
    [ -z "$pressed" ] || xdotool key --delay 100 "$4"
    check "$1 in its own size" shows "$natural"
    timeout 100 xdotool windowsize --sync "$win" 701 555
    check "$1 in 701 x 555" shows 701x555
    xdotool key --delay 100 F11
    check "$1 in fullscreen" shows 1100x1000
    xdotool key --delay 100 F11
    check "$1 in a window again" shows 701x555
    stop
}
start_openbox

looks 'border = no\nscale = 2\nturn = left\n' 192x256
looks 'border = no\nscale = 3\ncrt = yes\n' 384x288
looks 'scale = 2\nscaling = smooth\ncrt = yes\nturn = left\nborder = yes\n' 192x256
looks 'border = no\nscale = 2\npanels = beside\n' 256x192 10 g
# The screen is 1100 x 1000, a title and edges take up to 42 rows of it: 8 times 128 columns, 7 1/4 times 128 rows.
looks 'border = no\n' 1024x768
looks 'border = no\nturn = left\nscaling = smooth\n' 696x928
finish

#!/usr/bin/env bash
# window.sh - the desktop port in a real (virtual) X server: pixels, keys, sizes, no sound card.
#
#     tests/window.sh [CURTAIN ROM]     with both: also that a played frame is the frame `curtain render` makes
#
# Needs Xvfb, xdotool, xwd, ImageMagick, SDL2. CC and BUILD (a folder for what it makes) may be set. Exit 77: a tool is missing.
set -u
cd "$(dirname "$0")/.."
for tool in Xvfb xdotool xwd convert sdl2-config; do
    command -v $tool >/dev/null || { echo "window.sh: skipped, no $tool" >&2; exit 77; }
done
: "${CC:=cc}" "${BUILD:=build/window}"
mkdir -p "$BUILD"
BUILD=$(cd "$BUILD" && pwd)
failures=0 xvfb= child= wm=
# A card that cannot be there, and nobody's settings.
export SDL_AUDIODRIVER=alsa AUDIODEV=none XDG_DATA_HOME=$BUILD/data
trap 'for p in $child $wm $xvfb; do kill $p 2>/dev/null; done' EXIT

fail() { echo "window.sh: FAILED: $*" >&2; failures=$((failures + 1)); }
pass() { [ -t 1 ] && echo "ok: $*"; return 0; }
check() { if [ "$2" = "$3" ]; then pass "$1"; else fail "$1: got \"$2\", want \"$3\""; fi; }

# until CONDITION...: up to 5 s
until_true() { for _ in $(seq 100); do "$@" && return 0; sleep 0.05; done; return 1; }
says() { grep -qx -- "$1" "$BUILD/out"; }
gone() { ! kill -0 "$child" 2>/dev/null; }

flags="-std=c11 -O1 -Wall -Wextra"
for program in port_probe port_pads; do
    $CC $flags $(sdl2-config --cflags) -o "$BUILD/$program" tests/machine/$program.c platform/sdl2.c platform/stdio.c \
        $(sdl2-config --libs) || exit 2
done

# X picks a free display number and tells it.
Xvfb -displayfd 3 -screen 0 1100x900x24 -nolisten tcp 3>"$BUILD/display" >/dev/null 2>&1 &
xvfb=$!
until_true test -s "$BUILD/display" || { echo "window.sh: Xvfb does not start" >&2; exit 2; }
DISPLAY=:$(cat "$BUILD/display")
export DISPLAY

# start TITLE COMMAND...: sets child, title and win (SDL may replace its window by another)
start() {
    title=$1
    shift
    "$@" >"$BUILD/out" 2>"$BUILD/err" &
    child=$!
    win=
    until_true found "$title" || { fail "$*: no window: $(cat "$BUILD/err")"; end; return 1; }
    timeout 5 xdotool windowfocus --sync "$win"
    xdotool windowmove "$win" 0 0
}
found() { win=$(xdotool search --onlyvisible --name "^$1\$" 2>/dev/null | head -1); [ -n "$win" ]; }
stop() {
    xdotool key Escape
    until_true gone || fail "does not end on Escape"
    kill -KILL "$child" 2>/dev/null
    wait "$child"
    check "exit code" $? "$1"
    child=
}
end() {
    kill -KILL "$child" 2>/dev/null
    wait "$child"
    child=
}

# The window's pixels, RGB, once they no longer change (a resize takes a few pictures).
settled() {
    found "$title" && xwd -silent -id "$win" -out "$BUILD/shot.xwd" 2>/dev/null &&
        convert "xwd:$BUILD/shot.xwd" -depth 8 "rgb:$BUILD/shot.rgb" 2>/dev/null && cmp -s "$BUILD/shot.rgb" "$BUILD/want.rgb"
}
# picture WHAT W H WIN_W WIN_H
picture() {
    "$BUILD/port_probe" expect "$2" "$3" "$4" "$5" >"$BUILD/want.rgb"
    until_true settled || fail "$1: pixels differ: $(cmp "$BUILD/shot.rgb" "$BUILD/want.rgb" 2>&1)"
}

size_of() { xdotool getwindowgeometry --shell "$win" | sed -n 's/^WIDTH=//p;s/^HEIGHT=//p' | paste -sd x; }

# ---- pictures ----
for scale in 1 2 3; do
    start "port probe" "$BUILD/port_probe" show 240 160 $scale || continue
    check "window at scale $scale" "$(size_of)" "$((240 * scale))x$((160 * scale))"
    picture "scale $scale" 240 160 $((240 * scale)) $((160 * scale))
    stop 0
done
if start "port probe" "$BUILD/port_probe" show 240 160 2; then
    for size in 501x333 777x481 479x700 240x161 719x479 1000x163; do
        timeout 5 xdotool windowsize --sync "$win" ${size/x/ }
        picture "window of $size" 240 160 ${size/x/ }
    done
    stop 0
fi
if start "port probe" "$BUILD/port_probe" show 64 1000 0; then
    check "a picture taller than the screen's comfort has scale 1" "$(size_of)" "64x1000"
    stop 0
fi

# Without a window manager X has no fullscreen.
managed() { xprop -root _NET_SUPPORTING_WM_CHECK 2>/dev/null | grep -q "window id"; }
fullscreen() {
    openbox --sm-disable >/dev/null 2>&1 &
    wm=$!
    until_true managed
    if start "port probe" "$BUILD/port_probe" show 240 160 2; then
        picture "window before" 240 160 480 320
        xdotool key --delay 100 f
        picture "fullscreen by key" 240 160 1100 900
        xdotool key --delay 100 f
        picture "and back" 240 160 480 320
        stop 0
    fi
    if start "port probe" "$BUILD/port_probe" show 240 160 1 full; then
        picture "fullscreen from the start" 240 160 1100 900
        stop 0
    fi
    kill $wm
    wait $wm 2>/dev/null
    wm=
}
if command -v openbox xprop >/dev/null; then fullscreen; else echo "window.sh: fullscreen skipped, no openbox" >&2; fi

# ---- switches ----
if start "port probe" "$BUILD/port_probe" show 240 160 2; then
    # HID usages: a 4, Left 80, Shift 225, Enter 40, keypad 5 93
    for pair in a:4 Left:80 Shift_L:225 Return:40 KP_5:93 F12:69; do
        xdotool keydown "${pair%:*}"
        until_true says "key ${pair#*:} down" || fail "key ${pair%:*} does not arrive"
        xdotool keyup "${pair%:*}"
        until_true says "key ${pair#*:} up" || fail "key ${pair%:*} stays down"
    done
    kill -STOP $child
    xdotool key --delay 1 z
    kill -CONT $child
    until_true says "key 29 down" || fail "a tap between two polls is lost"
    until_true says "key 29 up" || fail "the tap stays down"
    xdotool keydown x
    until_true says "key 27 down" || fail "x does not arrive"
    kill -STOP $child
    xdotool windowfocus "$(xdotool search --maxdepth 0 '.*' 2>/dev/null | head -1)" 2>/dev/null
    kill -CONT $child
    xdotool keyup x
    until_true says "key 27 up" || fail "a key stays down when the window loses the keyboard"
    timeout 5 xdotool windowfocus --sync "$win"
    xdotool type q
    until_true says "text q" || fail "typed text does not arrive"
    xdotool mousemove --window "$win" 101 51 click 1
    until_true says "mouse 1 at 50 25" || fail "mouse: $(grep mouse "$BUILD/out")"
    check "no card, no sound" "$(grep sound "$BUILD/out")" "sound 0"
    grep -q "no sound" "$BUILD/err" || fail "a missing card is not mentioned"
    stop 0
    says closed || fail "plat_close twice is not harmless"
fi
if SDL_AUDIODRIVER=dummy start "port probe" "$BUILD/port_probe" show 64 64 1; then
    check "with a card there is sound" "$(grep sound "$BUILD/out")" "sound 1"
    kill -TERM $child
    until_true says closed || fail "SIGTERM is not a quit"
    wait $child
    child=
fi
SDL_VIDEODRIVER=dummy "$BUILD/port_pads" || fail "controllers"
DISPLAY=:9999 SDL_VIDEODRIVER=x11 "$BUILD/port_probe" show 64 64 1 >/dev/null 2>"$BUILD/err"
check "no display: refused" "$?" 1
grep -q "cannot open a window" "$BUILD/err" || fail "no display: nothing said"

# ---- a game: the picture played is the picture rendered ----
if [ $# -ge 2 ]; then
    curtain=$(realpath "$1") rom=$(realpath "$2")
    rm -rf "$BUILD/play" "$BUILD/data"
    mkdir -p "$BUILD/play"
    cd "$BUILD/play" || exit 2
    if start ".*" "$curtain" play "$rom" --seed 0 --scale 2 --mute --record one.demo; then
        sleep 1
        xdotool key --delay 100 p
        sleep 0.3
        xdotool key --delay 100 period
        sleep 0.3
        xdotool key --delay 100 F12
        until_true grep -q "^wrote " "$BUILD/err" || fail "no screenshot: $(cat "$BUILD/err")"
        shot=$(sed -n 's/^wrote //p' "$BUILD/err" | head -1)
        xwd -silent -id "$win" | convert xwd:- window.png
        stop 0
        frame=$("$curtain" hash "$rom" --demo one.demo | tail -1 | cut -d' ' -f1)
        "$curtain" render "$rom" --demo one.demo --frames "$frame" -o out || fail "render"
        cmp "$shot" out/*.png || fail "the screenshot at frame $frame is not the frame rendered"
        # Our words stand on the first lines; what is below them must be the picture, each pixel four.
        h=$(identify -format %h "$shot")
        for name in window "$shot"; do
            scale=100; [ "$name" = window ] || scale=200
            convert "${name%.png}.png" -filter point -resize $scale% -gravity south -crop "x$((2 * h - 16))+0+0" +repage \
                -depth 8 "rgb:${name%.png}.rgb"
        done
        cmp window.rgb "${shot%.png}.rgb" || fail "the window at frame $frame is not the frame rendered"
        "$curtain" verify "$rom" one.demo || fail "the demo does not hold"
    fi
fi

[ $failures -eq 0 ] && echo "window.sh: all held" || echo "window.sh: $failures failed" >&2
[ $failures -eq 0 ]

#!/usr/bin/env bash
# backwards.sh - a playback in a real (virtual) window, gone to and fro in by keys and mouse: the window's pictures, bar
# of time and words included, are those of tests/golden/backwards, and under them lie the frames that `render` makes.
#
#     CURTAIN_UPDATE=1 tests/machine/backwards.sh     makes tests/golden/backwards anew
. "$(dirname "$0")/../xserver.sh"
rom=$repo/roms/glasstide golden=$repo/tests/golden/backwards
export SDL_AUDIODRIVER=dummy

window_png() { screenshot "png24:$1"; }
pixels() { convert "$1" -depth 8 rgb:- 2>/dev/null; }
is_golden() { window_png now.png && cmp -s <(pixels now.png) <(pixels "$golden/$1.png"); }
# No two presses in one poll: a press is over when the window shows what it did, or the program has gone round for long
# and it does nothing.
key() {
    window_png before.png
    local from
    from=$(cpu_used)
    xdotool key --delay 100 "$1"
    until [ $(($(cpu_used) - from)) -gt 60 ] || { window_png after.png &&
        ! cmp -s <(pixels before.png) <(pixels after.png); }; do sleep 0.1; done
    sleep 0.3
}
# It has gone round for a while, and its picture stays the same.
is_still() {
    window_png one.png || return 1
    wait_cpu 20
    window_png two.png && cmp -s <(pixels one.png) <(pixels two.png)
}
# The golden picture of that name comes. A picture that stands for three looks is the last that will: then it does not.
comes() {
    local still=0
    until is_golden "$1"; do
        if is_still; then still=$((still + 1)); else still=0; fi
        [ $still -lt 3 ] && ! has_exited || return 1
    done
}
# shown NAME FRAME WHAT: the window is the golden picture NAME; its middle is FRAME's
shown() {
    "$curtain" render "$rom" --demo "$demo" --frames "$2" -o want 2>/dev/null
    if [ -n "${CURTAIN_UPDATE:-}" ]; then
        wait_until is_frame "$2" && is_still
        window_png "$golden/$1.png"
    fi
    check "$3" comes "$1"
    check "... which is frame $2" is_frame "$2"
}
is_frame() { window_png now.png && cmp <(middle now.png) <(middle "want/$(printf %06d "$1").png"); }
middle() { convert "$1" -crop 240x288+0+8 +repage -depth 8 rgb:- 2>/dev/null; }

# The frames of a demo's moments but waves and what practice is counted by, from its file
# (docs/reference/demo-format.md).
moments() {
    python3 - "$1" <<'PY'
import struct, sys
data, at, frames = open(sys.argv[1], "rb").read(), 8, []
while at + 12 <= len(data):
    kind, size = struct.unpack("<II", data[at:at + 8])
    frame, mark = struct.unpack("<IB", data[at + 8:at + 13]) if kind == ord("M") else (0, 2)
    if mark < 6 and mark != 2 and frame not in frames:
        frames.append(frame)
    at += size + 12
print("\n".join(map(str, frames)))
PY
}
demo=${CURTAIN_DEMO:-$rom/demos/run.demo}
frames=$("$curtain" verify "$rom" "$demo" 2>&1 | sed -n 's/.*, \([0-9]*\) frames.*/\1/p') # of it
mkdir -p "$golden"
if start "Glass Tide" "$OUT/curtain" play "$rom" --demo "$demo" --scale 1; then
    for _ in 1 2 3 4 5; do # wherever it is; the press counts once it is seen
        key p
        is_still && break
    done
    for _ in 1 2 3 4; do key bracketright; done
    at=$(moments "$demo" | sed -n 4p)
    shown 1 "$at" "paused, at the fourth moment"
    key b
    shown 2 $((at - 1)) "a frame back"
    key b
    shown 3 $((at - 2)) "and another"
    key period
    shown 4 $((at - 1)) "one forward"
    xdotool keydown BackSpace
    sleep 0.5
    xdotool keyup BackSpace
    key bracketright
    shown 5 "$at" "backwards for a while, and to the moment after"
    xdotool mousemove --window "$win" 200 316 mousedown 1
    sleep 0.2
    xdotool mouseup 1
    xdotool mousemove --window "$win" 120 100
    shown 6 "$((frames * 198 / 235))" "a click on the bar of time"
    stop
fi
finish

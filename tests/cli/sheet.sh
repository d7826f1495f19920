#!/usr/bin/env bash
# sheet.sh - `curtain render --sheet`: the pictures on a sheet are the frames to the last pixel, each below its number.
. "$(dirname "$0")/../tap.sh"
sandbox

game plain <<'LUA'
bullet.def("orb", { sprite = "dot", hit = "none" })
task.go(function()
  while true do
    bullet.fire { kind = "orb", x = 32, y = 32, speed = 1, dir = rng.dir() }
    wait(3)
  end
end)
LUA
cp -r plain large
sed -i 's/screen = { w = 64, h = 64 }/screen = { w = 320, h = 240 }/' large/rom.lua

part() { convert "$1" -crop "$2" +repage -depth 8 "rgb:$3"; } # PNG WxH+X+Y FILE
same_part() { # SHEET WxH+X+Y PNG: that part of the sheet is the picture
    part "$1" "$2" part.rgb && convert "$3" -depth 8 rgb:whole.rgb && cmp part.rgb whole.rgb
}
ink() { # SHEET WxH+X+Y: pixels that are not the sheet's grey
    convert "$1" -crop "$2" +repage -depth 8 rgb:- | od -An -v -tx1 -w3 | grep -vc '^ 28 28 28$'
}
size() { identify -format '%wx%h' "$1"; }

"$curtain" render plain --frames 1,11,111,70 --sheet s.png -o frames || not_ok "rendered"
same "three and one, with room for the numbers" 208x158 "$(size s.png)"
check "the first frame, from above on the left" same_part s.png 64x64+4+13 frames/000001.png
check "the second beside it, in the order of time" same_part s.png 64x64+72+13 frames/000011.png
check "the third" same_part s.png 64x64+140+13 frames/000070.png
check "the fourth below" same_part s.png 64x64+4+90 frames/000111.png
one=$(ink s.png 64x9+4+4)
same "a number is there" true "$([ "$one" -gt 6 ] && [ "$one" -lt 30 ] && echo true)"
same "of 11 twice as much ink, of 111 three times" "$((2 * one)) $((3 * one))" \
    "$(ink s.png 64x9+72+4) $(ink s.png 64x9+4+81)"
check "of 70 other digits" eval '! cmp -s <(convert s.png -crop 64x9+140+4 +repage rgb:-) \
    <(convert s.png -crop 64x9+72+4 +repage rgb:-)'
same "all else is grey" 0 "$(($(ink s.png 208x4+0+0) + $(ink s.png 4x158+0+0) + $(ink s.png 4x158+68+0)))"

"$curtain" render large --frames 1 --sheet l.png -o frames || not_ok "rendered"
same "wide pictures have larger numbers" 328x264 "$(size l.png)"
check "the picture below" same_part l.png 320x240+4+20 frames/000001.png
same "four times the ink" $((4 * one)) "$(ink l.png 320x16+4+4)"
refuse "too many" "--sheet: too many frames for one picture" "$curtain" render plain --frames 0:1000000 --sheet m.png
finish

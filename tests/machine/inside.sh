#!/usr/bin/env bash
# inside.sh - the console and the overlay in a real (virtual) X server: letters typed on a keyboard, the mouse on a
# bullet.
. "$(dirname "$0")/../xserver.sh"
export SDL_AUDIODRIVER=dummy

game g <<'LUA'
bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })
task.go(function()
  bullet.fire { kind = 'dot', x = 180, y = 40, dir = 90, speed = 0, tag = 'lone' }
  wait(forever)
end)
LUA
sed -i 's/screen = { w = 64, h = 64/screen = { w = 240, h = 320/' g/rom.lua

shows() { screenshot ppm:picture.ppm && python3 "$repo/tests/machine/words.py" picture.ppm "$@"; }
hides() { screenshot ppm:picture.ppm && ! python3 "$repo/tests/machine/words.py" picture.ppm "$@"; }

start Probe "$OUT/curtain" play g --scale 1 --mute || finish
xdotool key --delay 100 grave
check "the console opens" wait_until shows 'Escape: close.'
xdotool type --delay 60 "{ #'p', 20 + 3 }"
check "what is typed is seen, with the case it has" wait_until shows "> { #'p', 20 + 3 }"
xdotool key --delay 100 Return
check "and answered" wait_until shows '{ 1, 23 }'
xdotool key --delay 100 Up key --delay 100 BackSpace
check "lines come back" wait_until shows "> { #'p', 20 + 3"
xdotool key --delay 100 Escape
check "Escape closes it, and nothing more" wait_until hides "> { #'p'"
xdotool key --delay 100 h
xdotool mousemove --window "$win" 181 41
check "the bullet under the mouse is reported" wait_until shows 'kind   dot' 'tag    lone' 'by     task 1 main.lua:4'
xdotool key --delay 100 g
check "with gauges beside it" wait_until shows 'bullets          1    64   256       0' 'kind   dot'
stop
finish

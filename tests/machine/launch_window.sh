#!/usr/bin/env bash
# launch_window.sh - in a real window: a folder that is wrong at launch is reported and waited for.
. "$(dirname "$0")/../xserver.sh"
export SDL_AUDIODRIVER=dummy

game g <<'LUA'
print 'it runs'
local dot = sprite.put { sprite = 'dot', x = 0, y = 30 }
task.go(function()
  while true do
    dot.x = (dot.x + 1) % 64
    wait(1)
  end
end)
LUA
cp g/main.lua right.lua

colours() { # at least N
    screenshot "png:$scratch/seen.png" && [ "$(convert "$scratch/seen.png" -format %k info:)" -ge "$1" ]
}
said() { grep -q -- "$1" "$scratch/err"; }

echo 'local x = = 3' >g/main.lua
if start "Curtain" "$OUT/curtain" play g --scale 2; then
    check "the window is there" wait_until window_size_is 800x600
    check "the log says what is wrong" wait_until said "^curtain: g: main.lua:1: unexpected symbol near '='$"
    check "the window says it: title, sentence, what to do" wait_until colours 4
    cp right.lua g/main.lua
    title=Probe
    check "put right, the game begins" wait_until said "^it runs$"
    check "in its own window" wait_until find_window
    check "of its own size" wait_until window_size_is 128x128
    kill_program
fi

# A monitor that stands upright: so does what is wrong.
echo 'local x = = 3' >g/main.lua
settings=$("$curtain" help config | sed -n 's/^    \(.*curtain.conf\)$/\1/p')
mkdir -p "${settings%/*}"
title_at() { # CROP: the page's title, in its yellow, is in that part of the window
    screenshot "png24:$scratch/seen.png" || return 1
    convert "$scratch/seen.png" -crop "$1" +repage -fill black +opaque '#ffe050' -format '%[fx:maxima>0]' info: |
        grep -qx 1
}
echo 'turn = left' >"$settings"
if start "Curtain" "$OUT/curtain" play g --scale 2; then
    check "turned, the window stands upright" window_size_is 600x800
    check "and its title with it" wait_until title_at 40x400+0+400
    kill_program
fi
rm "$settings"

echo 'local x = = 3' >g/main.lua
if start "Curtain" "$OUT/curtain" play g --scale 1; then
    check "at scale 1" wait_until window_size_is 400x300
    xdotool key Escape
    check "Escape ends it" wait_until has_exited
    wait $child
    same "with the exit code of what is wrong" 2 $?
    kill_program
fi
check "without a display it is refused at once" eval \
    'env -u DISPLAY -u WAYLAND_DISPLAY "$OUT/curtain" play g >out 2>err; [ $? = 2 ] && grep -q "unexpected symbol" err'
finish

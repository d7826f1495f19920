#!/usr/bin/env bash
# dropped.sh - a ROM or a folder that is dropped on the window is played: at once where no run is on, else after a
# question that keeps the run as leaving does; what cannot be played is reported, and the game goes on. The port is a
# script's (port_keys.c): no window, no clock.
. "$(dirname "$0")/../kept.sh"
export KEYS_WHOLE=1

kept_game <<'LUA'
stage.def("one", function() wait(forever) end)
LUA
game b <<'LUA'
bullet.def("dot", { sprite = "dot", hit = { circle = 3 } })
bullet.fire { kind = "dot", x = 20, y = 20, dir = 90, speed = 1 }
LUA
sed -i 's/id = "probe"/id = "other"/; s/"Probe"/"Another"/' b/rom.lua
"$curtain" pack b -o b.rom >none
keys 40 | ./player play b.rom >of_b 2>none

begins() { # the other game's first pictures are among those of out
    local at
    at=$(grep -nx "$(head -1 of_b)" out | head -1 | cut -d : -f 1)
    [ -n "$at" ] || { echo 'it does not begin'; return 1; }
    tail -n "+$at" out | head -n 20 | cmp - <(head -n 20 of_b)
}

{ keys 40; echo '=b.rom'; keys 30; } | plays out
same 'at the title it begins, and all ends well' '0 ' "$? $(cat err)"
check '... from its start' begins
{ keys 40; echo '=b'; keys 20; echo '=g'; keys 9; press $DOWN $ENTER; keys 30; echo '=b'; keys 30; } | plays out
same 'a folder, and back, and again' 2 "$(grep -cx "$(head -1 of_b)" out)"

# A run is on.
rm -rf data
{ begin; keys 300 $Z; echo '=b.rom'; keys 9; press $ENTER; keys 60; } | plays out --seed 5
refuse 'in a run it is asked first, and No comes first' 'does not begin' begins
rm -rf data
{ begin; keys 300 $Z; echo '=b.rom'; keys 9; press $DOWN $ENTER; keys 40; } | plays out --seed 5
check 'with Yes the other game begins' begins
check '... and the run is saved, as by leaving' "$curtain" verify g data/curtain/resume/probe.demo

# What cannot be played.
rm -rf data
continues() { # FILE SENTENCE
    { keys 40; echo "=$1"; keys 30; } | plays out
    same "$1: reported, and the game goes on" "0 curtain: $1$2 72" "$? $(cat err) $(pictures out)"
}
head -c 1000 b.rom >cut.rom
continues cut.rom ": 1000 bytes long, but its header says $(stat -c %s b.rom)"
mkdir empty
continues empty ': rom.lua: no such file'
continues none.rom ': no such file or folder'

# A folder that cannot be played yet is waited for; another game need not be.
echo 'end' >>g/main.lua
{ keys 40; echo '=b.rom'; keys 30; } | plays out
check 'while a folder is waited for, a ROM begins' begins
finish

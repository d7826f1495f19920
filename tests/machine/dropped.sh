#!/usr/bin/env bash
# dropped.sh - a ROM or a folder that is dropped on the window is played: at once where no run is on, else after a
# question that keeps the run as leaving does; what cannot be played is reported, and the game goes on. The port is a
# script's (port_keys.c): no window, no clock.
. "$(dirname "$0")/../kept.sh"
export KEYS_WHOLE=1
ENTER=40 ESCAPE=41 DOWN=81 CTRL=224 Q=20

kept_game <<'LUA'
stage.def("one", function() wait(forever) end)
LUA
game b <<'LUA'
bullet.def("dot", { sprite = "dot", hit = { circle = 3 } })
bullet.fire { kind = "dot", x = 20, y = 20, dir = 90, speed = 1 }
LUA
sed -i 's/id = "probe"/id = "other"/; s/"Probe"/"Another"/' b/rom.lua
"$curtain" pack b -o b.rom || not_ok 'the other game is packed'

plays() { ./player play "$@" >pictures 2>err; } # standard input are the keys
{ keys 40; } | plays b.rom
cp pictures of_b
# begins: where the other game's first picture is, and that the others follow it
at() { grep -nx "$(head -1 of_b)" pictures | head -1 | cut -d : -f 1; }
begins() {
    [ -n "$(at)" ] || { echo 'it does not begin'; return 1; }
    tail -n "+$(at)" pictures | head -n 20 | cmp - <(head -n 20 of_b)
}

{ keys 40; echo '=b.rom'; keys 30; } | plays g
same 'at the title it begins, and all ends well' '0 ' "$? $(cat err)"
check '... at once' [ "$(at)" -lt 45 ]
check '... from its start' begins
{ keys 40; echo '=b'; keys 30; } | plays g
check 'a folder does' begins
{ keys 40; echo '=b.rom'; keys 20; echo '=g'; keys 9; press $DOWN $ENTER; keys 30; echo '=b'; keys 30; } | plays g
same 'and back again, and again' 2 "$(grep -cx "$(head -1 of_b)" pictures)"

# A run is on.
rm -rf data
{ begin; keys 300 $Z; echo '=b.rom'; keys 9; press $ENTER; keys 60; } | plays g --seed 5
refuse 'in a run it is asked first, and no comes first' 'does not begin' begins
{ begin; keys 300 $Z; echo '=b.rom'; keys 9; press $ESCAPE; keys 60; } | plays g --seed 5
refuse 'back is no as well' 'does not begin' begins
rm -rf data
{ begin; keys 300 $Z; echo '=b.rom'; keys 9; press $DOWN $ENTER; keys 40; } | plays g --seed 5
same 'yes is yes' '0 ' "$? $(cat err)"
check '... and the other game begins' begins
verdict() { "$curtain" verify g data/curtain/resume/probe.demo --json | jq -c '[.verdict, .frames]'; }
same '... and the run is kept, as by leaving' '["holds"' "$(verdict | cut -d , -f 1)"

# What cannot be played.
rm -rf data
says() { # NAME LINE FILE
    { keys 40; echo "=$3"; keys 30; } | plays g
    same "$1" "0 $2" "$? $(cat err)"
    same "... and the game goes on" 72 "$(wc -l <pictures)"
}
head -c 1000 b.rom >cut.rom
size=$(stat -c %s b.rom)
says 'a ROM that is cut short' "curtain: cut.rom: 1000 bytes long, but its header says $size" cut.rom
says 'another file' 'curtain: g/art/all.png: not a Curtain ROM' g/art/all.png
mkdir empty
says 'a folder without a game' 'curtain: empty: rom.lua: no such file' empty
says 'what is not there' 'curtain: none.rom: no such file or folder' none.rom

# A folder that cannot be played yet is waited for; another game need not be.
cp -r g broken
echo 'end' >>broken/main.lua
{ keys 40; echo '=b.rom'; keys 30; } | plays broken
same 'while one is waited for: it begins' 0 $?
check '... from its start' begins
finish

#!/usr/bin/env bash
# log.sh - the window's log: a key and the menu open it, the board stands meanwhile and nothing of it is recorded, it
# scrolls, it is there when a fault stands, and its key can be another. The port is a script's (port_keys.c).
. "$(dirname "$0")/../scripted.sh"
export KEYS_WHOLE=1

game g <<'LUA'
task.go(function()
  for i = 1, forever do
    print("frame", i, rng.int(0, 99))
    wait(1)
  end
end)
LUA
cp -r g broken
sed -i 's/    wait(1)/    if i == 50 then local boss; boss.hp = 1 end\n&/' broken/main.lua
sed -i 's/screen = { w = 64, h = 64/screen = { w = 240, h = 320/' g/rom.lua broken/rom.lua

UP=82 DOWN=81 ENTER=40 ESCAPE=41 F8=65 F9=66 PAGE_UP=75
plays() { # GAME OUT
    ./player play "$1" --seed 5 --record "$2.demo" >"$2" 2>err
}
seen() { tail -n 1 "$1"; } # OUT: a hash of the last picture

keys 100 | plays g straight
{ keys 40; press $F8 $UP $UP; keys 20; keys 1 $F8; keys 60; } | plays g log
check 'F8 opens it and closes it: nothing of it is recorded' cmp straight.demo log.demo
same 'while it is open no picture is of the game' '' \
    "$(comm -12 <(part straight 1 100 | sort) <(part log 41 66 | sort))"
{ keys 40; press $F8; keys 1 $ESCAPE; keys 60; } | plays g log
check 'Escape closes it' cmp straight.demo log.demo

{ keys 40; press $F8; keys 9; } | plays g end
{ keys 40; press $ESCAPE $UP $UP $UP $ENTER; keys 9; } | plays g menu
same 'the menu has it, too' "$(seen end)" "$(seen menu)"
{ keys 40; press $ESCAPE; keys 9; } | plays g open
{ keys 40; press $ESCAPE $F8; keys 9; } | plays g above
same 'in a menu F8 opens it above that' "$(seen end)" "$(seen above)"
{ keys 40; press $ESCAPE $F8 $F8; keys 9; } | plays g below
same 'and closes it: the menu stays' "$(seen open)" "$(seen below)"
{ keys 40; press $F8 $UP; keys 9; } | plays g up
check 'it scrolls' files_differ <(seen end) <(seen up)
{ keys 40; press $F8 $UP $UP $DOWN $DOWN; keys 9; } | plays g back
same 'and back' "$(seen end)" "$(seen back)"
{ keys 40; press $F8 $PAGE_UP; keys 9; } | plays g page
check 'by pages' files_differ <(seen up) <(seen page)
{ keys 40; press $F8 c1:1; keys 9; } | plays g pad
check 'by a controller' files_differ <(seen end) <(seen pad)

# A fault stands: its page, the log over it, and its page again. The log is another than one without the fault.
{ keys 90; } | plays broken fault
{ keys 90; press $F8; keys 9; } | plays broken over
{ keys 90; press $F8 $F8; keys 9; } | plays broken after
check 'with a fault it opens' files_differ <(seen fault) <(seen over)
same 'and closes' "$(part after 90 90)" "$(seen after)"
{ keys 49; press $F8; keys 9; } | plays broken before
check 'and has the fault in it' files_differ <(seen before) <(seen over)

mkdir -p data/curtain
echo 'log = f9' >data/curtain/curtain.conf
{ keys 40; press $F9; keys 9; } | plays g bound
same 'another key opens it' "$(seen end)" "$(seen bound)"
{ keys 40; press $F8; keys 58; } | plays g unbound
check 'and its own no more' cmp straight.demo unbound.demo
finish

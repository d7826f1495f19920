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
screen_of g 240x320
cp -r g broken
sed -i 's/    wait(1)/    if i == 50 then local boss; boss.hp = 1 end\n&/' broken/main.lua

F9=66 PAGE_UP=75
last() { # GAME KEY...: the last picture after these keys
    { keys 40; press "${@:2}"; keys 19; } | ./player play "$1" --seed 5 2>err | tail -n 1
}

keys 100 | plays straight --seed 5 --record straight.demo
{ keys 40; press $F8 $UP $UP; keys 20; keys 1 $F8; keys 60; } | plays log --seed 5 --record log.demo
check 'F8 opens it and closes it: nothing of it is recorded' cmp straight.demo log.demo
same 'while it is open no picture is of the game' '' \
    "$(comm -12 <(part straight 1 100 | sort) <(part log 41 66 | sort))"

end=$(last g $F8) up=$(last g $F8 $UP)
differs() { [ "$1" != "$2" ]; }
same 'the menu has it, too' "$end" "$(last g $ESCAPE $UP $UP $UP $ENTER)"
same 'F8 opens it over a menu' "$end" "$(last g $ESCAPE $F8)"
same 'and Escape closes it: the menu stays' "$(last g $ESCAPE)" "$(last g $ESCAPE $F8 $ESCAPE)"
check 'it scrolls' differs "$end" "$up"
same 'and back' "$end" "$(last g $F8 $UP $UP $DOWN $DOWN)"
check 'by pages' differs "$up" "$(last g $F8 $PAGE_UP)"
check 'by a controller' differs "$end" "$(last g $F8 c1:1)"

# A fault stands: the log over its page, and the page again.
{ keys 90; press $F8; keys 9; press $F8; keys 9; } | ./player play broken --seed 5 >fault 2>err
check 'with a fault it opens' differs "$(part fault 90 90)" "$(part fault 100 100)"
same 'and closes' "$(part fault 90 90)" "$(tail -n 1 fault)"

settings 'log = f9'
same 'another key opens it' "$end" "$(last g $F9)"
finish

#!/usr/bin/env bash
# overlay.sh - `play` with the overlay and the console: what they show stands on the picture, and what is recorded,
# saved and played is as if they had not been there; but for a line that is kept. The port is a script's (port_keys.c).
. "$(dirname "$0")/../scripted.sh"

game g <<'LUA'
bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })
local seen = 0
task.go(function()
  for i = 1, forever do
    seen = (seen * 31 + i + (pad.down 'fire' and 7 or 0) + rng.int(0, 99)) % 100000007
    if i % 10 == 1 then bullet.fire { kind = 'dot', x = 40 + seen % 100, y = 60, dir = 90, speed = .5, tag = 'rain'} end
    if i == 30 or i == 150 then save.set('frame', i) end
    wait(1)
  end
end)
LUA
sed -i 's/screen = { w = 64, h = 64/screen = { w = 240, h = 320/' g/rom.lua

H=11 G=10 V=25 N=17 BACKQUOTE=53 ENTER=40 ESCAPE=41 BACKSPACE=42 Z=29 P=19
line() { # TEXT: it is typed, letter by letter, and entered; 2 polls more than it has letters
    local i
    for ((i = 0; i < ${#1}; i++)); do echo "'${1:i:1}"; done
    keys 1 $ENTER
    keys 1
}
plays() { # OUT ARGUMENT...: standard input are the keys
    local out=$1
    shift
    KEYS_WHOLE=1 ./player play g --seed 5 "$@" >"$out" 2>err
}
says() { # TEXT...: picture.ppm does
    python3 "$repo/tests/machine/words.py" picture.ppm "$@"
}

keys 200 | plays straight --record straight.demo
cp data/curtain/probe.nv straight.nv
rm -rf data

# ---- the overlay ----

{ keys 20; keys 1 $H; keys 1; keys 1 $G; keys 1; keys 1 $V; keys 1; keys 1 $N; keys 50 ~70,64; keys 1 $H $G $V $N
    keys 122; } >script
KEYS_PPM=70 plays shown --record shown.demo <script
same 'before it nothing differs' "$(part straight 1 20)" "$(part shown 1 20)"
same 'while it is shown every picture does' '' "$(comm -12 <(part straight 21 77 | sort) <(part shown 21 77 | sort))"
same 'afterwards none' "$(part straight 78 200)" "$(part shown 78 200)"
check 'the demo is the same' cmp straight.demo shown.demo
check 'so are the scores' cmp straight.nv data/curtain/probe.nv
check 'gauges, tasks and random numbers can be read' says 'part          live   top   cap refused' \
    'bullets          7    64   256       0' 'frame 70  random numbers 70  tasks 1' \
    '     1     1 -           main.lua:8' \
    'scripts     0     0'
rm -rf data

keys 60 "~$(seq -s ' ~' 0 0)0,0" >script # the mouse in a corner, where nothing is
{ keys 1 $H; keys 3; } >>script
for x in $(seq 30 8 150); do keys 1 "~$x,75"; done >>script
found=
for n in $(seq 65 79); do
    KEYS_PPM=$n plays shown <script
    says 'kind   dot' 'tag    rain' 'by     task 1 main.lua:8' >/dev/null && found=yes
done
same 'a bullet under the mouse is reported' yes "$found"

# ---- the mixer, and the keys of the volume ----

game m <<'LUA'
music.play("tide")
LUA
sed -i 's/screen = { w = 64, h = 64/screen = { w = 240, h = 320/' m/rom.lua
hears() { # OUT ARGUMENT...: as plays, of the game with music
    local out=$1
    shift
    KEYS_WHOLE=1 ./player play m --seed 5 "$@" >"$out" 2>err
}
F3=60 M=16 MINUS=45 EQUALS=46
keys 150 | hears straight.m --record straight.m.demo
{ keys 20; keys 1 $F3; keys 80; keys 1 $F3; keys 48; } | hears shown.m --record shown.m.demo
same 'the mixer is on the picture, and gone from it' "$(part straight.m 103 150)" "$(part shown.m 103 150)"
check 'the demo is the same with it' cmp straight.m.demo shown.m.demo
{ keys 20; keys 1 $F3; keys 79; } >script
KEYS_PPM=100 hears out <script
check 'piece, bar, beat, tempo and marker can be read' says \
    'bar 0  beat 3 of 4  tempo 133.25  gain 100%' 'marker "drop"' 'no sound device' \
    'm1   tide             fm     o5c      0' 'm2'
{ keys 1 $MINUS; keys 1; keys 1 $MINUS; keys 1; } >script
KEYS_PPM=4 hears out <script
check 'the volume is said' says 'Volume 80%'
{ keys 1 $EQUALS; keys 1; keys 1 $M; keys 1; } >script
KEYS_PPM=2 hears out <script
check 'it ends at 100' says 'Volume 100%'
KEYS_PPM=4 hears out <script
check 'so is silence' says 'Sound off'
{ keys 1 $M; keys 1; } >script
KEYS_PPM=2 plays out <script
check 'and that a game has no sound' says 'This game has no sound'

# ---- the console ----

{ keys 60; keys 1 $BACKQUOTE "'\`"; keys 1; line '20 + 3'; line "bullet.each('rain', function(b) b:remove() end)"
  line 'rng.int(1, 6) - 99 < 0'; keys 5 $Z "'z"; keys 3; } >asked
polls=$(wc -l <asked)
{ cat asked; keys 1 $ESCAPE; keys 139; } >script
rm -rf data
KEYS_PPM=$polls plays asked.out --record asked.demo <script
same 'the game goes on where it stood' "$(part straight 61 200)" "$(part asked.out $((polls + 1)) $((polls + 140)))"
same 'with nothing that was undone' 'asked.demo: holds, 200 frames' "$("$curtain" verify g asked.demo)"
same 'and the demo says nothing of it' 0 "$(flags asked.demo)"
check 'it is the same' cmp straight.demo asked.demo
check 'so are the scores' cmp straight.nv data/curtain/probe.nv
check 'what was typed and answered can be read' says '> 20 + 3' '23' '> rng.int(1, 6) - 99 < 0' 'true' '> zzzzz'
rm -rf data

{ keys 60; keys 1 $BACKQUOTE; keys 1; line 'while true do end'; keys 3; } >script
KEYS_PPM=$(wc -l <script) plays out <script
check 'an endless line ends' says 'infinite loop: more than 10000000 instructions in one line'

# ---- a line that is kept ----

{ keys 60; keys 1 $BACKQUOTE; keys 1; line "keep bullet.each('rain', function(b) b:remove() end)"; keys 1
    keys 1 $ESCAPE; } >kept
polls=$(wc -l <kept)
{ cat kept; keys 160; } >script
plays out --record kept.demo <script
same 'the demo is touched' 2 "$(flags kept.demo)"
"$curtain" verify g kept.demo >out 2>&1
same 'and does not hold' 1 $?
check 'from the frame of the line on' grep -q 'frame 61\b' out
files_differ straight.nv data/curtain/probe.nv && [ -f data/curtain/probe.nv ]
same 'scores of before are kept, those of after are not saved' 0 $?
rm -rf data
{ cat kept; keys 20; keys 100 $BACKSPACE; keys 130; } | plays out # the bar of time goes after 120
same 'nobody goes back behind it' 1 "$(part out $((polls + 60)) $((polls + 119)) | sort -u | wc -l)"
{ cat kept; keys 129; } | plays direct
same 'but to it, and on as before' "$(tail -1 direct)" "$(tail -1 out)"

{ keys 20; keys 1 $BACKQUOTE; keys 1; line 'keep 1'; keys 3; } >script
KEYS_PPM=$(wc -l <script) ./player play g --demo straight.demo <script >out 2>err
check 'in a playback nothing can be kept' says 'unavailable while a demo plays'

# ---- the guide ----

sed -n '/^## Console/,/^## [^C]/s/^    //p' "$repo/docs/guide/17-developing.md" >session
{ keys 30; keys 1 $BACKQUOTE; keys 1; sed -n 's/^> //p' session | while IFS= read -r text; do line "$text"; done
    keys 1; } >script
mapfile -t want < <(cut -c1-50 session)
KEYS_PPM=$(wc -l <script) ./player play "$repo/examples/sandbox" --stage try --seed 0 <script >out 2>err
same 'the guide has lines to try' 6 "$(grep -c '^> ' session)"
check 'what the guide shows is what comes' says "${want[@]}" 'the run is marked as "touched"'
finish

#!/usr/bin/env bash
# overlay.sh - `play` with the overlay and the console: what they show is on the picture, and what is recorded, saved
# and played is as if they had not been there; but for a line that is kept. The port is a script's (port_keys.c).
. "$(dirname "$0")/../scripted.sh"
export KEYS_WHOLE=1

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
screen_of g 240x320

V=25 N=17 F3=60 M=16 MINUS=45 EQUALS=46
line() { # TEXT: it is typed, letter by letter, and entered
    echo "$1" | sed "s/./'&\n/g" | sed '$d'
    press $ENTER
}
play() { plays "$1" --seed 5 "${@:2}"; } # OUT ARGUMENT...: standard input are the keys
last() { # PLAY ARGUMENT...: plays the file script; picture.ppm is the last picture before the end
    KEYS_PPM=$(pictures script) "$@" <script
}

keys 200 | play straight --record straight.demo
cp data/curtain/probe.nv straight.nv
rm -rf data

# ---- the overlay ----

{ keys 20; press $H $G $V; keys 1 $N; keys 50 ~70,64; keys 1 $H $G $V $N; keys 122; } >script
KEYS_PPM=70 play shown --record shown.demo <script
check 'gauges, tasks and random numbers can be read' reads 'part          live   top   cap refused' \
    'bullets          7    64   256       0' 'frame 70  random numbers 70  tasks 1' \
    '     1     1 -           main.lua:8' 'scripts     0     0'
same 'while it is shown every picture is another' '' \
    "$(comm -12 <(part straight 21 77 | sort) <(part shown 21 77 | sort))"
same 'before and afterwards none' "$(part straight 1 20; part straight 78 200)" "$(part shown 1 20; part shown 78 200)"
check 'the demo is the same' cmp straight.demo shown.demo
check 'so are the scores' cmp straight.nv data/curtain/probe.nv
rm -rf data

# ---- the mixer, and the keys of the volume ----

game m <<'LUA'
music.play("tide")
LUA
screen_of m 240x320
hears() { ./player play m --seed 5 >out 2>err; } # plays the game with music
{ keys 20; keys 1 $F3; keys 79; } >script
last hears
check 'piece, bar, beat, tempo and marker can be read' reads \
    'bar 0  beat 3 of 4  tempo 133.25  gain 100%' 'marker "drop"' 'no sound device' \
    'm1   tide             fm     o5c      0' 'm2'
volume() { # WORDS KEY...: what the last key shows
    local words=$1
    press "${@:2}" >script
    last hears
    check "$words" reads "$words"
}
volume 'Volume 80%' $MINUS $MINUS
volume 'Volume 100%' $EQUALS
volume 'Sound off' $M
press $M >script
last play out
check 'a game without sound says so' reads 'This game has no sound'

# ---- the console ----

{ keys 60; keys 1 $BACKQUOTE "'\`"; keys 1; line '20 + 3'; line "bullet.each('rain', function(b) b:remove() end)"
    line 'rng.int(1, 6) - 99 < 0'; keys 5 $Z "'z"; keys 3; } >script
polls=$(pictures script)
{ cat script; keys 1 $ESCAPE; keys 139; } >whole
last play out
check 'what was typed and answered can be read' reads '> 20 + 3' '23' '> rng.int(1, 6) - 99 < 0' 'true' '> zzzzz'
rm -rf data
play asked.out --record asked.demo <whole
same 'the game goes on where it stood' "$(part straight 61 200)" "$(part asked.out $((polls + 1)) $((polls + 140)))"
check 'the demo is the same' cmp straight.demo asked.demo
check 'so are the scores' cmp straight.nv data/curtain/probe.nv
{ keys 60; press $BACKQUOTE; line 'while true do end'; keys 3; } >script
last play out
check 'an endless line ends' reads 'infinite loop: more than 10000000 instructions in one line'

# ---- a line that is kept ----

rm -rf data
{ keys 60; press $BACKQUOTE; line "keep bullet.each('rain', function(b) b:remove() end)"; keys 1
    keys 1 $ESCAPE; } >kept
polls=$(pictures kept)
{ cat kept; keys 160; } | play out --record kept.demo
same 'the demo is touched' 2 "$(flags kept.demo)"
refuse 'and diverges from the frame of the line on' 'frame 61' "$curtain" verify g kept.demo
check 'scores of before are saved, those of after are not' files_differ straight.nv data/curtain/probe.nv
rm -rf data
{ cat kept; keys 20; keys 100 $BACKSPACE; keys 130; } | play out # the bar of time goes after 120
same 'nobody goes back behind it' 1 "$(part out $((polls + 60)) $((polls + 119)) | sort -u | wc -l)"
{ cat kept; keys 129; } | play direct
same 'but to it, and on as before' "$(tail -1 direct)" "$(tail -1 out)"
{ keys 20; press $BACKQUOTE; line 'keep 1'; keys 3; } >script
last plays out --demo straight.demo
check 'in a playback nothing can be kept' reads 'unavailable while a demo plays'

# ---- the guide ----

sed -n '/^## Console/,/^## [^C]/s/^    //p' "$repo/docs/guide/17-developing.md" >session
{ keys 30; press $BACKQUOTE; sed -n 's/^> //p' session | while IFS= read -r text; do line "$text"; done
    keys 1; } >script
mapfile -t want < <(cut -c1-50 session)
last ./player play "$repo/examples/sandbox" --stage try --seed 0 >out 2>err
check 'the console prints what the guide shows' reads "${want[@]}" 'the run is marked as "touched"'
finish

#!/usr/bin/env bash
# menus.sh - the program's menus in play: what opens and closes them, that the board stands meanwhile and nothing of
# them is recorded, that settings take effect at once and are saved, and what is reported where they cannot be. The
# port is a script's (port_keys.c): no window, no clock.
. "$(dirname "$0")/../scripted.sh"
export KEYS_WHOLE=1

game g <<'LUA'
bullet.def("dot", { sprite = "dot", hit = { circle = 3 } })
local seen = 0
task.go(function()
  for i = 1, forever do
    seen = (seen * 31 + i + (pad.down "fire" and 7 or 0) + (pad.down "up" and 5 or 0) + rng.int(0, 99)) % 100000007
    if i % 7 == 1 then bullet.fire { kind = "dot", x = 40 + seen % 100, y = 60, dir = 90, speed = .5 } end
    wait(1)
  end
end)
LUA
cp -r g asks
cat >asks/main.lua <<'LUA'
player.def("ship", { sprite = "dot", hit = { circle = 2 } })
stage.def("one", function() wait(forever) end)
boot.run { stages = { "one" }, players = { "ship" } }
LUA
screen_of g 240x320
screen_of asks 240x320

A=4 F7=64 CTRL=224 Q=20 M=16 GUIDE=4000
conf=data/curtain/curtain.conf
times() { # N KEY
    for _ in $(seq "$1"); do press "$2"; done
}
play() { # GAME ARGUMENT...: standard input are the keys; the pictures are in menu, the recording is menu.demo
    ./player play "$1" --seed 5 --record menu.demo "${@:2}" >menu 2>err
}
frames() { "$curtain" verify "${1:-g}" menu.demo | sed -n 's/.*, \([0-9]*\) frames.*/\1/p'; } # [GAME]

# Prints a setting's page and its row there, both from 0. A page starts with one of the settings in `first`.
place() { # NAME
    "$curtain" help play | sed -n '/^Settings:/,$p' | sed 1d | awk -v name="$1" -v first=' scale volume dim away ' '
        index(first, " " $1 " ") { page++; row = 0 }
        $1 == name { print page - 1, row }
        $1 !~ /2$/ { row++ }'
}
to_setting() { # NAME: from the game to the row of the setting
    local page row
    read -r page row < <(place "$1")
    press $ESCAPE $DOWN $ENTER
    times "$page" $DOWN
    press $ENTER
    times "$row" $DOWN
}

# ---- the board stands ----

keys 100 | plays straight --seed 5 --record straight.demo

{ keys 40; press $ESCAPE $DOWN $DOWN $UP; keys 31; keys 1 $ESCAPE; keys 60; } | play g
check 'Escape, and Escape again: nothing of it is recorded' cmp straight.demo menu.demo
same 'before it nothing differs' "$(part straight 1 40)" "$(part menu 1 40)"
same 'while it is open no picture is of the game' '' \
    "$(comm -12 <(part straight 1 100 | sort) <(part menu 41 79 | sort))"
same 'afterwards nothing differs' "$(part straight 41 100)" "$(part menu 81 140)"
unchanged() { # NAME: with the keys of standard input the recording is the same
    play g
    check "$1" cmp straight.demo menu.demo
}
unchanged "a controller's guide button opens and closes it" < <(keys 40; keys 1 c1:$GUIDE; keys 20; keys 1 c1:$GUIDE
    keys 60)
unchanged 'F1 opens and closes the keys' < <(keys 40; keys 1 $F1; keys 20; keys 1 $F1; keys 60)
unchanged 'settings are opened and left' < <(to_setting music; press $ESCAPE $ESCAPE; keys 1 $ESCAPE; keys 100)
check 'settings without a change write no file' [ ! -e $conf ]
unchanged 'what is held when it closes is not for the game' < <(keys 40; keys 1 $ESCAPE; keys 9 $Z; keys 1 $Z $ESCAPE
    keys 60 $Z)
unchanged 'Resume comes first' < <(keys 40; keys 1 $ESCAPE $Z; keys 1 $Z; keys 1; keys 1 $Z; keys 60)
unchanged 'who loses the focus finds the menu' < <(keys 40; keys 30 f; keys 9; keys 1 $ESCAPE; keys 60)
unchanged 'a window that never had the focus runs' < <(keys 100 f)
settings 'away = go-on'
unchanged 'away = go-on: it runs' < <(keys 40; keys 30 f; keys 30)
rm $conf
{ keys 40; keys 30 f; keys 60; } | ./player play g --demo straight.demo >menu 2>err
same 'a playback stops' '131 1' "$(pictures menu) $(part menu 44 131 | sort -u | wc -l)"

shows() { # OUT KEY...: each pressed once, in a game that has stages; then for a while nothing
    local out=$1
    shift
    { keys 40; for key; do keys 1 "$key"; keys 20; done; } | ./player play asks --seed 5 >"$out" 2>err
}
for key in $F1 $F2; do
    shows at_once $key
    shows over_menu $ESCAPE $key
    same "key $key opens its screen over the menu" "$(tail -1 at_once)" "$(tail -1 over_menu)"
    shows closed $ESCAPE $key $key
    shows menu $ESCAPE $ESCAPE
    same "key $key closes both" "$(tail -1 menu)" "$(tail -1 closed)"
done

# ---- a run ----

# A run of two stages, which starts at once; in the second one the ship dies when SELECT is pressed.
cp -r g run
cat >run/main.lua <<'LUA'
bullet.def("dot", { sprite = "dot", hit = { circle = 9 } })
player.def("ship", { sprite = "dot", hit = { circle = 2 }, lives = 1, safe = 1 })
on.continue(function() print "continue" end)
stage.def("one", function() print "one" wait(20) end)
stage.def("two", function()
  print "two"
  wait_until(function() return pad.down "select" end)
  player.each(function(p) bullet.fire { kind = "dot", from = p, speed = 0 } end)
  wait(forever)
end)
boot.run { stages = { "one", "two" }, players = { "ship" }, continues = 1,
  pause = { { "Map", function() print "map" end }, { "Sonar", function() print "sonar" end } },
  screens = { title = function() print "title" wait(1) return "start" end, results = function() end,
    start = function() return { difficulty = "normal" } end } }
LUA
# Standard input are the keys. The choices of the run before are not there, as they would be in the demo.
run() {
    rm -f data/curtain/probe.nv
    play run --no-resume
}
log() { tr '\n' ' ' <err; }
entry() { press $ESCAPE; times "$1" $DOWN; press $ENTER; } # N: the entry after Resume
TAB=43 PAD_START=1000

keys 100 | run
same 'a run without a pause' 'title one two ' "$(log)"
mv menu.demo run.demo
paused() { # NAME: with the keys of standard input, in a run, the recording is the same
    run
    check "$1" cmp run.demo menu.demo
}
paused 'START and Escape pause a run' < <(keys 40; keys 1 $ENTER; keys 20; keys 1 $ESCAPE; keys 60)
paused 'and START again, held or not, resumes it' < <(keys 40; keys 9 $ENTER; keys 3; keys 20 $ENTER; keys 41)
paused "so does a controller's START" < <(keys 40; keys 1 c1:$PAD_START; keys 9; keys 1 c1:$PAD_START; keys 60)
paused 'a look into the settings is not recorded either' < <(keys 40; entry 5; press $ESCAPE; keys 1 $ESCAPE
    keys 60)
{ keys 40; entry 2; keys 30; entry 1; keys 30; } | run
same "the game's own entries" 'title one two sonar map ' "$(log)"
check 'are in the demo' "$curtain" verify run menu.demo
{ keys 40; entry 4; keys 60; } | run
same 'Restart' 'title one two one two ' "$(log)"
check 'is in the demo' "$curtain" verify run menu.demo
{ keys 40; entry 3; keys 60; } | run
same 'Restart Stage: back to its start, and the demo says so' 'title one two 1' "$(log)$(flags menu.demo)"
{ keys 10; entry 3; keys 60; } | run
same 'in the first stage there is only Restart' 'title one one two ' "$(log)"
{ keys 40; press $ESCAPE $UP $UP $ENTER $DOWN $ENTER; keys 60; } | run
same 'Quit to Title' 'title one two title one two ' "$(log)"
read -r page row < <(place large_hud)
to_large() { entry 5; times "$page" $DOWN; press $ENTER; times "$row" $DOWN; press $RIGHT; }
{ keys 40; to_large; press $ESCAPE $ESCAPE; keys 30; } | run
same 'Larger HUD: saved, and asks for a restart' 'title one two 0' "$(log)$("$curtain" verify -v run menu.demo |
    grep -c 'larger HUD')"
check 'it is in the settings' grep -qx 'large_hud = yes' $conf
keys 60 | run
check 'the next run has it in its demo' grep -q 'larger HUD' <("$curtain" verify -v run menu.demo)
rm $conf
check 'is in the demo too' "$curtain" verify run menu.demo
{ keys 40; keys 2 $TAB; keys 60; keys 1 $ENTER; keys 60; } | run
same 'when the ship is out, START is for the game' 'title one two continue ' "$(log)"
{ keys 40; keys 2 $TAB; keys 60; entry 4; keys 60; } | run
same 'and Escape opens the menu' 'title one two one two ' "$(log)"

# ---- leaving ----

rm data/curtain/probe.nv
unchanged 'Quit asks, and No comes first' < <(keys 40; press $ESCAPE $UP $ENTER; keys 1 $ENTER; keys 1 $ESCAPE; keys 60)
leaves() { # NAME: with the keys of standard input the program ends after frame 40
    play g
    same "$1" '0 40' "$? $(frames)"
}
leaves 'Yes leaves' < <(keys 40; press $ESCAPE $UP $ENTER $DOWN; keys 60 $ENTER)
leaves 'ctrl+q leaves without a question' < <(keys 40; keys 60 $CTRL $Q)
{ keys 40; press $ESCAPE $UP $UP $ENTER $DOWN; keys 1 $ENTER; keys 60; } | play g
same 'Restart: the first frames again' "$(part straight 1 40)" "$(tail -n 61 menu | head -n 40)"

# ---- sounds ----

cp -r g heard
sed -i 's/^return {/&\n  sounds = { tick = { mml = "t120 @pulse o5 c4" } }, theme = { sounds = { WHICH = "tick" } },/' \
    heard/rom.lua
hears() { # INPUT KEY...: is there sound, with these keys, in a game in which only this input sounds?
    sed "s/WHICH/$1/" heard/rom.lua >one.lua && cp -r heard one && mv one.lua one/rom.lua
    { keys 40; press "${@:2}"; keys 30; } |
        KEYS_SOUND=heard.raw ./player play one --seed 5 --record one.demo >menu 2>err
    rm -r one
    touch heard.raw
    LC_ALL=C tr -d '\000' <heard.raw | head -c 1 | wc -c
    rm heard.raw
}
mute() { mkdir -p data/curtain && echo 'mute = yes' >$conf; }
same 'opening a screen sounds' '1 0' "$(hears open $ESCAPE) $(hears open $Z $DOWN)"
same 'moving sounds' '1 0' "$(hears move $ESCAPE $DOWN) $(hears move $ESCAPE $ENTER)"
same 'accepting sounds, also over the game' '1 0' "$(hears accept $ESCAPE $ENTER) $(hears accept $ESCAPE $ESCAPE)"
same 'going back sounds, also over the game' '1 0' "$(hears back $ESCAPE $ESCAPE) $(hears back $ESCAPE $DOWN)"
mute
same 'nothing sounds when muted' 0 "$(hears move $ESCAPE $DOWN)"
rm $conf

# ---- settings ----

printf '# mine\r\n\n volume=40   # low\nmusic = 10\nmusic = 20 # this one' >$conf
{ to_setting volume; press $RIGHT $RIGHT $LEFT $RIGHT; press $ESCAPE $ESCAPE $ESCAPE; to_setting music
    press $LEFT $ESCAPE $ESCAPE $ESCAPE; } | play g
same 'volume and music: two lines are others, and the rest as it was' \
    "$(printf '# mine\r\n\n volume= 60   # low\nmusic = 10\nmusic = 10 # this one')" "$(cat $conf)"
rm $conf
{ press $M; to_setting volume; press $LEFT $ESCAPE $ESCAPE $ESCAPE; } | play g --scale 3 --fullscreen
same 'what a key or an option changed for now is not saved' 'volume = 90' "$(cat $conf)"
rm $conf
{ to_setting speed; times 10 $LEFT; press $ESCAPE $ESCAPE; keys 1 $ESCAPE; keys 100; } | play g
same 'half the speed, at once, and the demo says so' '50 4' "$(frames) $(flags menu.demo)"
same 'and it is saved' 'speed = 50' "$(cat $conf)"
keys 100 | play g
same 'for the next time' '50 4' "$(frames) $(flags menu.demo)"
same 'other runs have no mark' 0 "$(flags straight.demo)"
rm $conf

# ---- a key by pressing it ----

{ keys 50; keys 20 $UP; keys 30; } | plays up --seed 5 --record up.demo
{ keys 30; press $F1 76 76; keys 1 $ESCAPE; keys 9; } | play g
check 'Delete removes the keys of the row, and no buttons that it does not show' \
    grep -qx 'p1.up = pad.up pad.lup' $conf
rm -f $conf
{ keys 30; press $F1 $ENTER $F7; keys 1 $ESCAPE; keys 20; keys 20 $F7; keys 30; } | play g
check 'another key is the same button at once' cmp up.demo menu.demo
same 'and is saved' 'p1.up = up pad.up pad.lup f7' "$(cat $conf)"
rm $conf

# ---- where settings cannot be saved ----

unsaved() { # WHY: reported when it happens, and at exit
    local file=$XDG_DATA_HOME/curtain/curtain.conf
    printf 'curtain: %s\ncurtain: not saved: %s' "$file$1" "$file$1"
}
change_while() { # COMMAND...: is run between a change of volume and the end of the settings
    : >menu
    { to_setting volume; press $LEFT; } >first
    { cat first; wait_for menu "$(pictures first)"; "$@" >&2; press $ESCAPE $ESCAPE; keys 1 $ESCAPE; keys 80; } | play g
}
change_while settings 'volum = 3'
same 'a file that has become wrong is reported' "$(unsaved ':1: unknown setting "volum"')" "$(cat err)"
same 'and stays, and the game goes on' 'volum = 3 80' "$(cat $conf) $(frames)"
keys 9 | play g
same 'the next start refuses it' \
    "2 curtain: $XDG_DATA_HOME/curtain/curtain.conf:1: unknown setting \"volum\"" "$? $(cat err)"
rm -r data

# ---- a game asks ----

unset KEYS_WHOLE
# From its title: START opens the menu, which ends with SETTINGS, HOW TO PLAY and QUIT.
{ keys 40; press $ENTER; keys 10; press $UP $UP $UP; keys 1 $Z; keys 1; } >ask
{ cat ask; press $ENTER $RIGHT; keys 60; press $ESCAPE; keys 1 $ESCAPE; keys 100; } | play asks
check 'settings, which a game asked for' grep -qx 'scale = 1' $conf
same 'while they are open the game stands' "$(($(pictures ask) - 1 + 100))" "$(frames asks)"
last=$(tail -n 1 menu)
keys 170 | ./player play asks --demo menu.demo >back 2>err
same 'a playback opens nothing' "$last" \
    "$(part back "$(($(pictures ask) - 1 + 100))" "$(($(pictures ask) + 99))")"
# The tick that asked is gone back over and stepped through: it asks nothing again.
{ cat ask; press $RIGHT; keys 1 $ESCAPE; keys 5; times 12 $B; times 12 $DOT; press $P; keys 100; } | play asks
check 'stepping through what asked opens nothing' [ "$(frames asks)" -gt "$(($(pictures ask) + 90))" ]

# ---- on the game's pages ----

presses() { python3 "$repo/tests/cli/demo_read.py" menu.demo | grep -c "^pads [0-9]* $1 0000"; } # PAD, in hexadecimal
{ keys 40; press $ENTER; keys 10; press $UP $UP; press $Z; keys 40; press $ESCAPE; keys 40; } | play asks
same 'Escape on a page presses its button to go back' 1 "$(presses 0020)"
{ keys 40; press $ESCAPE; keys 5; press $ESCAPE; keys 40; } | play asks
same '... but opens the menu at the title' 0 "$(presses 0020)"
over() { { keys 40; press "$@"; keys 9; } | ./player play g --seed 5 2>err | tail -n 1; } # KEY...: the last picture
same 'from practice, Back leads to the menu that opened it' "$(over $ESCAPE $DOWN $DOWN)" \
    "$(over $ESCAPE $DOWN $DOWN $ENTER $ESCAPE)"
cat >asks/main.lua <<'LUA'
player.def("ship", { sprite = "dot", hit = { circle = 2 }, lives = 1 })
bullet.def("dot", { sprite = "dot", hit = { circle = 3 } })
stage.def("one", function()
  player.each(function(p) score.add(5000, p) end)
  while true do
    player.each(function(p) bullet.fire { kind = "dot", x = p.x, y = p.y, dir = 90, speed = 0 } end)
    wait(1)
  end
end)
boot.run { stages = { "one" }, players = { "ship" } }
LUA
{ keys 40; press $ENTER; keys 10; press $Z; keys 20; keys 900 $Z "'Z"; keys 5; keys 1 $A "'A"; keys 9; } | play asks
same 'a key that is held when name entry begins types nothing' '0 1' "$(presses 9800) $(presses 3400)"
finish

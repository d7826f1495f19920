#!/usr/bin/env bash
# menus.sh - the program's menus in play: what opens and closes them, that the board stands meanwhile and nothing of
# them is recorded, that settings do what they say at once and are kept, and what is said where they cannot be kept. The
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
sed -i 's/screen = { w = 64, h = 64/screen = { w = 240, h = 320/' g/rom.lua asks/rom.lua

UP=82 DOWN=81 RIGHT=79 LEFT=80 ENTER=40 ESCAPE=41 F1=58 F2=59 F7=64 F8=65 CTRL=224 Q=20 M=16 GUIDE=4000
conf=data/curtain/curtain.conf
times() { # N KEY: so often
    for _ in $(seq "$1"); do press "$2"; done
}
plays() { # GAME OUT ARGUMENT...: standard input are the keys; the recording is OUT.demo
    local game=$1 out=$2
    shift 2
    ./player play "$game" --seed 5 --record "$out.demo" "$@" >"$out" 2>err
}
watches() { # GAME OUT DEMO
    ./player play "$1" --demo "$3" >"$2" 2>err
}
frames() { "$curtain" verify "${2:-g}" "$1" | sed -n 's/.*, \([0-9]*\) frames.*/\1/p'; } # DEMO [GAME]
shots() { wc -l <"$1"; } # OUT: pictures shown

# Where a setting stands among the settings: presses of Down from the first one.
place() { "$curtain" help play | sed -n '/^Settings:/,$p' | sed 1d | awk -v name="$1" '$1 == name { print NR - 1 }'; }
MENU_SETTINGS=1 # presses of Down in the menu
to_setting() { # NAME: from the game on
    press $ESCAPE
    times $MENU_SETTINGS $DOWN
    press $ENTER
    times "$(place "$1")" $DOWN
}
same 'settings are where help has them' '0 1' "$(place scale) $(place fullscreen)"

# ---- the board stands ----

keys 100 | plays g straight

{ keys 40; press $ESCAPE $DOWN $DOWN $UP; keys 31; keys 1 $ESCAPE; keys 60; } | plays g menu
check 'Escape, and Escape again: nothing of it is recorded' cmp straight.demo menu.demo
same 'before it nothing differs' "$(part straight 1 40)" "$(part menu 1 40)"
same 'while it is open no picture is of the game' '' \
    "$(comm -12 <(part straight 1 100 | sort) <(part menu 41 79 | sort))"
same 'afterwards nothing differs' "$(part straight 41 100)" "$(part menu 81 140)"

{ keys 40; keys 1 c1:$GUIDE; keys 20; keys 1 c1:$GUIDE; keys 60; } | plays g menu
check "a controller's guide button opens and closes it" cmp straight.demo menu.demo
{ keys 40; keys 1 $F1; keys 20; keys 1 $F1; keys 60; } | plays g menu
check 'F1 opens the keys, and closes them' cmp straight.demo menu.demo
check 'while they are open no picture is of the game' files_differ <(part straight 41 60) <(part menu 41 60)
{ keys 40; press $F1; times 30 $DOWN; keys 1 $ESCAPE; keys 60; } | plays g menu
check 'Escape closes them' cmp straight.demo menu.demo
shows() { # OUT KEY...: each pressed once, in a game that has stages; then for a while nothing
    local out=$1
    shift
    { keys 40; for key; do keys 1 "$key"; keys 20; done; } | ./player play asks --seed 5 >"$out" 2>err
}
for key in $F1 $F2; do
    shows at_once $key
    for from in $ESCAPE $F1 $F2 $F8; do
        shows menu $from $key
        [ $from = $key ] ||
            same "key $key opens its screen from that of key $from" "$(tail -1 at_once)" "$(tail -1 menu)"
    done
    shows closed $ESCAPE $key $key
    shows menu $ESCAPE $ESCAPE
    check "key $key closes it again" cmp <(tail -1 closed) <(tail -1 menu)
done
{ to_setting music; press $ESCAPE; keys 1 $ESCAPE; keys 100; } | plays g menu
check 'settings are opened and left' cmp straight.demo menu.demo
check 'settings that are as they were write no file' [ ! -e $conf ]
{ keys 40; keys 1 $ESCAPE; keys 9 $Z; keys 1 $Z $ESCAPE; keys 60 $Z; } | plays g menu
check 'what is held when it closes is not for the game' cmp straight.demo menu.demo
{ keys 40; keys 1 $ESCAPE $Z; keys 1 $Z; keys 1; keys 1 $Z; keys 60; } | plays g menu
check 'go on comes first' cmp straight.demo menu.demo

# ---- another window ----

{ keys 40; keys 30 f; keys 9; keys 1 $ESCAPE; keys 60; } | plays g menu
check 'who goes away finds the menu' cmp straight.demo menu.demo
keys 100 f | plays g menu
check 'where nobody ever has the keys it runs' cmp straight.demo menu.demo
mkdir -p data/curtain
echo 'away = go-on' >$conf
{ keys 40; keys 30 f; keys 30; } | plays g menu
check 'away = go-on: it runs' cmp straight.demo menu.demo
rm $conf
{ keys 40; keys 30 f; keys 60; } | watches g menu straight.demo
same 'a playback stops' '131 1' "$(shots menu) $(part menu 44 131 | sort -u | wc -l)"

# ---- leaving ----

{ keys 40; press $ESCAPE $UP $ENTER; keys 1 $ENTER; keys 1 $ESCAPE; keys 60; } | plays g menu
check 'leave asks, and no comes first' cmp straight.demo menu.demo
{ keys 40; press $ESCAPE $UP $ENTER $DOWN; keys 60 $ENTER; } | plays g menu
same 'yes leaves' '0 40' "$? $(frames menu.demo)"
check 'at once' [ "$(shots menu)" -lt 52 ]
{ keys 40; keys 60 $CTRL $Q; } | plays g menu
same 'ctrl+q leaves unasked' '0 40' "$? $(frames menu.demo)"
{ keys 40; press $ESCAPE; keys 60 $CTRL $Q; } | plays g menu
same 'over a menu too' '0 40' "$? $(frames menu.demo)"
{ keys 40; press $ESCAPE; } | plays g menu
same 'and so does the window that is closed' '0 40' "$? $(frames menu.demo)"
{ keys 40; press $ESCAPE $UP $UP $ENTER $DOWN; keys 1 $ENTER; keys 60; } | plays g menu
same 'begin anew: the first frames once more' "$(part straight 1 40)" "$(tail -n 61 menu | head -n 40)"

# ---- settings ----

printf '# mine\r\n\n volume=40   # low\nmusic = 10\nmusic = 20 # this one\np1.fire = z # only' >$conf
{ to_setting volume; press $RIGHT $RIGHT $LEFT $RIGHT; press $ESCAPE $ESCAPE; to_setting music; press $LEFT
    press $ESCAPE $ESCAPE; } | plays g menu
same 'volume and music: two lines are others, and the rest as it was' \
    "$(printf '# mine\r\n\n volume= 60   # low\nmusic = 10\nmusic = 10 # this one\np1.fire = z # only')" "$(cat $conf)"
{ to_setting away; press $RIGHT $ESCAPE $ESCAPE; } | plays g menu
same 'what is not there yet comes at the end' 'p1.fire = z # only|away = go-on|' "$(tail -n 2 $conf | tr '\n' '|')"
rm $conf
{ press $M; to_setting volume; press $LEFT $ESCAPE $ESCAPE; } | plays g menu --scale 3 --fullscreen
same 'what a key or an option did for now is not kept' 'volume = 90' "$(cat $conf)"
rm $conf

{ to_setting speed; press $RIGHT $ESCAPE; keys 1 $ESCAPE; keys 100; } | plays g menu
same 'half the speed, at once, and the demo says so' '50 4' "$(frames menu.demo) $(flags menu.demo)"
same '... and it is kept' 'speed = half' "$(cat $conf)"
keys 100 | plays g menu
same '... for the next time' '50 4' "$(frames menu.demo) $(flags menu.demo)"
check 'which is the same run' "$curtain" verify g menu.demo
rm $conf
same 'nothing else is marked' 0 "$(flags straight.demo)"
for setting in scale fullscreen turn scaling crt border panels vsync run_ahead dim flashes colours hitbox music \
    sounds; do
    way=$RIGHT
    case $setting in music | sounds) way=$LEFT ;; esac
    { keys 20; to_setting $setting; press "$way" $ESCAPE; keys 1 $ESCAPE; keys 80; } | plays g menu
    check "$setting changes no run" cmp straight.demo menu.demo
    check "$setting is kept" grep -q "^$setting = " $conf
    rm -f $conf
done
{ to_setting fullscreen; press $RIGHT $ESCAPE $ESCAPE; to_setting fullscreen; press $RIGHT $ESCAPE $ESCAPE; } |
    plays g menu
same 'there and back' 'fullscreen = no' "$(cat $conf)"
rm $conf

# ---- a key by pressing it ----

{ keys 50; keys 20 $UP; keys 30; } | plays g up
{ keys 30; press $F1 $ENTER $F7; keys 1 $ESCAPE; keys 20; keys 20 $F7; keys 30; } | plays g menu
check 'another key is the same button at once' cmp up.demo menu.demo
same 'and is kept' 'p1.up = up pad.up pad.lup f7' "$(cat $conf)"
{ keys 50; keys 20 $F7; keys 30; } | plays g menu
check 'for the next time' cmp up.demo menu.demo
rm $conf

# ---- where they cannot be kept ----

# Until so many pictures are shown.
unsaved() { # WHY: said when it happens, and at exit
    printf 'curtain: %s\ncurtain: not saved: %s' "$XDG_DATA_HOME/curtain/curtain.conf$1" \
        "$XDG_DATA_HOME/curtain/curtain.conf$1"
}
shown() { until [ -f "$1" ] && [ "$(shots "$1")" -ge "$2" ]; do sleep 0.02; done; }
change_while() { # COMMAND...: plays, and runs it between a change of volume and the end of the settings
    rm -f menu
    { to_setting volume; press $LEFT; } >first
    { cat first; shown menu "$(wc -l <first)"; "$@" >&2; press $ESCAPE; keys 1 $ESCAPE; keys 80; } |
        plays g menu
}
breaks() { echo 'volum = 3' >$conf; }
change_while breaks
same 'a file that is not right by now stays, and is said' \
    "$(unsaved ':1: unknown setting "volum"')" "$(cat err)"
same '... as it is' 'volum = 3' "$(cat $conf)"
same '... and the game goes on' 80 "$(frames menu.demo)"
keys 9 | plays g menu
same 'at the next start it is refused' \
    "2 curtain: $XDG_DATA_HOME/curtain/curtain.conf:1: unknown setting \"volum\"" "$? $(cat err)"
rm -r data
blocks() { rm -rf data/curtain && echo 'a file' >data/curtain; }
mkdir data
change_while blocks
same 'a folder that is none' \
    "$(unsaved ': cannot be written (Not a directory)')" "$(cat err)"
rm -r data
mkdir data
if small_disk data/curtain size=64k; then
    echo 'volume = 40 # mine' >$conf
    dd if=/dev/zero of=data/curtain/filler bs=1k >/dev/null 2>&1
    change_while true
    same 'a full disk is said, and at exit' \
        "$(unsaved ': cannot be written (No space left on device)')" "$(cat err)"
    same '... and the old file is whole' 'volume = 40 # mine|curtain.conf filler' \
        "$(cat $conf)|$(cd data/curtain && echo *)"
    umount data/curtain
fi
rm -r data

# ---- a game asks ----

unset KEYS_WHOLE
# From its title: START opens the list, whose last entry is SETTINGS.
{ keys 40; press $ENTER; keys 10; press $UP; keys 1 $Z; keys 1; } >ask
{ cat ask; keys 100; } | plays asks straight
{ cat ask; press $RIGHT; keys 60; keys 1 $ESCAPE; keys 100; } | plays asks menu
check 'settings, which a game asked for' grep -qx 'scale = 1' $conf
same 'while they are open the game stands' "$(($(wc -l <ask) - 1 + 100))" \
    "$(frames menu.demo asks)"

# The tick that asked is gone back over and stepped through: it asks nothing again.
B=5 P=19 DOT=55
{ cat ask; press $RIGHT; keys 1 $ESCAPE; keys 5; times 12 $B; times 12 $DOT; press $P; keys 100; } | plays asks stepped
check 'stepping through what asked opens nothing' \
    [ "$(frames stepped.demo asks)" -gt "$(($(wc -l <ask) + 90))" ]
keys 170 | watches asks back menu.demo
same 'a playback opens nothing' "$(tail -n 1 menu)" \
    "$(part back "$(($(wc -l <ask) - 1 + 100))" "$(($(wc -l <ask) + 99))")"
finish

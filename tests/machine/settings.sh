#!/usr/bin/env bash
# settings.sh - how a run is shown changes nothing of it: under every setting of the window the same keys make the same
# demo and the same scores, byte for byte, while the pictures are others. And what is shown where: turned pictures and
# where the mouse is on them, panels beside the picture, and messages that leave its top alone. The port is a script's
# (port_keys.c), with a window of its own.
. "$(dirname "$0")/../scripted.sh"

game g <<'LUA'
local x, dot = 0, sprite.put { sprite = 'dot', x = 0, y = 0 }
task.go(function()
  for i = 1, forever do
    x = x + 1 + (pad.down 'fire' and rng.int(1, 5) or 0)
    dot.x, dot.y = x % 200, 3 + i % 30
    if i % 50 == 0 then save.set('x', x) end
    wait(1)
  end
end)
LUA
sed -i 's/screen = { w = 64, h = 64/screen = { w = 240, h = 320/' g/rom.lua
convert -size 400x440 'gradient:#802020-#204080' -alpha set \( -size 240x320 xc:white \) -geometry +80+60 \
    -compose DstOut -composite g/art/border.png || exit 2
sed -i 's|^  board =|  border = "art/border.png",\n&|' g/rom.lua

H=11 G=10
press() { keys 20; keys 40 $Z; keys 3; keys 20 $Z; keys 30; keys 1 $P; keys 3; keys 1 $P; keys 60; }
plays() { # NAME SETTINGS: standard input are the keys
    rm -rf data
    mkdir -p data/curtain
    printf '%b' "$2" >data/curtain/curtain.conf
    ./player play g --seed 5 --record "$1.demo" >"$1" 2>"$1.err" || { cat "$1.err"; return 1; }
    cp data/curtain/probe.nv "$1.nv"
}
press >script
plays plain '' <script || exit 2
check 'the run is not empty' "$curtain" verify g plain.demo

same_run() { # NAME SETTINGS
    plays "$1" "$2" <script && cmp plain.demo "$1.demo" && cmp plain.nv "$1.nv"
}
KEYS_WINDOW=1201x733
n=0
while IFS= read -r settings; do
    n=$((n + 1))
    for window in '' 1201x733; do
        unset KEYS_WINDOW
        [ -z "$window" ] || export KEYS_WINDOW=$window
        check "the same demo and scores with $settings in a window of ${window:-the picture alone}" \
            same_run "other$n" "${settings//; /\\n}\n"
        case $window/$settings in
        */turn* | */run_ahead* | 1201x733/*) check "and other pictures" files_differ plain "other$n" ;;
        esac
    done
done <<'END'
turn = left
turn = right; scaling = smooth
turn = over; crt = yes
scaling = smooth
crt = yes
border = yes
panels = beside
run_ahead = 1
run_ahead = 1; turn = left; scaling = smooth; crt = yes; panels = beside
END
unset KEYS_WINDOW

# Pause, steps, slow motion, as fast as it goes, back in time, the console, the practice menu: all of it beside a look
# ahead.
COMMA=54 SLASH=56 BACKQUOTE=53 F2=59 ESCAPE=41 F12=69
{
    keys 60 $Z; keys 1 $P; keys 2; keys 1 $DOT; keys 2; keys 1 $DOT $Z; keys 2; keys 1 $P; keys 5 $Z
    keys 12 $BACKSPACE; keys 9 $Z; keys 1 $B; keys 2; keys 1 $P; keys 6; keys 1 $COMMA; keys 9 $Z; keys 1 $COMMA; keys 4
    keys 1 $COMMA; keys 3 $SLASH; keys 5 $Z; keys 1 $BACKQUOTE; keys 3; keys 1 $ESCAPE; keys 5; keys 1 $F2; keys 4
    keys 1 $F2; keys 8 $Z; keys 1 $F12; keys 12
} >script
shot=$XDG_PICTURES_DIR/Curtain/probe-1.png
plays way '' <script
mv "$shot" way.png
check 'the way through all of it' "$curtain" verify g way.demo
for settings in 'run_ahead = 1' 'run_ahead = 1; turn = right; panels = beside'; do
    rm -f "$shot"
    plays ahead "${settings//; /\\n}\n" <script
    check "it is the same with $settings" cmp way.demo ahead.demo
    check 'and so are scores' cmp way.nv ahead.nv
    check 'and the screenshot' cmp way.png "$shot"
done
press >script

# A screen that is waited for: as many ticks in as much time, so as many frames of the same keys.
for hz in 60 75 144; do
    export KEYS_VSYNC=$hz KEYS_WINDOW=240x320
    check "the demo holds that was played on a screen of $hz Hz" plays "vsync$hz" 'vsync = yes\nborder = no\n' <script
    check 'and it does' "$curtain" verify g "vsync$hz.demo"
done
unset KEYS_VSYNC KEYS_WINDOW

# ---- pictures ----

picture() { # N SETTINGS [OPTION...]: picture.ppm of picture N, keys as on standard input
    local picture=$1 settings=$2
    shift 2
    rm -rf data
    mkdir -p data/curtain
    printf '%b' "$settings" >data/curtain/curtain.conf
    [ $# -gt 0 ] || set -- --seed 5
    rm -f picture.ppm
    KEYS_PPM=$picture ./player play g "$@" >out 2>err
}
says() { python3 "$repo/tests/machine/words.py" "$@"; }

{ keys 30; keys 1 $P; keys 5; } >paused
picture 34 '' <paused
cp picture.ppm upright.ppm
check 'a message is read' says upright.ppm 'Paused at frame 30'
top() { convert "$1" -crop 240x300+0+0 +repage -depth 8 "rgb:$2"; }
top upright.ppm upright.rgb
keys 40 | picture 30 ''
top picture.ppm straight.rgb
check 'which leaves the upper 300 rows alone' cmp straight.rgb upright.rgb
for turn in left:90 right:-90 over:180; do
    picture 34 "turn = ${turn%:*}\n" <paused
    convert picture.ppm -rotate "${turn#*:}" back.ppm
    convert upright.ppm -depth 8 rgb:a
    convert back.ppm -depth 8 rgb:b
    check "turned ${turn%:*} it is the same picture" cmp a b
done

# The mouse on the bar of time: a quarter from the left, 4 px above the bottom; turned left that is elsewhere.
play_demo() { # SETTINGS X,Y
    { keys 20; keys 1 $P; keys 2; keys 1 "@$2"; keys 12; } >script
    picture 30 "$1" --demo plain.demo <script
}
play_demo '' 60,316
cp picture.ppm upright.ppm
check 'a click on the bar of time goes there' says upright.ppm 'Paused at frame'
play_demo 'turn = left\n' 316,179
convert picture.ppm -rotate 90 -depth 8 rgb:b
convert upright.ppm -depth 8 rgb:a
check 'turned left it is where it is seen' cmp a b
play_demo 'turn = right\n' 3,60
convert picture.ppm -rotate -90 -depth 8 rgb:b
check 'turned right too' cmp a b

# In a wide window panels and messages stand beside the picture, and it is as it would be without them.
export KEYS_WINDOW=1200x700
{ keys 30; keys 1 $G; keys 1 $P; keys 5; } >script
picture 36 'panels = beside\nborder = no\n' <script
convert picture.ppm -crop 480x640+360+30 +repage -depth 8 rgb:a
convert picture.ppm -crop 360x700+840+0 +repage -scale 50% side.ppm
check 'gauges and messages stand beside it' says side.ppm 'Paused at frame 31' 'part          live   top   cap refused'
keys 40 | picture 31 'panels = beside\nborder = no\n'
convert picture.ppm -crop 480x640+360+30 +repage -depth 8 rgb:b
check 'and the picture is bare' cmp a b
convert picture.ppm -crop 360x700+840+0 +repage -depth 8 rgb:a
head -c 756000 /dev/zero >b
check 'where nothing is to be said nothing stands' cmp a b
export KEYS_WINDOW=700x700
picture 36 'panels = beside\nborder = no\n' <script
convert picture.ppm -crop 480x640+110+30 +repage -scale 50% middle.ppm
check 'in a narrow one they are over it' says picture.ppm 'Paused at frame 31'
unset KEYS_WINDOW

# The border: its colours in the corners, the picture as it is.
export KEYS_WINDOW=700x700
keys 40 | picture 31 'border = yes\n'
pixel() { convert picture.ppm -format "%[hex:u.p{$1,$2}]" info: | cut -c1-6; }
check 'the border is there' test "$(pixel 5 5)" != 000000
convert picture.ppm -crop 480x640+110+30 +repage -scale 50% -depth 8 rgb:a
unset KEYS_WINDOW
keys 40 | picture 31 'border = no\n'
convert picture.ppm -depth 8 rgb:b
check 'and the picture in it' cmp a b

# ---- what is wrong ----

"$curtain" check g >found
same 'the border is a picture that is used' '' "$(grep border found)"
sed -i '/border =/d' g/rom.lua
"$curtain" check g >found
check 'and is not when nobody names it' grep -q '^art/border.png: not listed in rom.lua' found
sed -i 's|^  board =|  border = "art/border.png",\n&|' g/rom.lua

cp -R g wrong
bad() { # FILE: packs with that as its border
    cp "$1" wrong/art/border.png
    "$curtain" pack wrong -o bad.rom
}
convert -size 40x40 xc:red full.png
refuse 'a border without a hole is refused' 'art/border.png: the border has no hole' bad full.png
echo 'no picture' >text.png
refuse 'so is one that is no picture' 'art/border.png: ' bad text.png
same 'a setting that is none is reported' \
    'turn: expected none, left, right or over, got "up"' \
    "$(mkdir -p data/curtain; echo 'turn = up' >data/curtain/curtain.conf; ./player play g </dev/null 2>&1 |
        grep -o 'turn: .*')"
finish

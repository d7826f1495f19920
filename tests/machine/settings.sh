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
screen_of g 240x320
convert -size 400x440 'gradient:#802020-#204080' -alpha set \( -size 240x320 xc:white \) -geometry +80+60 \
    -compose DstOut -composite g/art/border.png || exit 2
sed -i 's|^  board =|  border = "art/border.png",\n&|' g/rom.lua

# play NAME SETTINGS: with these settings, separated by "; ", and the keys of the file script
play() {
    rm -rf data
    settings "${2//; /$'\n'}"
    plays "$1" --seed 5 --record "$1.demo" <script || { cat err; return 1; }
    cp data/curtain/probe.nv "$1.nv"
}
same_run() { # NAME SETTINGS: as `plain`
    play "$1" "$2" && cmp plain.demo "$1.demo" && cmp plain.nv "$1.nv"
}
# Pause, steps, slow motion, as fast as it goes, back in time, the console, the practice menu, a screenshot.
{
    keys 60 $Z; keys 1 $P; keys 2; keys 1 $DOT; keys 2; keys 1 $DOT $Z; keys 2; keys 1 $P; keys 5 $Z
    keys 12 $BACKSPACE; keys 9 $Z; keys 1 $B; keys 2; keys 1 $P; keys 6; keys 1 $COMMA; keys 9 $Z; keys 1 $COMMA; keys 4
    keys 1 $COMMA; keys 3 $SLASH; keys 5 $Z; keys 1 $BACKQUOTE; keys 3; keys 1 $ESCAPE; keys 5; keys 1 $F2; keys 4
    keys 1 $F2; keys 8 $Z; keys 1 $F12; keys 12
} >script
shot=$XDG_PICTURES_DIR/Curtain/probe-1.png
play plain '' || exit 2
mv "$shot" plain.png
check 'the demo holds' "$curtain" verify g plain.demo
while IFS= read -r settings; do
    for window in '' 1201x733; do
        rm -f "$shot"
        KEYS_WINDOW=$window check "the same demo and scores with $settings ${window:+in a window of $window}" \
            same_run other "$settings"
        check 'and the same screenshot' cmp "$shot" plain.png
    done
    check 'and other pictures' files_differ plain other
done <<'END'
turn = left; scaling = smooth; crt = yes
turn = right; border = yes
turn = over; panels = beside
run_ahead = 1
run_ahead = 1; turn = left; panels = beside
END

# A screen that is waited for: as many ticks in as much time, so as many frames of the same keys.
for hz in 75 144; do
    KEYS_VSYNC=$hz KEYS_WINDOW=240x320 check "played on a screen of $hz Hz" play "vsync$hz" 'vsync = yes; border = no'
    check 'the demo holds' "$curtain" verify g "vsync$hz.demo"
done

# ---- pictures ----

picture() { # N SETTINGS [OPTION...]: picture.ppm is picture N of the keys of standard input
    rm -rf data
    settings "$2"
    KEYS_PPM=$1 plays out "${@:3}"
}
pixels() { convert "$@" +repage -depth 8 rgb:-; } # ARGUMENT...: of ImageMagick
same_pixels() { # NAME FILE ARGUMENT...: picture.ppm, changed so, is FILE
    check "$1" cmp <(pixels picture.ppm "${@:3}") <(pixels "$2")
}

{ keys 30; keys 1 $P; keys 5; } >paused
picture 34 '' <paused
cp picture.ppm upright.ppm
check 'a message is read' reads 'Paused at frame 30'
keys 40 | picture 30 ''
check 'which leaves the upper 300 rows alone' cmp <(pixels picture.ppm -crop 240x300+0+0) \
    <(pixels upright.ppm -crop 240x300+0+0)
for turn in left:90 right:-90 over:180; do
    picture 34 "turn = ${turn%:*}" <paused
    same_pixels "turned ${turn%:*} it is the same picture" upright.ppm -rotate "${turn#*:}"
done

# The mouse on the bar of time: a quarter from the left, 4 px above the bottom; turned, that is elsewhere.
click() { # X,Y SETTINGS
    { keys 20; keys 1 $P; keys 2; keys 1 "@$1"; keys 12; } | picture 30 "$2" --demo plain.demo
}
click 60,316 ''
cp picture.ppm upright.ppm
check 'a click on the bar of time goes there' reads 'Paused at frame'
click 316,179 'turn = left'
same_pixels 'turned left it is where it is seen' upright.ppm -rotate 90

# In a wide window panels and messages are beside the picture, and it is as it would be without them.
keys 40 | picture 31 'border = no'
cp picture.ppm bare.ppm
{ keys 30; keys 1 $G; keys 1 $P; keys 5; } >script
beside=$'panels = beside\nborder = no'
KEYS_WINDOW=1200x700 picture 36 "$beside" <script
same_pixels 'the picture is bare' bare.ppm -crop 480x640+360+30 -scale 50%
convert picture.ppm -crop 360x700+840+0 +repage -scale 50% side.ppm
mv side.ppm picture.ppm
check 'gauges and messages are beside it' reads 'Paused at frame 31' 'part          live   top   cap refused'
KEYS_WINDOW=700x700 picture 36 "$beside" <script
check 'in a narrow window they are over it' reads 'Paused at frame 31'
keys 40 | KEYS_WINDOW=700x700 picture 31 'border = yes'
check 'the border is there' test "$(convert picture.ppm -format '%[hex:u.p{5,5}]' info: | cut -c1-6)" != 000000
same_pixels 'and the picture in it' bare.ppm -crop 480x640+110+30 -scale 50%

# ---- what is wrong ----

bad() { # FILE: packs with that as its border
    cp "$1" g/art/border.png
    "$curtain" pack g -o bad.rom
}
convert -size 40x40 xc:red full.png
refuse 'a border without a hole is refused' 'art/border.png: the border has no hole' bad full.png
same 'a wrong setting is reported' 'turn: expected none, left, right or over, got "up"' \
    "$(settings 'turn = up'; ./player play g </dev/null 2>&1 | grep -o 'turn: .*')"
# A DIP switch is set in the menu, and the game restarts with it.
game own <<'LUA'
print("coins: " .. board.dip("coins"))
task.go(function() board.ask("settings") end)
LUA
sed -i 's/^  board =/  dip = { coins = { "free", "one" } },\n&/' own/rom.lua
rm -rf data
{
    keys 20; press $DOWN $DOWN $DOWN $DOWN $ENTER; keys 4; press $RIGHT $ESCAPE $ESCAPE
    keys 4; press $DOWN $ENTER; keys 20
} >script
./player play own --no-resume <script >out 2>err
check 'a switch is saved' grep -qx 'dip.probe.coins = one' data/curtain/curtain.conf
same 'and the game restarts with it' $'coins: free\ncoins: one' "$(grep '^coins' err)"
finish

#!/bin/sh
# pictures.sh - makes the pictures of the pages, docs/images, anew: pictures.sh [CURTAIN]
set -eu
cd "$(dirname "$0")/.."
curtain=${1:-build/curtain-null}
at=$(mktemp -d)
trap 'rm -rf "$at"' EXIT
mkdir -p docs/images
"$curtain" render roms/glasstide --demo tests/demos/glasstide/clear-abyss.demo --frames 14893,26568,44189 -o "$at/play"
python3 tools/pictures.py 2 docs/images/glasstide.png "$at"/play/*.png
"$curtain" render roms/testcard --frames 120 -o "$at/card"
python3 tools/pictures.py 2 docs/images/testcard.png "$at"/card/*.png
"$curtain" render examples/sandbox --stage treasure --invincible --frames 200,262,290 -o "$at/items"
python3 tools/pictures.py 2 docs/images/items.png "$at"/items/*.png
"$curtain" render examples/sandbox --stage scenes --invincible --frames 100,260,420 -o "$at/scenes"
python3 tools/pictures.py 2 docs/images/backgrounds.png "$at"/scenes/*.png
"$curtain" render examples/canyon --demo examples/canyon/demos/run.demo --frames 400,800,1400 -o "$at/canyon"
python3 tools/pictures.py 1 docs/images/canyon.png "$at"/canyon/*.png
"$curtain" render examples/sandbox --stage lasers --invincible --frames 75,150,330 -o "$at/lasers"
python3 tools/pictures.py 1 docs/images/lasers.png "$at"/lasers/*.png

# The tutorial: the game that `curtain new` writes, and its boss at the end of each lesson.
"$curtain" render examples/shooter --frames 150 -o "$at/start"
"$curtain" render examples/shooter --stage river --press fire --invincible --frames 1250 -o "$at/start"
"$curtain" render examples/shooter --stage keeper/feast --press fire --invincible --frames 420 -o "$at/start2"
python3 tools/pictures.py 2 docs/images/start.png "$at"/start/*.png "$at"/start2/*.png
tests/cli/start.sh --made "$at/mygame"
"$curtain" render "$at/mygame" --stage keeper/mine --press fire --invincible --frames 100,210,320 -o "$at/mine"
python3 tools/pictures.py 2 docs/images/mine.png "$at"/mine/*.png
tests/cli/start.sh --made "$at/boss" 3
"$curtain" render "$at/boss" --stage keeper/moths --press fire --register power=4 --invincible --frames 280 \
    -o "$at/boss1"
"$curtain" render "$at/boss" --stage keeper/dawn --press focus,bomb@260 --frames 330 -o "$at/boss2"
"$curtain" render "$at/boss" --stage river:keeper --frames 330 -o "$at/boss3"
python3 tools/pictures.py 2 docs/images/boss.png "$at"/boss[123]/*.png

# One frame with both ways of adding light: by the table of all pairs of colours, and by the ramps' rule.
mkdir "$at/blends"
for way in '"add"' '{ ramp = "add" }'; do
    rm -rf "$at/sandbox"
    cp -r examples/sandbox "$at/sandbox"
    sed "s/glow = \"add\"/glow = $way/" examples/sandbox/rom.lua >"$at/sandbox/rom.lua"
    "$curtain" render "$at/sandbox" --stage glow --invincible --frames 200 -o "$at/glow"
    mv "$at/glow/000200.png" "$at/blends/$(ls "$at/blends" | wc -l).png"
done
python3 tools/pictures.py 2 docs/images/blends.png "$at"/blends/*.png
"$curtain" render roms/glasstide --stage three:queen --frames 160,520 -o "$at/talk"
"$curtain" render roms/glasstide --stage three:queen --frames 960 --lang ja -o "$at/talk"
python3 tools/pictures.py 1 docs/images/talk.png "$at"/talk/*.png

python3 tools/pictures.py 20 docs/images/art_palette.png examples/moth/art/palette.png
"$curtain" art examples/moth --atlas docs/images/art_atlas.png
"$curtain" render examples/moth --stage one --invincible --press fire --frames 130,250,1060 -o "$at/moth"
python3 tools/pictures.py 1 docs/images/art_play.png "$at"/moth/*.png

# Looking inside: a port that a script plays, and three of the pictures it is shown. Keys are USB HID usages.
${CC:-cc} -O1 -o "$at/player" tests/machine/port_keys.c $(find build/release/src -name '*.o') build/release/fb/*.o \
    build/release/gen/std.o build/release/gen/no_rom.o build/release/platform/stdio.o build/release/platform/posix.o \
    build/release/platform/posix_process.o \
    $(pkg-config --libs lua5.4) -lm -pthread
keys() { yes "$2" | head -n "$1"; }
look() { # NAME: standard input are the keys; the last picture before quitting
    cat >"$at/keys"
    (cd "$at" && XDG_DATA_HOME="$at" KEYS_PPM=$(wc -l <keys) ./player play "$OLDPWD/roms/glasstide" \
        --demo "$OLDPWD/roms/glasstide/demos/run.demo" <keys >/dev/null 2>&1 && mv picture.ppm "$1.ppm")
}
frame=2620 h=11 g=10 n=17 backquote=53 enter=40
{ keys $frame ""; keys 1 $h; keys 5 "~${mouse:-76,120}"; } | look 1
{ keys $frame ""; keys 1 $g; keys 1 ""; keys 1 $n; keys 3 ""; } | look 2
{ keys $((frame + 3)) ""; keys 1 $backquote; keys 1 ""
  for line in "board.live 'bullets', player.get(1).x" "bullet.fire { kind = 'ryce', x = 1, y = 2, speed = 1 }" \
      "while true do end"
  do printf "'%s\n%s\n\n" "$line" $enter; done; keys 2 ""; } | look 3
python3 tools/pictures.py 2 docs/images/inside.png "$at/1.ppm" "$at/2.ppm" "$at/3.ppm"

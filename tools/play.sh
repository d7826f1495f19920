#!/bin/sh
# Plays the built-in game; where there is no display, plays its demo without one and renders pictures of it.
set -eu
cd "$(dirname "$0")/.."
game=roms/glasstide
demo=$game/demos/attract.demo
out=build/play

if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] || [ "$(uname)" = Darwin ]; then
    code=0
    build/curtain "$@" || code=$?
    [ $code = 3 ] || exit $code # 3: the host failed; most likely nothing answers at that display
fi
echo "No display: playing the demo of $game without one."
said=$(build/curtain verify $game $demo) || { echo "$said"; exit 1; }
echo "$said"
frames=$(echo "$said" | sed -n 's/.*holds, \([0-9]*\) frames.*/\1/p')
rm -rf $out
mkdir -p $out
build/curtain render $game --demo $demo --frames $((frames / 24)):"$frames":$((frames / 12)) -o $out \
    --sheet $out/sheet.png
echo "$(ls $out/0*.png | wc -l) frames and a contact sheet of them, $out/sheet.png:"
ls $out/*.png

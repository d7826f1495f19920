#!/usr/bin/env bash
# port.sh - what every port of the whole program must show, whatever its window is: demos hold, the test card's frame
# 120 to the last pixel, pads that are recorded hold, sound and its file.
#
#     tests/port.sh PROGRAM          TAP; PROGRAM: a port of curtain, beside the one without a window that it is held to
. "$(dirname "$0")/tap.sh"
program=$(readlink -f "$1")
sandbox
check 'the demo of the test card holds' "$program" verify "$repo/roms/testcard" "$repo/roms/testcard/demos/card.demo"
check 'the demo of a frozen game holds' \
    "$program" verify "$repo/tests/demos/whole8.rom" "$repo/tests/demos/whole8-run.demo"
"$program" render "$repo/roms/testcard" --frames 120 -o card >/dev/null
check 'the test card, frame 120: to the last pixel' \
    python3 "$repo/tests/golden/png.py" "$repo/tests/golden/frames/card-000120.png" card/000120.png difference.png
"$program" hash "$repo/roms/glasstide" --seed 3 --press start@40,fire@60:400,left@90:140 --frames 400 --every 400 \
    --record pressed.demo >mine
check 'pads that are pressed: its demo holds' "$curtain" verify "$repo/roms/glasstide" pressed.demo
"$program" render "$repo/roms/glasstide" --demo pressed.demo --frames 400 --wav mine.wav -o heard >/dev/null
"$curtain" render "$repo/roms/glasstide" --demo pressed.demo --frames 400 --wav its.wav -o heard >/dev/null
check 'the sound of that run is the same, to the bit' cmp mine.wav its.wav
check 'and is no silence' sh -c '[ "$(tail -c +45 mine.wav | tr -d "\0" | wc -c)" -gt 10000 ]'
finish

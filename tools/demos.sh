#!/bin/sh
# Records the demos of the built-in game and of the test card anew: needed when their scripts, the standard library or
# the core version change.
set -eu
cd "$(dirname "$0")/.."
bot="${OUT:-build/release}/bot"
demos=roms/glasstide/demos
mkdir -p "$demos"
"$bot" roms/glasstide "$demos/attract.demo" --stage one --frames 2400 --seed 3 --quiet
"$bot" roms/glasstide "$demos/run.demo" --frames 24000 --finish --deaths 1 --bombs 3 --seed 1 --quiet
mkdir -p roms/testcard/demos
"$bot" roms/testcard roms/testcard/demos/card.demo --frames 600 --seed 1 --quiet

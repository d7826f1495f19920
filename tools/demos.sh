#!/bin/sh
# Records the demos of the built-in game anew: needed when its scripts, the standard library or the core version change.
set -eu
cd "$(dirname "$0")/.."
bot="${OUT:-build/release}/bot"
demos=roms/glasstide/demos
mkdir -p "$demos"
"$bot" roms/glasstide "$demos/attract.demo" --stage one --frames 2400 --seed 3 --quiet
"$bot" roms/glasstide "$demos/run.demo" --frames 20000 --finish --deaths 1 --seed 1 --quiet

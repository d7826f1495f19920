#!/usr/bin/env bash
# player.sh - curtain-player: it plays and verifies .rom files, contains nothing of the workbench, and is small.
. "$(dirname "$0")/../tap.sh"
sandbox
export SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy
player=$OUT/curtain-player

says() { expect_error "$1" 2 "curtain: $2" "$player" "${@:3}"; } # NAME TEXT ARGUMENT...

"$curtain" pack "$repo/examples/first" -o first.rom >/dev/null
"$curtain" hash first.rom --press fire --frames 90 --record run.demo >/dev/null
check 'a demo verifies' "$player" verify first.rom run.demo
check 'it plays a ROM, and finds the game of a demo' "$player" run.demo --mute
says 'a folder' "$repo/examples/first: is a folder; this program plays .rom files (curtain pack makes one)" \
    play "$repo/examples/first"
says 'without a game' 'no built-in game; name a ROM (see curtain help)'
says 'a command of the workbench' 'check: not available in curtain-player; use curtain' check first.rom
says 'verify --bisect' 'verify: --bisect is not available in curtain-player; use curtain' verify --bisect a b
same 'help lists its commands' 'play verify help version licences' \
    "$("$player" help | sed -n 's/^  curtain \([a-z]*\) .*/\1/p' | xargs)"
check 'its licences' eval '"$player" licences | grep -q SDL'

# ---- what is in it ----

objects() { grep -c 'src/workbench/' "$OUT/$1.map"; } # of the workbench
same 'nothing of the workbench' 0 "$(objects curtain-player)"
strip -o small "$player"
check 'at most 1.5 MB' test "$(stat -c %s small)" -le 1500000
"${curtain%-null}" export "$repo/examples/first" -o first
check 'an exported game at most 3 MB' test "$(stat -c %s first)" -le 3000000
finish

#!/usr/bin/env bash
# leaves.sh - what a headless run leaves behind: the pictures it was asked for, and nothing else. Every file and folder
# of the home, the working folder, the game's and the one for temporary files is compared before and after.
. "$(dirname "$0")/../tap.sh"
sandbox
unset XDG_DATA_HOME XDG_CONFIG_HOME XDG_CACHE_HOME
mkdir home here short
cp -r "$repo/roms/glasstide" .
"$curtain" pack glasstide -o game.rom || not_ok 'the game is packed'

tree() { find home here short glasstide game.rom -printf '%y %m %s %p\n' -type f -exec cksum {} + | sort; }

leaves() { # NAME ADDED ARGUMENT...: ADDED: the files that are new
    local name=$1 added=$2 got
    shift 2
    tree >before
    (cd here && HOME=$scratch/home TMPDIR=$scratch/short "$curtain" "$@" >/dev/null 2>../err) ||
        not_ok "$name: it runs" "$(cat err)"
    tree >after
    got=$(diff before after | sed -n 's/^> f .* //p')
    same "$name" "$added" "$got"
    same "$name: all else is as it was" '' "$(diff before after | grep '^<')"
    (cd here && rm -f ./*.png)
}

# ---- a fresh home ----

leaves 'render of a folder' here/000000.png render ../glasstide --frames 0
leaves 'render of a ROM' here/000000.png render ../game.rom --frames 0
leaves 'render of the built-in game' here/000000.png render --frames 0
leaves 'hash' '' hash ../glasstide --frames 100
leaves 'verify' '' verify ../glasstide ../glasstide/demos/attract.demo

# ---- without a ROM: the built-in game ----

"$curtain" hash "$repo/roms/glasstide" --frames 60 >one
"$curtain" hash --frames 60 >two
same 'hash without a ROM is of the built-in game' "$(cat one)" "$(cat two)"
"$curtain" render "$repo/roms/glasstide" --frames 30 -o one.d
"$curtain" render --frames 30 -o two.d
check 'render without a ROM draws it' cmp one.d/000030.png two.d/000030.png
finish

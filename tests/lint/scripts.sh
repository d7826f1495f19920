#!/usr/bin/env bash
# scripts.sh - every game packs, and no script names what nobody declared.
. "$(dirname "$0")/../tap.sh"
curtain=$OUT/curtain-null

for rom in roms/*/; do
    check "${rom%/} packs" "$curtain" pack "$rom" -o "$scratch/game.rom"
done

lint() { "$curtain" help lua | lua5.4 tests/lint/lint.lua "$@"; }
check "no script of a game uses an unknown name" lint $(tree 'roms/*.lua' | grep -vE '/(std|tests)/')
library=$(tree 'scripts/*.lua')
check "no script of the library uses an unknown name" lint $(printf -- '--with %s ' $library) $library

planted() {
    printf '%s\n' "$1" >"$scratch/planted.lua"
    lint "$scratch/planted.lua"
}
check "a good script is let through" planted \
    'local n = math.floor(2.5) bullet.fire { kind = "a", speed = n, x = 1, y = 2 } wait(1)'
detects "a misspelt function" "unknown name bullet.fyre" planted 'bullet.fyre { }'

# A game that has no continues asks for none, in no story and no condition. Comments may say what continues.
no_continues() { # FOLDER
    grep -rq 'continues = [0-9]' "$1"/main.lua || ! grep -rnE --include=*.lua '^([^-]|-[^-])*continues' "$1"
}
for game in roms/*/ examples/*/; do
    check "${game%/} speaks of no continues that it has not" no_continues "${game%/}"
done
finish

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
detects "a misspelt table" "unknown name bulet" planted 'bulet.fire { }'
detects "a new global" "writes the global speed" planted 'speed = 3'
detects "a name the sandbox lacks" "unknown name os" planted 'local t = os.time()'
detects "a random number of the host" "unknown name math.random" planted 'return math.random(6)'
detects "a misspelt local" "unknown name conut" planted 'local count = 1 return function() return conut + 1 end'
detects "a syntax error" "does not compile" planted 'local = 1'

# A game that has no continues asks for none, in no story and no condition. Comments may say what continues.
no_continues() { # FOLDER
    grep -rq 'continues = [0-9]' "$1"/main.lua || ! grep -rnE --include=*.lua '^([^-]|-[^-])*continues' "$1"
}
for game in roms/*/ examples/*/; do
    check "${game%/} speaks of no continues that it has not" no_continues "${game%/}"
done
cp -r examples/first "$scratch/first"
echo 'local function won(run) return run.continues == 0 end' >>"$scratch/first/main.lua"
detects "a condition on continues" "run.continues" no_continues "$scratch/first"
finish

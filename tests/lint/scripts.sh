#!/usr/bin/env bash
# scripts.sh - no game mentions continues that it does not have. Names that nobody declared are found by
# cli/luacheck.sh, and by `curtain check` in cli/check.sh.
. "$(dirname "$0")/../tap.sh"

# A game that has no continues asks for none, in no story and no condition. Comments may say what continues.
no_continues() { # FOLDER
    grep -rq 'continues = [0-9]' "$1"/main.lua || ! grep -rnE --include=*.lua '^([^-]|-[^-])*continues' "$1"
}
for game in roms/*/ examples/*/; do
    check "${game%/} speaks of no continues that it has not" no_continues "${game%/}"
done
finish

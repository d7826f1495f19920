#!/usr/bin/env bash
# luacheck.sh - `curtain help lua --luacheck`: luacheck, with these names, finds nothing in all scripts of the
# repository, and finds mistakes.
#
# `local x <close>` is a use, which luacheck does not know.
. "$(dirname "$0")/../tap.sh"
curtain=$OUT/curtain-null
rc=$scratch/luacheckrc

"$curtain" help lua --luacheck >"$rc"
check "the settings are Lua" "${LUAC:-luac5.4}" -p "$rc"
cat >>"$rc" <<'END'
files["**/scripts/**"] = { std = "curtain_library" }
END

findings() { # FILE...: what luacheck says, a line each, but of variables that are closed
    local at line rest
    luacheck --no-color --no-cache --codes --formatter plain --config "$rc" "$@" >"$scratch/said"
    [ $? -le 1 ] || { cat "$scratch/said"; return; }
    while IFS=: read -r at line rest; do
        case $rest in *W211*) sed -n "${line}p" "$at" | grep -q '<close>' && continue ;; esac
        printf '%s:%s:%s\n' "$at" "$line" "$rest"
    done <"$scratch/said"
}
clean() { # FILE...: nothing at all
    findings "$@" >"$scratch/found"
    [ ! -s "$scratch/found" ] || { cat "$scratch/found"; return 1; }
}
scripts=$(tree 'scripts/*.lua' 'roms/*.lua' 'examples/*.lua')
check "nothing is wrong with scripts, roms and examples" clean $scripts

finds_nothing() { # TEXT
    printf '%s\n' "$1" >"$scratch/finds_nothing.lua"
    clean "$scratch/finds_nothing.lua"
}
check "a good script is let through" finds_nothing \
    'bullet.fire { kind = "a", speed = math.pi, x = rom.field.w, y = 2 }
     hud.banks.bright = game.power talk.look.dim = 0'
while IFS='|' read -r text finding; do
    refuse "$text" "$finding" finds_nothing "$text"
done <<'END'
bullet.fyre { }|undefined field 'fyre' of global 'bullet'
speed = 3|setting non-standard global variable 'speed'
print(os.time())|undefined variable 'os'
function bullet.fire() end|setting read-only field 'fire' of global 'bullet'
rom.title = "one"|setting read-only field 'title' of global 'rom'
END
mkdir "$scratch/std"
within() { (cd "$scratch" && "$@"); } # the settings' folders are those of the folder it runs in
echo 'hud.put(1, 1, "x") function hud.more() end' >"$scratch/std/hud.lua"
check "in place of the library, all of it" within clean std/hud.lua
echo 'hud.put(1, 1, rng.fyre)' >"$scratch/std/hud.lua"
refuse "and no more than it" "undefined field 'fyre'" within clean std/hud.lua
"$curtain" help lua --annotations >"$scratch/.curtain.lua"
check "what is written for editors is passed over" clean "$scratch/.curtain.lua"
finish

#!/usr/bin/env bash
# luacheck.sh - `curtain help lua --luacheck`: luacheck, with these names, finds nothing in all scripts of the
# repository, and finds what is planted.
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
check "there are scripts to look at" test "$(wc -l <<<"$scripts")" -gt 150
# shellcheck disable=SC2086
check "nothing is wrong with scripts, roms and examples" clean $scripts

planted() { # TEXT
    printf '%s\n' "$1" >"$scratch/planted.lua"
    clean "$scratch/planted.lua"
}
check "a good script is let through" planted \
    'bullet.fire { kind = "a", speed = math.pi, x = rom.field.w, y = 2 }
     hud.banks.bright = game.power talk.look.dim = 0'
detects "a misspelt function" "undefined field 'fyre' of global 'bullet'" planted 'bullet.fyre { }'
detects "a misspelt table" "undefined variable 'bulet'" planted 'bulet.fire { }'
detects "a new global" "setting non-standard global variable 'speed'" planted 'speed = 3'
detects "a name the sandbox lacks" "undefined variable 'os'" planted 'print(os.time())'
detects "a random number of the host" "undefined field 'random' of global 'math'" planted \
    'print(math.random(6))'
detects "a function of the API is replaced" "setting read-only field 'fire' of global 'bullet'" planted \
    'function bullet.fire() end'
detects "a function that the library keeps" "undefined field 'put' of global 'hud'" planted 'hud.put(1, 1, "x")'
detects "a field that rom has not" "undefined field 'name' of global 'rom'" planted 'print(rom.name)'
detects "a variable that nothing reads" "unused variable 'n'" planted 'local n = 1'
detects "the title is set" "setting read-only field 'title' of global 'rom'" planted 'rom.title = "one"'
mkdir "$scratch/std"
within() { (cd "$scratch" && "$@"); } # the settings' folders are those of the folder it runs in
echo 'hud.put(1, 1, "x") function hud.more() end' >"$scratch/std/hud.lua"
check "in place of the library, all of it" within clean std/hud.lua
echo 'hud.put(1, 1, rng.fyre)' >"$scratch/std/hud.lua"
refuse "and no more than it" "undefined field 'fyre'" within clean std/hud.lua
"$curtain" help lua --annotations >"$scratch/.curtain.lua"
check "what is written for editors is passed over" clean "$scratch/.curtain.lua"
refuse "with annotations" "--luacheck cannot be combined with --annotations" "$curtain" help lua --annotations \
    --luacheck
refuse "without lua" "--luacheck works only with curtain help lua --luacheck" "$curtain" help config --luacheck
finish

#!/usr/bin/env bash
# frozen.sh - frozen ROMs bring the standard library of their time: every sys.NAME that the scripts of any of them use,
# and every entry that they have arguments checked by, is still there. What changes is added beside it. The names are
# those in the ROMs; whether they are there is asked of a board, in a game whose own std/boot.lua takes the place of
# @std's.
. "$(dirname "$0")/../tap.sh"
curtain=$OUT/curtain-null

# Names after "sys." in all scripts of a ROM but those that these scripts declare, or those of the library that a game
# without need of them does not bring; names sys.check is reported.
used() { # ROM
    local dir
    dir=$(mktemp -d -p "$scratch")
    "$curtain" unpack "$1" "$dir/rom" || return 1
    grep -rhoE 'function sys\.[a-z_]+|^ *sys\.[a-z_]+ =' --include=*.lua "$dir/rom" scripts |
        sed 's/.*sys\.//; s/ =$//' | sort -u >"$dir/own"
    grep -rhoE '\bsys\.[a-z_]+' --include=*.lua "$dir/rom" | sed 's/sys\.//' | sort -u | comm -23 - "$dir/own"
}
checked() { # ROM
    local dir
    dir=$(mktemp -d -p "$scratch")
    "$curtain" unpack "$1" "$dir/rom" || return 1
    grep -rhoE 'sys\.check\("[a-z_]+[.:][a-z_]+"' --include=*.lua "$dir/rom" | sed 's/.*("//; s/"$//' | sort -u
}

mkdir -p "$scratch/game/std" "$scratch/game/art"
cp tests/demos/whole/art/all.png "$scratch/game/art/"
cat >"$scratch/game/rom.lua" <<'END'
return { id = "names", title = "Names", screen = { w = 64, h = 64 }, sheets = { all = { file = "art/all.png" } },
  board = { items = 8, lines = 8, lasers = 8, curve_points = 32 },
  sprites = { dot = { sheet = "all", x = 0, y = 0, w = 8, h = 8 } } }
END
echo 'local all = true' >"$scratch/game/main.lua"
# Every name of a list is one of sys.
there() { # NAMES (a file)
    {
        echo 'local sys, gone = ..., {}'
        sed 's/.*/if type(sys["&"]) ~= "function" then gone[#gone + 1] = "sys.&" end/' "$1"
        echo 'if #gone > 0 then error("gone, and a frozen ROM calls it: " .. table.concat(gone, ", "), 0) end'
        echo 'return {}'
    } >"$scratch/game/std/boot.lua"
    "$curtain" hash "$scratch/game" --frames 0
}
# Every name of a list is an entry, which sys.check knows.
entries() { # NAMES (a file)
    local name bad=0
    while read -r name; do
        grep -rqF "\"$name\"" src/script/api ||
            { echo "gone, and a frozen ROM has its arguments checked by it: $name"; bad=1; }
    done <"$1"
    return $bad
}

for rom in tests/demos/*.rom; do
    check "the names $rom uses" used "$rom"
    used "$rom" >"$scratch/used"
    checked "$rom" >"$scratch/checked"
    check "all of them are there" there "$scratch/used"
    check "so are the entries it has arguments checked by" entries "$scratch/checked"
done
echo gone >>"$scratch/used"
detects 'a name that is gone' 'gone, and a frozen ROM calls it: sys.gone' there "$scratch/used"
finish

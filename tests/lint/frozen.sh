#!/usr/bin/env bash
# frozen.sh - frozen ROMs bring the standard library of their time: every sys.NAME that the scripts of any of them use,
# and every entry that they have arguments checked by, is still there. What changes is added beside it. Whether names
# are there is asked of a board, in a game whose own std/boot.lua takes the place of @std's.
. "$(dirname "$0")/../tap.sh"
curtain=$OUT/curtain-null

# all PATTERN FILE...: what a pattern finds in the scripts, after the first "sys." or quotation mark
all() { grep -rhoE --include=*.lua -- "$@" | sed -E 's/^[^"]*(sys\.|")//; s/("| =)$//' | sort -u; }
mkdir -p "$scratch/game/std"
cp -r tests/demos/whole/art "$scratch/game/"
cat >"$scratch/game/rom.lua" <<'END'
return { id = "names", title = "Names", screen = { w = 64, h = 64 }, sheets = { all = { file = "art/all.png" } },
  board = { items = 8, lines = 8, lasers = 8, curve_points = 32 },
  sprites = { dot = { sheet = "all", x = 0, y = 0, w = 8, h = 8 } } }
END
echo 'local all = true' >"$scratch/game/main.lua"
there() { # NAME...: each is in sys
    local name
    {
        echo 'local sys = ...'
        for name; do
            echo "if not sys.$name then error('gone, and a frozen ROM calls it: sys.$name', 0) end"
        done
        echo 'return {}'
    } >"$scratch/game/std/boot.lua"
    "$curtain" hash "$scratch/game" --frames 0
}
entries() { # NAME...: each is an entry, which sys.check knows
    local name
    for name; do
        grep -rqF "\"$name\"" src/script/api ||
            { echo "gone, and a frozen ROM checks arguments by it: $name"; return 1; }
    done
}

for rom in tests/demos/*.rom; do
    unpacked=$scratch/$(basename "$rom" .rom)
    check "$rom unpacks" "$curtain" unpack "$rom" "$unpacked"
    # What these scripts declare is left out, and what today's library declares that a game may not bring.
    all 'function sys\.[a-z_]+|^ *sys\.[a-z_]+ =' "$unpacked" scripts >"$scratch/declared"
    all '\bsys\.[a-z_]+' "$unpacked" | comm -23 - "$scratch/declared" >"$scratch/used"
    check "the names that it uses are there" there $(cat "$scratch/used")
    check "so are the entries it has arguments checked by" entries $(all 'sys\.check\("[a-z_]+[.:][a-z_]+"' "$unpacked")
done
detects 'a name that is gone' 'gone, and a frozen ROM calls it: sys.gone' there $(cat "$scratch/used") gone
finish

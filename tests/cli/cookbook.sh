#!/usr/bin/env bash
# cookbook.sh - every page of the cookbook runs without a fault and with no pool full, and comes to what it always came
# to (tests/cookbook/table); its words and the page docs/cookbook.md are those of the recipes, with a picture of each.
# `make cookbook` renews all of that.
. "$(dirname "$0")/../tap.sh"
game=roms/cookbook
made=tools/cookbook/cookbook.sh

list() { sed -n '/^local pages/,/^}/p' $game/main.lua | grep -o '"[a-z0-9_]*"' | tr -d '"' | sort; }
all() { # FOLDER
    diff <(list) <(ls "$1" | sed 's/\.lua$//' | sort)
}
check "every recipe is a page, once" all $game/recipes

# A recipe begins with its words, and is short.
short() { # FILE...
    local file lines
    for file in "$@"; do
        head -n 1 "$file" | grep -qE "^-- $(basename "$file") - [^:]+: " || { echo "$file has no title"; return 1; }
        lines=$(grep -vc '^--' "$file")
        [ "$lines" -ge 4 ] && [ "$lines" -le 45 ] || { echo "$file has $lines lines"; return 1; }
        ! grep -nE '.{101,}' "$file" || { echo "$file: a line has more than 100 characters"; return 1; }
    done
}
check "every recipe has its title and is short" short $game/recipes/*.lua

# But for the work of calls, which depends a little on addresses: what pairs() sorts stands in one order or another.
steady() { cut -d ' ' -f 1-5 "$1"; }
$made --table 2>"$scratch/says" >"$scratch/table"
same "no fault, and no pool was full" "" "$(cat "$scratch/says")"
current() { diff <(steady "$1") <(steady tests/cookbook/table); }
check "every page comes to what tests/cookbook/table says" current "$scratch/table"
sed '5s/ [0-9a-f]\{16\} / 0123456789abcdef /' "$scratch/table" >"$scratch/other"
detects "another hash" "0123456789abcdef" current "$scratch/other"

book() { $made --book | diff - "$1"; }
check "book.txt has the words of the recipes" book $game/book.txt
page() { $made --page | diff - "$1"; }
check "docs/cookbook.md is what its command writes" page docs/cookbook.md
pictures() { diff <(list) <(ls docs/images/cookbook | sed 's/\.png$//' | sort); }
check "every page has its picture" pictures
light() { [ "$(cat docs/images/cookbook/*.png | wc -c)" -lt "$1" ]; }
check "the pictures are light" light 1500000
finish

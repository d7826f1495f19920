#!/usr/bin/env bash
# build.sh - pages of one file, with all they need inside.
#
#     ports/web/build.sh player CORE.wasm OUT.html       the player, without a game: it plays what is dropped on it
#     ports/web/build.sh game GAME PLAYER.html           the same with a game inside, GAME a folder or a packed game:
#                                                        NAME.html beside the player
#
# A player has two marks left for a game, each once or more: @TITLE@, and @ROM@ (base64 of the packed game, of its gzip
# when that is smaller). OUT is the build folder.
set -eu
cd "$(dirname "$0")/../.."
here=ports/web
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

packed() { # FILE: base64 of it, or of its gzip
    gzip -9nc "$1" >"$scratch/gz"
    if [ "$(wc -c <"$scratch/gz")" -lt "$(wc -c <"$1")" ]; then base64 -w 0 "$scratch/gz"; else base64 -w 0 "$1"; fi
}
# fill MARK FILE: standard input with that file in place of each @MARK@; nothing in the file is looked at
fill() {
    awk -v mark="@$1@" -v file="$2" '
        BEGIN { while ((getline line < file) > 0) text = text (n++ ? "\n" : "") line }
        {
            out = ""
            while ((at = index($0, mark)) > 0) {
                out = out substr($0, 1, at - 1) text
                $0 = substr($0, at + length(mark))
            }
            print out $0
        }'
}

case ${1:-} in
player)
    packed "$2" >"$scratch/core"
    base64 -w 0 "$here/worklet.js" >"$scratch/worklet"
    # of the list what is in a page: the engine and Lua
    "${OUT:-build/release}/curtain-bare" licences --full |
        sed '/^stb /d; /^glibc /d; /^Packing /,/neither\.$/d
            s/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g' >"$scratch/licences"
    fill STYLE "$here/player.css" <"$here/page.html" | fill LICENCES "$scratch/licences" |
        fill PLAYER "$here/player.js" | fill WORKLET "$scratch/worklet" | fill CORE "$scratch/core" >"$scratch/page"
    mkdir -p "$(dirname "$3")"
    cp "$scratch/page" "$3"
    echo "core $(wc -c <"$2") bytes, $(gzip -9nc "$2" | wc -c) gzipped; $3 $(wc -c <"$3")"
    ;;
game)
    curtain=${OUT:-build/release}/curtain-bare
    rom=$2
    if [ -d "$rom" ]; then
        rom=$scratch/game.rom
        "$curtain" pack "$2" -o "$rom"
    fi
    out=$(dirname "$3")/$(basename "$2" .rom).html
    if [ -f "$2/rom.lua" ]; then
        sed -n 's/^.*[ {,]title = "\([^"]*\)".*/\1/p' "$2/rom.lua" | head -n 1 >"$scratch/title"
    fi
    [ -s "$scratch/title" ] || basename "$2" .rom >"$scratch/title" # until the page has asked the game itself
    sed -i 's/&/\&amp;/g; s/</\&lt;/g' "$scratch/title"
    packed "$rom" >"$scratch/rom"
    fill TITLE "$scratch/title" <"$3" | fill ROM "$scratch/rom" >"$scratch/page"
    cp "$scratch/page" "$out"
    echo "$out: $(wc -c <"$out") bytes, of them $(wc -c <"$scratch/rom") the game"
    ;;
*)
    sed -n '2,/^set/s/^# \{0,1\}//p' "$0" >&2
    exit 2
    ;;
esac

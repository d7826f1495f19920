#!/usr/bin/env bash
# build.sh - the player, one page with all that it needs inside, without a game: it plays what is dropped on it.
#
#     platform/web/build.sh CORE.wasm OUT.html
#
# It has two marks left for a game, @TITLE@, each time, and @ROM@, once; `curtain export --web` puts one there. OUT is
# the build folder.
set -eu
cd "$(dirname "$0")/../.."
here=platform/web
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

packed() { # FILE: base64 of it, or of its gzip, as small as zopfli makes it
    zopfli --gzip -c "$1" >"$scratch/gz"
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

[ $# = 2 ] || { sed -n '2,/^set/s/^# \{0,1\}//p' "$0" >&2; exit 2; }
core=$1 out=$2
curtain=${OUT:-build/release}/curtain-bare
packed "$core" >"$scratch/core"
base64 -w 0 "$here/worklet.js" >"$scratch/worklet"
"$curtain" version | sed -n '1s/.*(core \([0-9]*\),.*/\1/p' >"$scratch/version"
# of the list what is in a page: the engine and Lua
"$curtain" licences --full |
    sed '/^stb /d; /^glibc /d; /^Packing /,/neither\.$/d
        s/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g' >"$scratch/licences"
fill STYLE "$here/player.css" <"$here/page.html" | fill CORE_VERSION "$scratch/version" |
    fill LICENCES "$scratch/licences" | fill PLAYER "$here/player.js" | fill WORKLET "$scratch/worklet" |
    fill CORE "$scratch/core" >"$scratch/page"
mkdir -p "$(dirname "$out")"
cp "$scratch/page" "$out"
echo "core $(wc -c <"$core") bytes, $(wc -c <"$scratch/gz") gzipped; $out $(wc -c <"$out")"

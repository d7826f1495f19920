#!/usr/bin/env bash
# version.sh - `curtain version` prints the release, as in src/player/game/version.h and at the top of CHANGELOG.md; the
# core version, as in src/board/board.h; and the release of Lua.
. "$(dirname "$0")/../tap.sh"
curtain=$OUT/curtain-null

release=$(sed -n 's/^#define CURTAIN_VERSION "\(.*\)"$/\1/p' src/player/game/version.h)
core=$(sed -n 's/.*CORE_VERSION = \([0-9]*\).*/\1/p' src/board/board.h)
lua=$(printf '#include <lua.h>\nLUA_RELEASE\n' | ${CC:-cc} -E -P $(pkg-config --cflags lua5.4) - |
    tail -1 | tr -d '"' | sed 's, *\. *,.,g; s,  *, ,g')
first() { "$curtain" "$@" | head -n 1; }
says() { # WORDS WORD...: the first line
    [ "$(first "${@:2}")" = "$1" ] || { echo "expected $1, got $(first "${@:2}")"; return 1; }
}
check "the release is a number of three parts" grep -qxE '[0-9]+\.[0-9]+\.[0-9]+' <<<"$release"
check "version" says "curtain $release (core $core, $lua)" version
check "--version is the same" says "curtain $release (core $core, $lua)" --version
check "with a command too" says "curtain $release (core $core, $lua)" play --version
same() { [ "$("$curtain" version | grep -v ^platform)" = "$("$OUT/curtain" version | grep -v ^platform)" ]; }
check "the program with a window says the same, but for its platform" same
line() { "$@" version | grep "^$key"; }
key=platform
same_line() { [ "$(line "${@:2}")" = "$1" ] || { echo "expected $1, got $(line "${@:2}")"; return 1; }; }
check "SDL, the one that is loaded" same_line "platform SDL $(sdl2-config --version)" "$OUT/curtain"
check "without it" same_line "platform no window" "$curtain"

# The libraries that packing opens: found, and missing, where a file that is none is in their place.
mkdir "$scratch/none"
for library in "libsndfile.so.1 OGG and FLAC:libsndfile1" "libopenmpt.so.0 tracker modules:libopenmpt0"; do
    file=${library%% *} key=${library%%.*} reads=${library#* }
    check "$key is found" grep -qxE "$key [0-9]+\.[0-9]+\.[0-9]+: reads ${reads%:*}" <("$curtain" version)
    touch "$scratch/none/$file"
    check "$key is missing" \
        same_line "$key, which reads ${reads%:*}, is not installed (Debian package: ${reads#*:})" \
        env LD_LIBRARY_PATH="$scratch/none" "$curtain"
    rm "$scratch/none/$file"
done
helps() { "$curtain" help | grep -qE '^  curtain version  .*release' && "$curtain" help | grep -qE '^  --version '; }
check "help lists it" helps

newest() { # FILE: its first heading of a version is the release's
    local top
    top=$(sed -n 's/^## \([0-9.]*\).*/\1/p' "$1" | head -n 1)
    [ "$top" = "$release" ] || { echo "$1 begins with $top, expected $release"; return 1; }
}
check "CHANGELOG.md begins with it" newest CHANGELOG.md
cores() { # FILE: has a line for every core version
    local v
    for v in $(seq "$core"); do
        grep -q "^| $v | " "$1" || { echo "$1 has no core version $v"; return 1; }
    done
}
check "CHANGELOG.md has every core version" cores CHANGELOG.md
sed "/^| $core | /d" CHANGELOG.md >"$scratch/changes.md"
detects "one is missing" "no core version $core" cores "$scratch/changes.md"
finish

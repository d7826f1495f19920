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
check "version" says "curtain $release (core $core, $lua)" version
check "--version is the same" says "curtain $release (core $core, $lua)" --version
line() { "$@" version | grep "^$key"; }
key=platform
same_line() { [ "$(line "${@:2}")" = "$1" ] || { echo "expected $1, got $(line "${@:2}")"; return 1; }; }
check "SDL, the one that is loaded" same_line "platform SDL $(sdl2-config --version)" "$OUT/curtain"
check "without it" same_line "platform no window" "$curtain"


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

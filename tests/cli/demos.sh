#!/usr/bin/env bash
# demos.sh - demo files for ever: every demo of tests/demos/table holds and ends in the hash it always ended in; every
# demo of the repository is in the table; every format that was ever written within this core version is there; every
# core version says which tick differs.
#
#     tests/cli/demos.sh --table      prints the table anew
. "$(dirname "$0")/../check.sh"
program=$OUT/curtain-null
core=$("$program" version | sed -n 's/^curtain core version //p')

# The ROM a demo is played on: of roms/NAME/demos/X.demo the folder, of tests/demos/NAME-X.demo the ROM.
rom_of() {
    case $1 in
    roms/*) echo "${1%/demos/*}" ;;
    *) sed 's/-[^-]*\.demo$/.rom/' <<<"$1" ;;
    esac
}
demos() { tree 'roms/*/demos/*.demo' 'tests/demos/*.demo' | sort; }
field() { python3 tests/cli/demo_read.py "$2" | sed -n "s/^$1 //p"; }
frames_of() { field end "$1" | cut -d' ' -f1; }
# The hash after a demo's last frame.
last_hash() { # ROM DEMO FRAMES
    local every=$3
    [ "$every" != 0 ] || every=1
    "$program" hash "$1" --demo "$2" --every "$every" 2>/dev/null | sed -n "s/^$3 //p"
}
table() {
    echo '# core  demo  ROM  frames  last hash: see README.md'
    demos | while read -r demo; do
        rom=$(rom_of "$demo") frames=$(frames_of "$demo")
        echo "$(field core "$demo") $demo $rom $frames $(last_hash "$rom" "$demo" "$frames")"
    done
}
if [ "${1:-}" = --table ]; then
    table
    exit
fi

# One line of the table.
holds() { # CORE DEMO ROM FRAMES HASH
    local got line
    if [ "$1" != "$core" ]; then # of an older one: it may differ, and is not refused
        "$program" verify "$3" "$2"
        [ $? -le 1 ]
        return
    fi
    got=$(last_hash "$3" "$2" "$4")
    if [ "$got" != "$5" ]; then
        echo "core version $core: ${2##*/} ended in $got, the table says $5: the tick changed: raise CORE_VERSION and say in docs/determinism.md which tick differs"
        return 1
    fi
    line=$("$program" verify "$3" "$2") || { echo "$line" && return 1; }
    [ "$(field core "$2") $(frames_of "$2")" = "$1 $4" ] || { echo "$2 is not the demo the table lists" && return 1; }
}
listed() { # DEMO TABLE
    awk -v demo="$1" '$2 == demo { found = 1 } END { exit !found }' "$2" || { echo "$1 is not in tests/demos/table" && return 1; }
}
# Every core version up to the program's has its line under "Core versions".
versions() { # PAGE CORE
    local v
    for ((v = 1; v <= $2; v++)); do
        sed -n '/^## Core versions/,/^## [^C]/p' "$1" | grep -Eq "^\| $v \| .+ \|$" || { echo "docs/determinism.md has no line for core version $v" && return 1; }
    done
}
format_of() { od -An -tu4 -j4 -N4 "$1" | tr -d ' '; }
# Every format that this build reads is there.
formats() { # OLDEST NEWEST DEMO...
    local format found demo oldest=$1 newest=$2
    shift 2
    for ((format = oldest; format <= newest; format++)); do
        found=
        for demo in "$@"; do [ "$(format_of "$demo")" != "$format" ] || found=1; done
        [ "$found" ] || { echo "no demo of format $format" && return 1; }
    done
}

rows=0
while read -r c demo rom frames hash; do
    [ "$c" != '#' ] || continue
    rows=$((rows + 1))
    check "$demo holds" holds "$c" "$demo" "$rom" "$frames" "$hash"
done <tests/demos/table
check 'the table has rows' [ $rows -gt 4 ]
for demo in $(demos); do check "$demo is listed" listed "$demo" tests/demos/table; done
check 'every core version says what changed' versions docs/determinism.md "$core"
read -r oldest newest < <(sed -n 's/.*DEMO_FORMAT = \([0-9]*\).*/\1/p;s/.*DEMO_OLDEST = \([0-9]*\).*/\1/p' src/cab/demo.h | sort -n | xargs)
check 'a demo of every format' formats "$oldest" "$newest" tests/demos/*.demo
# Format 1 came with core version 1 and ended with it.
check 'no format of this core version is refused' [ "$oldest" = 2 ]

# Planted: another hash, a demo that nobody listed, a core version nobody explained, a format that is not there.
read -r c demo rom frames hash < <(grep frozen-2 tests/demos/table)
refuse 'planted: another hash' "core version $core: frozen-2.demo ended in $hash, the table says 0000000000000000: the tick changed: raise CORE_VERSION" \
    holds "$c" "$demo" "$rom" "$frames" 0000000000000000
refuse 'planted: another length' 'is not the demo the table lists' holds "$c" "$demo" "$rom" $((frames - 5)) "$(last_hash "$rom" "$demo" $((frames - 5)))"
grep -v frozen-2 tests/demos/table >"$scratch/table"
refuse 'planted: a demo that is not listed' 'tests/demos/frozen-2.demo is not in tests/demos/table' listed "$demo" "$scratch/table"
refuse 'planted: a core version without its line' "no line for core version $((core + 1))" versions docs/determinism.md $((core + 1))
refuse 'planted: a format without a demo' 'no demo of format 2' formats 2 3 tests/demos/frozen-3.demo
refuse 'planted: a format to come' "no demo of format $((newest + 1))" formats "$oldest" $((newest + 1)) tests/demos/*.demo
done_testing

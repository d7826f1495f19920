#!/usr/bin/env bash
# demos.sh - demo files for ever: every demo of tests/demos/table holds and ends in the hash it always ended in; every
# demo of the repository is in the table; every core version has its frozen ROM, and the demos of older ones run to
# their end on this one, and end in the hash that tests/demos/rerecorded says; every format that was ever written is
# there; every core version says which tick differs. See tests/demos/README.md.
#
#     tests/cli/demos.sh --table           prints the table anew; the lines of older core versions stay
#     tests/cli/demos.sh --rerecorded      prints what the demos of older core versions end in on this one
#     tests/cli/demos.sh --freeze          packs tests/demos/whole as this core version's ROM, records demos of it with
#                                          $OUT/bot, and writes both tables
. "$(dirname "$0")/../tap.sh"
program=$OUT/curtain-null
core=$("$program" version | sed -n 's/^curtain .*(core \([0-9]*\),.*/\1/p')

# The ROM a demo is played on: of roms/NAME/demos/X.demo and examples/NAME/demos/X.demo the folder, of
# tests/demos/NAME/X.demo that of roms, of tests/demos/NAME-X.demo the ROM.
rom_of() {
    case $1 in
    roms/* | examples/*) echo "${1%/demos/*}" ;;
    tests/demos/*/*) echo "roms/$(basename "$(dirname "$1")")" ;;
    *) sed 's/-[^-]*\.demo$/.rom/' <<<"$1" ;;
    esac
}
demos() {
    tree 'roms/*/demos/*.demo' 'examples/*/demos/*.demo' 'tests/demos/*.demo' |
        grep -v '^tests/demos/phases/' | sort
}
field() { python3 tests/cli/demo_read.py "$2" | sed -n "s/^$1 //p"; }
frames_of() { field end "$1" | cut -d' ' -f1; }
# The hash after a demo's last frame.
last_hash() { # ROM DEMO FRAMES
    local every=$3
    [ "$every" != 0 ] || every=1
    "$program" hash "$1" --demo "$2" --every "$every" 2>/dev/null | sed -n "s/^$3 //p"
}
table() {
    local demo rom frames
    echo '# core  demo  ROM  frames  last hash: see README.md'
    demos | while read -r demo; do
        rom=$(rom_of "$demo") frames=$(frames_of "$demo")
        if [ "$(field core "$demo")" = "$core" ]; then
            echo "$core $demo $rom $frames $(last_hash "$rom" "$demo" "$frames")"
        else
            awk -v demo="$demo" '$2 == demo' tests/demos/table
        fi
    done
}
rerecorded() {
    local c demo rom frames hash
    echo '# core  demo  last hash: what the demo of an older core version ends in on this one; see README.md'
    while read -r c demo rom frames hash; do
        [ "$c" = '#' ] || [ "$c" = "$core" ] || echo "$core $demo $(last_hash "$rom" "$demo" "$frames")"
    done <tests/demos/table
}
write() { # FILE COMMAND
    "$2" >"$scratch/new" && cp "$scratch/new" "$1"
}
freeze() {
    local bot=$OUT/bot name=tests/demos/whole$core
    [ ! -e "$name.rom" ] || { echo "$name.rom is there: core version $core is frozen, and stays as it is" >&2 &&
        return 1; }
    [ -x "$bot" ] || { echo "$bot is not built: make $bot" >&2 && return 1; }
    "$program" pack tests/demos/whole -o "$name.rom" &&
        "$bot" "$name.rom" "$name-run.demo" --frames 3200 --deaths 2 --seed 1 --quiet &&
        "$bot" "$name.rom" "$name-phase.demo" --stage king/b --frames 600 --seed 1 --quiet &&
        write tests/demos/table table && write tests/demos/rerecorded rerecorded
}
case ${1:-} in
--table) table; exit ;;
--rerecorded) rerecorded; exit ;;
--freeze) freeze; exit ;;
esac

# One line of the table, of this core version.
holds() { # CORE DEMO ROM FRAMES HASH
    local got line
    got=$(last_hash "$3" "$2" "$4")
    if [ "$got" != "$5" ]; then
        echo "core version $core: ${2##*/} ended in $got, the table says $5: the tick changed: raise CORE_VERSION" \
            "and say in docs/internals/determinism.md which tick differs"
        return 1
    fi
    line=$("$program" verify "$3" "$2") || { echo "$line" && return 1; }
    [ "$(field core "$2") $(frames_of "$2")" = "$1 $4" ] || { echo "$2 is not the demo the table lists" && return 1; }
}
# Of an older one: verify doubts it, and the ROM with its old @std runs to the demo's end all the same.
runs() { # CORE DEMO ROM FRAMES
    local line code got want again=$scratch/again.demo
    [ "$(field core "$2") $(frames_of "$2")" = "$1 $4" ] || { echo "$2 is not the demo the table lists" && return 1; }
    line=$("$program" verify "$3" "$2")
    code=$?
    echo "$line"
    [ $code -le 1 ] && grep -qF "(recorded with core version $1; this is version $core)" <<<"$line" || return 1
    cp "$2" "$again"
    line=$("$program" verify --rerecord "$3" "$again" 2>&1)
    code=$?
    echo "$line"
    [ $code -le 1 ] || { echo "a ROM of core version $1 does not run: what its scripts call has to stay" && return 1; }
    [ "$(field core "$again") $(field end "$again")" = "$core $4 fault 0" ] || { echo 'it did not get to its end' &&
        return 1; }
    "$program" verify "$3" "$again" | grep -q ": holds, $4 frames$" || { echo 'what was rerecorded does not hold' &&
        return 1; }
    got=$(last_hash "$3" "$again" "$4")
    want=$(awk -v demo="$2" -v core="$core" '$1 == core && $2 == demo { print $3 }' tests/demos/rerecorded)
    [ "$got" = "$want" ] && return
    echo "core version $core: ${2##*/} of core version $1 ended in $got," \
        "tests/demos/rerecorded says ${want:-nothing}: the tick changed: raise CORE_VERSION"
    return 1
}
# Every core version from the second on has a frozen ROM with all of @std, and a demo of it.
frozen() { # CORE TABLE
    local v
    for ((v = 2; v <= $1; v++)); do
        [ -f "tests/demos/whole$v.rom" ] && grep -q "^$v tests/demos/whole$v-run.demo tests/demos/whole$v.rom " \
            "$2" && continue
        echo "core version $v is not frozen: tests/cli/demos.sh --freeze"
        return 1
    done
}
listed() { # DEMO TABLE
    awk -v demo="$1" '$2 == demo { found = 1 } END { exit !found }' "$2" || { echo "$1 is not in tests/demos/table" &&
        return 1; }
}
# Every core version up to the program's has its line under "Core versions".
versions() { # PAGE CORE
    local v
    for ((v = 1; v <= $2; v++)); do
        sed -n '/^## Core versions/,/^## [^C]/p' "$1" | grep -Eq "^\| $v \| .+ \|$" ||
            { echo "docs/internals/determinism.md has no line for core version $v" && return 1; }
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

while read -r c demo rom frames hash; do
    [ "$c" != '#' ] || continue
    if [ "$c" = "$core" ]; then
        check "$demo holds" holds "$c" "$demo" "$rom" "$frames" "$hash"
    else
        check "$demo of core version $c runs" runs "$c" "$demo" "$rom" "$frames"
    fi
done <tests/demos/table
check 'every core version is frozen' frozen "$core" tests/demos/table
for demo in $(demos); do check "$demo is listed" listed "$demo" tests/demos/table; done
check 'every core version says what changed' versions docs/internals/determinism.md "$core"
read -r oldest newest \
    < <(sed -n 's/.*DEMO_FORMAT = \([0-9]*\).*/\1/p;s/.*DEMO_OLDEST_FORMAT = \([0-9]*\).*/\1/p' src/demo/demo.h |
    sort -n | xargs)
check 'a demo of every format' formats "$oldest" "$newest" tests/demos/*.demo
# Format 1 came with core version 1 and ended with it.
check 'no format of core version 2 is refused' [ "$oldest" = 2 ]

grep -v frozen-2 tests/demos/table >"$scratch/table"
detects 'a demo that is not listed' 'tests/demos/frozen-2.demo is not in tests/demos/table' listed \
    tests/demos/frozen-2.demo "$scratch/table"
detects 'a core version that is not frozen' "core version $((core + 1)) is not frozen" frozen $((core + 1)) \
    tests/demos/table
finish

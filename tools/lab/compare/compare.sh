#!/usr/bin/env bash
# compare.sh - make compare: what a game costs on this checkout's engine, beside another's.
#
#     OUT=build/release CC=cc FLAGS="..." LIBS="..." tools/lab/compare/compare.sh BASE [GAME [START]]
#
# BASE: a commit, which is built in build/compare/COMMIT, or another checkout's folder. GAME: a folder, roms/glasstide
# unless named; it is BASE's, so that it uses nothing that is new. START: a practice start, "one" unless named, "" for
# the game's title. Both engines run in turns: ROUNDS (9) times FRAMES (1200) frames, of which the median ratio counts.
# With valgrind there, instructions are counted too, which hardly differ from run to run; COUNT=none: they are not.
#
# TABLE=1: instead of a game's cost, the bench's scenes, tick and picture, a row each, on both engines in turns of a
# few frames; what is slower than LIMIT (1.03) is measured again with more rounds, and if it still is, said, and exit
# code 1. ROWS='^price (ring|fan)': only those whose names this fits. The scenes are BASE's roms/bench;
# BENCH=roms/bench: here's.
# shellcheck disable=SC2086 # flags and libraries are lists
set -eu
cd "$(dirname "$0")/../../.."
export LC_ALL=C
: "${OUT:=build/release}" "${CC:=cc}" "${FLAGS:=-std=c11 -O2 -D_DEFAULT_SOURCE $(pkg-config --cflags lua5.4)}"
: "${LIBS:=$(pkg-config --libs lua5.4) -lm -pthread}"
: "${ROUNDS:=9}" "${FRAMES:=1200}" "${COUNT:=valgrind}" "${TABLE:=}" "${ROWS:=}" "${LIMIT:=1.03}" "${BENCH:=}"
base=${1:-} game=${2:-roms/glasstide} start=${3-one}
fail() { echo "compare: $*" >&2; exit 2; }
[ -n "$base" ] || fail 'what with? make compare BASE=COMMIT, or the folder of another checkout'

if [ -d "$base" ]; then
    [ -f "$base/src/board/board.h" ] || fail "$base is no checkout of Curtain"
    tree=$base name=$base
else
    commit=$(git rev-parse --verify --quiet "$base^{commit}") || fail "\"$base\" is neither a commit nor a folder"
    name=$(git log -1 --format='%h %s' "$commit")
    tree=build/compare/$commit
    if [ ! -f "$tree/Makefile" ]; then
        mkdir -p "$tree.new"
        git archive "$commit" | tar x -C "$tree.new"
        mv "$tree.new" "$tree"
    fi
fi
[ -f "$tree/$game/rom.lua" ] || fail "$tree/$game is no game"

# weigher TREE: builds TREE's engine, and weigh with it; for a table rows.
weigher() {
    echo "compare: building $1" >&2
    make -C "$1" --no-print-directory -s -j2 CC="$CC" CONFIG="${OUT#build/}" "$OUT/curtain-bare" >&2 ||
        fail "$1 does not build"
    (
        cd "$1"
        mkdir -p tools/lab/compare
        if [ ! -e tools/lab/bench ]; then # a commit that had them elsewhere
            ln -s ../bench tools/lab/bench
            ln -s ../numbers.h tools/lab/numbers.h
        fi
        for own in names.h weigh.c rows.c; do
            [ "$1" = . ] || cmp -s "$here/$own" tools/lab/compare/$own || cp "$here/$own" tools/lab/compare/
        done
        grep -q MAX_PLAYERS src/base/pads.h || FLAGS="$FLAGS -DHAS_PADS"
        grep -q board_power_on src/board/board.h || FLAGS="$FLAGS -DHAS_BOARD_POWER"
        if [ -n "$TABLE" ]; then
            objects=$(find src fb -name '*.c' ! -name main.c ! -path 'src/lib/*' |
                sed "s|^\(.*\)\.c\$|$OUT/\1.o|")
            $CC $FLAGS tools/lab/compare/rows.c tools/lab/bench/scene.c $objects "$OUT/platform/null.o" \
                $(ls "$OUT"/platform/{stdio,posix,posix_process}.o 2>/dev/null) "$OUT"/gen/{std,no_rom}.o $LIBS \
                -o "$OUT/rows"
            exit
        fi
        # the layers below the program, also of commits in which they had other names
        below=$(ls -d fb src/{base,snd,sound,chips,entities,rom,machine,script,board} 2>/dev/null)
        objects=$(find $below -name '*.c' | sed "s|^\(.*\)\.c\$|$OUT/\1.o|")
        $CC $FLAGS tools/lab/compare/weigh.c $objects $LIBS -o "$OUT/weigh"
    ) || fail "weigh.c or rows.c does not build with $1: what it uses of the board is named otherwise there"
    plain=$("$1/$OUT/curtain-bare" help pack | grep -o -m 1 -e --plain) || true # older ones never compress
    [ -n "$TABLE" ] || "$1/$OUT/curtain-bare" pack "$tree/$game" $plain -o "$1/$OUT/weigh.rom" >/dev/null
}
here=$PWD/tools/lab/compare
weigher "$tree"
weigher .
if [ -n "$TABLE" ]; then
    echo "the bench's scenes of $name: that engine, and this checkout's"
    export ROUNDS ROWS LIMIT
    exec tools/lab/compare/turns.sh "$tree/$OUT/rows" "$OUT/rows" "${BENCH:-$tree/roms/bench}" "$tree/$game" "$start"
fi

# run TREE LOADS FRAMES
run() { "$1/$OUT/weigh" "$1/$OUT/weigh.rom" "$2" "$3" "$start"; }
figures=$(mktemp)
trap 'rm -f "$figures"' EXIT
for _ in $(seq "$ROUNDS"); do
    run "$tree" 5 "$FRAMES" | sed 's/^/base /'
    run . 5 "$FRAMES" | sed 's/^/here /'
done >"$figures"

# counted TREE LOADS FRAMES: its instructions.
counted() {
    "$COUNT" --tool=callgrind --callgrind-out-file=/dev/null \
        "$1/$OUT/weigh" "$1/$OUT/weigh.rom" "$2" "$3" "$start" 2>&1 >/dev/null |
        sed -n 's/,//g; s/.*refs: *//p'
}
few=$((FRAMES < 300 ? FRAMES : 300))
if command -v "$COUNT" >/dev/null 2>&1; then
    for side in base here; do
        if [ $side = base ]; then of=$tree; else of=.; fi
        one=$(counted "$of" 1 0) two=$(counted "$of" 2 0) played=$(counted "$of" 1 $few)
        echo "$side load_instructions $((two - one))"
        echo "$side frame_instructions $(((played - one) / few))"
    done >>"$figures"
fi

echo "$game of $name: that engine, and this checkout's"
awk -f tools/lab/compare/table.awk "$figures"

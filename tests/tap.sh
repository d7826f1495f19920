# shellcheck shell=bash
# tap.sh - sourced by the test scripts: TAP for shell, a folder that goes away, a small game.
#
#     . "$(dirname "$0")/../tap.sh"
#
# Afterwards the current folder is the repository's; $repo is its path, $OUT the build folder, $scratch an empty folder
# that goes away at the end. A script that runs curtain calls `sandbox` then. `finish` is the last line of a script.
set -u
repo=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$repo" || exit 2
OUT=${OUT:-build/release}
scratch=$(mktemp -d) || exit 2
trap clean_up EXIT
clean_up() {
    cd / || return
    [ ${#disks[@]} = 0 ] || umount "${disks[@]}" 2>/dev/null
    rm -rf "$scratch"
}
tap_n=0 tap_failed=0 disks=()

# sandbox: goes to $scratch, where nothing of the user's is seen; $curtain is the program, $OUT an absolute path.
sandbox() {
    OUT=$(cd "$OUT" && pwd) || exit 2
    curtain=$OUT/curtain-null
    [ -x "$curtain" ] || { echo "Bail out! $curtain is not built"; exit 2; }
    cd "$scratch" || exit 2
    export LC_ALL=C XDG_DATA_HOME=$scratch/data XDG_PICTURES_DIR=$scratch/pictures
}

ok() { tap_n=$((tap_n + 1)); echo "ok $tap_n - $1"; }
not_ok() { # NAME, then why, a line an argument
    tap_n=$((tap_n + 1)) tap_failed=1
    echo "not ok $tap_n - $1"
    shift
    printf '%s\n' "$@" | head -c 20000 | sed 's/^/# /'
}
same() { # NAME WANT GOT
    if [ "$2" = "$3" ]; then ok "$1"; else not_ok "$1" "want: $2" "got:  $3"; fi
}
check() { # NAME COMMAND...: passes when the command succeeds; what it says is shown when it does not
    local name=$1
    shift
    if "$@" >"$scratch/.said" 2>&1; then
        ok "$name"
    else
        not_ok "$name" "does not hold: $(head -c 100 <<<"$*")" "$(cat "$scratch/.said")"
    fi
}
refuse() { # NAME WORDS COMMAND...: passes when the command fails and says the words, so that a planted fault is found
    local name=$1 words=$2
    shift 2
    if "$@" >"$scratch/.said" 2>&1; then
        not_ok "$name" "does not fail: $*" "$(cat "$scratch/.said")"
    elif grep -qF -- "$words" "$scratch/.said"; then
        ok "$name"
    else
        not_ok "$name" "does not say \"$words\": $*" "$(cat "$scratch/.said")"
    fi
}
# expect_error NAME CODE TEXT COMMAND...: the exit code, and all that is printed on standard error; standard output is
# in the file out
expect_error() {
    local name=$1 want=$3$'\n'"exit $2" code
    shift 3
    "$@" >out 2>err </dev/null
    code=$?
    same "$name" "$want" "$(cat err)"$'\n'"exit $code"
}
input_error() { expect_error "$1" 2 "curtain: $2" "$curtain" "${@:3}"; }  # NAME TEXT ARGUMENT...
system_error() { expect_error "$1" 3 "curtain: $2" "$curtain" "${@:3}"; } # the same with the exit code of the system
# usage_errors CODE, standard input: lines "ARGUMENT...|TEXT": curtain with these arguments, separated by blanks, prints
# "curtain: TEXT" and nothing else on standard error
usage_errors() {
    local - words text
    set -f
    while IFS='|' read -r words text; do
        expect_error "${words:-no argument}" "$1" "curtain: $text" "$curtain" $words
    done
}
# small_disk DIR OPTIONS: a tmpfs, which is unmounted at the end; fails where there may be none
small_disk() {
    mkdir "$1" && mount -t tmpfs -o "$2" tmpfs "$1" 2>/dev/null || { echo "# no tmpfs at $1: not tested"; return 1; }
    disks+=("$PWD/$1")
}
files_differ() { ! cmp -s "$1" "$2"; }
# Is this the long form of a test? make test-all
long() { [ -n "${CURTAIN_LONG:-}" ]; }
detects() { # NAME WORDS COMMAND...: refuse, for a fault planted in what the test reads; in the long form only
    local name=$1
    shift
    ! long || refuse "planted: $name" "$@"
}
finish() {
    echo "1..$tap_n"
    exit $tap_failed
}

# build_player [ARGUMENT...]: ./player, curtain with a port that is played by a script (machine/port_keys.c), without
# window and clock; the arguments are for the compiler.
build_player() {
    ${CC:-cc} -std=c11 -O1 -o player "$@" "$repo/tests/machine/port_keys.c" \
        $(find "$OUT/src" -name '*.o') "$OUT"/fb/*.o "$OUT"/gen/{std,no_rom}.o \
        "$OUT"/platform/{stdio,posix,posix_process}.o $(pkg-config --libs lua5.4) -lm -pthread || exit 2
}
keys() { # N [WORD...]: lines for it: so many polls with these held
    local n=$1
    shift
    for _ in $(seq "$n"); do echo "$*"; done
}

# tree PATTERN...: the files of the repository (files.sh).
tree() { "$repo/tests/files.sh" "$@"; }

# game DIR: one of everything, 64 x 64, with a white 16 x 16 sheet; main.lua is standard input.
game() {
    mkdir -p "$1/art"
    cat >"$1/rom.lua" <<LUA
return {
  id = "probe", title = "Probe", screen = { w = 64, h = 64 },
  board = { bullets = 256, shots = 32, enemies = 32, sparks = 64, sprites = 16, motions = 16, tasks = 128, \
lua_kib = 1024, items = 128, lines = 8, lasers = 16, curve_points = 256, options = 8, bodies = true, pierce = true },
  sheets = { all = { file = "art/all.png" } },
  sprites = { dot = { sheet = "all", x = 0, y = 0, w = 8, h = 8 }, \
dart = { sheet = "all", x = 0, y = 0, w = 8, h = 4, rotations = 8 } },
  difficulties = { "easy", "normal", "hard" }, dip = { coins = { "free", "one" }, ships = { min = 1, max = 9 } },
  players = 2,
}
LUA
    python3 "$repo/tests/cli/png_make.py" "$1/art/all.png" 16 16 ffffff
    cat >"$1/main.lua"
    grep -q 'music\.' "$1/main.lua" || return 0
    mkdir -p "$1/music"
    sed -i 's|^  players = 2,|&\n  music = { tide = { file = "music/tide.mml" } },\n  sounds = SOUNDS,|
        s|SOUNDS|{ hit = { mml = "t200 @noise E0,60,0,10 o6 c8" } }|' "$1/rom.lua"
    printf 'A t133.25 @fm v12 o5 L l8 c8d8e8 "drop" t97 f4 e8\n' >"$1/music/tide.mml"
}

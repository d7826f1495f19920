# tap.sh - what the shell tests share: TAP lines, a folder that goes away, a small game.
#
#     . "$(dirname "$0")/../tap.sh"
#
# Afterwards: $curtain, the program of the build folder $OUT (seen from here or from the repository); $repo; $tmp, the
# working folder.
set -u
repo=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
: "${OUT:=build/release}"
[ -d "$OUT" ] || OUT=$repo/$OUT
OUT=$(cd "$OUT" && pwd) || exit 2
curtain=$OUT/curtain-null
[ -x "$curtain" ] || { echo "Bail out! $curtain is not built"; exit 2; }
tmp=$(mktemp -d) || exit 2
trap 'cd /; rm -rf "$tmp"' EXIT
cd "$tmp" || exit 2
export LC_ALL=C XDG_DATA_HOME=$tmp/data
tests=0 failed=0

ok() { tests=$((tests + 1)); echo "ok $tests - $1"; }
not_ok() { # NAME, then why, a line an argument
    tests=$((tests + 1)) failed=$((failed + 1))
    echo "not ok $tests - $1"
    shift
    printf '%s\n' "$@" | head -c 2000 | sed 's/^/# /'
}
same() { # NAME WANT GOT
    if [ "$2" = "$3" ]; then ok "$1"; else not_ok "$1" "want: $2" "got:  $3"; fi
}
holds() { # NAME COMMAND...
    local name=$1
    shift
    if "$@"; then ok "$name"; else not_ok "$name" "does not hold: $*"; fi
}
finish() {
    echo "1..$tests"
    exit $((failed > 0))
}

# game DIR: one of everything, 64 x 64, with a white 16 x 16 sheet; main.lua is standard input.
game() {
    mkdir -p "$1/art"
    cat >"$1/rom.lua" <<'LUA'
return {
  id = "probe", title = "Probe", screen = { w = 64, h = 64 },
  board = { bullets = 256, shots = 32, enemies = 32, sparks = 64, sprites = 16, motions = 16, tasks = 128, lua_kib = 1024 },
  sheets = { all = { file = "art/all.png" } },
  sprites = { dot = { sheet = "all", x = 0, y = 0, w = 8, h = 8 }, dart = { sheet = "all", x = 0, y = 0, w = 8, h = 4, rotations = 8 } },
  difficulties = { "easy", "normal", "hard" }, dip = { coins = { "free", "one" }, ships = { min = 1, max = 9 } },
  players = 2,
}
LUA
    python3 "$repo/tests/cli/png_make.py" "$1/art/all.png" 16 16 ffffff
    cat >"$1/main.lua"
}

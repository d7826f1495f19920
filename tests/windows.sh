#!/usr/bin/env bash
# windows.sh - curtain.exe under Wine, held to the program of this machine: demos, numbers, a list of commands byte for
# byte; and a window with real keys: pictures, paths, a folder that cannot be written, hot reload.
#
#     tests/windows.sh          TAP. `make windows` and `make` come first. Exit 1: something differs.
#     tests/windows.sh --clicks     double clicks alone
#
# Wine's own folder is build/windows/wine.
. "$(dirname "$0")/xserver.sh"
exe=$repo/build/windows/curtain.exe
native=$repo/build/curtain
into=$repo/build/windows
for needed in "$exe" "$native" /usr/lib/wine/wine64; do
    [ -x "$needed" ] || { not_ok "$needed is there: make windows, and tools/deps.sh windows"; finish; }
done
export WINEPREFIX=$into/wine WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml=' SDL_AUDIODRIVER=dummy
program=$repo/tests/windows/curtain # $exe under Wine
as_windows() { tr / '\\' <<<"Z:$1"; }
wine() { LC_ALL=C.UTF-8 /usr/lib/wine/wine64 "$@"; } # by the locale Wine reads arguments
trap 'kill -KILL $child $other $wm $xvfb 2>/dev/null; /usr/lib/wine/wineserver64 -k; clean_up' EXIT
[ -d "$WINEPREFIX" ] || "$program" version >/dev/null 2>&1 # the first start makes the folder, and says so
/usr/lib/wine/wineserver64 -p 2>/dev/null
short=
[ "${1:-}" != --short ] || short=yes # what needs no window
[ "${1:-}" != --clicks ] || { . "$repo/tests/windows/clicks.sh"; finish; }

# ---- the file ----
dump=$(x86_64-w64-mingw32-objdump -p "$exe")
dlls() { # those that every Windows has
    sed -n 's/^.*DLL Name: //p' <<<"$1" | tr '[:upper:]' '[:lower:]' | sort -u |
        grep -vxE '(advapi32|gdi32|imm32|kernel32|msvcrt|ole32|oleaut32|setupapi|shell32|user32|version|winmm)\.dll'
}
same 'it needs nothing but the libraries of Windows' '' "$(dlls "$dump")"
check 'it is loaded anywhere' grep -q DYNAMIC_BASE <<<"$dump"
check 'and its data is not run' grep -q NX_COMPAT <<<"$dump"
icons() { python3 - "$1" "$into/curtain.ico" <<'PY'
import struct, sys
exe, ico = (open(name, "rb").read() for name in sys.argv[1:])
count = struct.unpack("<H", ico[4:6])[0]
for i in range(count):
    size, at = struct.unpack("<II", ico[14 + 16 * i:22 + 16 * i])
    assert ico[at:at + size] in exe, "no image %d" % i
PY
}
check 'it has every size of its icon' icons "$exe"

# ---- the same machine ----
x86_64-w64-mingw32-gcc -std=gnu99 -O2 -D__USE_MINGW_ANSI_STDIO=1 -static "$repo/tests/windows/numbers.c" -o numbers.exe
gcc -std=gnu99 -O2 "$repo/tests/windows/numbers.c" -o numbers -lm
same 'numbers and their texts are those of Linux' "$(./numbers)" "$(wine numbers.exe | tr -d '\r')"
for game in "$repo"/roms/*/; do
    demos=("$game"demos/*.demo)
    [ -e "${demos[0]}" ] || continue
    same "$(basename "$game"): ${#demos[@]} demos are as on Linux" "$("$native" verify "$game" "${demos[@]}" | cksum)" \
        "$("$program" verify "$game" "${demos[@]}" | cksum)"
done

# ---- a list of commands, byte for byte ----
for side in linux windows; do
    mkdir -p $side/games
    cp -r "$repo"/roms/{glasstide,testcard,torture} "$repo"/examples/{moth,bulletml} $side/games/
    "$native" pack "$repo/examples/tape" -o $side/tape.rom
done
curtain() { # what the list calls so
    if [ "$side" = linux ]; then "$native" "$@"; else "$program" "$@"; fi
}
commands() { grep -v '^#' "$repo/tests/windows/commands"; }
runs() { # SIDE: what each prints, and its exit code, in SIDE.said
    side=$1
    mkdir -p "$scratch/$side.said"
    (
        cd "$scratch/$side" || exit 2
        # shellcheck disable=SC2030
        export XDG_DATA_HOME=$scratch/$side.user
        n=0
        while read -r line; do
            n=$((n + 1))
            eval "$line" >"$scratch/$side.said/$n.out" 2>"$scratch/$side.said/$n.err" </dev/null
            echo $? >"$scratch/$side.said/$n.code"
        done < <(commands)
    )
}
runs linux
runs windows
check "$(commands | wc -l) commands print the same bytes, and have the same exit code" diff -r linux.said windows.said
check 'and write the same files' diff -r linux windows

# ---- paths ----
deep=$(printf 'とても長いフォルダー-%.0s' 1 2 3)
long=$scratch/paths/ゲーム\ の\ フォルダー
mkdir -p "$long"
cp -r "$repo/examples/first" "$long/日本語 と 空白"
cd "$long" || exit 2
check 'a game in a folder of Japanese and blanks' "$program" check "日本語 と 空白"
same 'has the hash it has on Linux, by a path of Windows' "$("$native" hash '日本語 と 空白' --frames 60)" \
    "$("$program" hash '.\日本語 と 空白' --frames 60 --record '記録 一.demo')"
check 'its demo is where it was asked for' "$native" verify '日本語 と 空白' '記録 一.demo'
far=$(as_windows "$long")
for _ in 1 2 3 4; do far="$far\\$deep"; done
check 'a path of more than 260 characters' "$program" pack '日本語 と 空白' -o "$far\\card.rom"
check 'is written and read' "$program" list "$far\\card.rom"
cd "$scratch" || exit 2
# shellcheck disable=SC2031
export XDG_DATA_HOME="$scratch/ユーザー 一"
"$program" help config >guide
check 'the settings are in the folder of the user' grep -qF "ユーザー 一/curtain/curtain.conf" guide
XDG_DATA_HOME=$scratch/data
same 'without one, in that of Windows' C:/users"/$(id -un)/AppData/Roaming/curtain/curtain.conf" \
    "$(env -u XDG_DATA_HOME "$program" help config | sed -n 's/^ *\(.*curtain\.conf\)$/\1/p' | head -n 1)"

# ---- a folder that cannot be written ----
if small_disk locked size=4m; then
    mount -o remount,ro locked
    refuse 'a folder that cannot be written' 'locked/new.rom: cannot be written' \
        "$program" pack "$repo/roms/testcard" -o locked/new.rom
fi

# ---- an export ----
# The same players for both programs; here the program itself is one.
mkdir -p both/players
cp "$native" both/linux
cp "$exe" both/windows.exe
cp "$native" both/players/curtain-player-linux
cp "$exe" both/players/curtain-player.exe
cp "$exe" both/players/curtain.exe # for --keys
cp "$repo"/build/players/{player.html,curtain_libretro.so} both/players/ || not_ok 'make web, make library: the players'
both/linux export "$repo/examples/moth" --all -o there
wine both/windows.exe export "$repo/examples/moth" --all -o here
check 'exports of all kinds have the bytes of Linux' diff -r there here
"$program" export "$repo/examples/moth" >said 2>&1
check 'an export ends in .exe, and is the game' eval 'wine moth.exe version | head -n 1 | grep -q "(moth)"'
"$native" hash "$repo/examples/moth" --press fire --frames 300 --record moth.demo >moth.hash
both/linux export "$repo/examples/moth" --windows --keys -o keys.exe
check 'an exported program has the game, its icon and version' python3 "$repo/tests/cli/pe_read.py" keys.exe
check 'its demo holds' wine keys.exe verify "$repo/examples/moth" moth.demo
same 'and has the hashes of Linux' "$(cksum <moth.hash)" "$(wine keys.exe hash --press fire --frames 300 | cksum)"
# As signtool does: the certificate follows at a multiple of 8, and the header leads to it.
openssl req -x509 -newkey rsa:2048 -nodes -keyout key.pem -out cert.pem -days 2 -subj /CN=Author \
    -addext extendedKeyUsage=codeSigning 2>/dev/null
check 'it can be signed' osslsigncode sign -certs cert.pem -key key.pem -h sha256 -in moth.exe -out signed.exe
check 'the signature is good' osslsigncode verify -CAfile cert.pem signed.exe
cp signed.exe bad.exe
printf X | dd of=bad.exe bs=1 seek=$(($(stat -c %s moth.exe) - 9)) conv=notrunc 2>/dev/null
refuse 'a damaged game is refused' 'damaged' wine bad.exe version

[ -z "$short" ] || finish

# ---- a window ----
start_openbox
glass=$repo/roms/glasstide
mkdir -p data/curtain
plays() { start "$1" "$program" "${@:2}"; } # TITLE ARGUMENT...: in a window
press() { # KEY...: each is seen by a poll, however slow
    local key
    for key; do
        xdotool keydown "$key"
        wait_cpu 4
        xdotool keyup "$key"
        wait_cpu 4
    done
}
saved() { sed -n 's/^saved Z://p' err | tr -d '\r' | head -n 1; }
shows() { # FRAME.png: the window shows it at twice its size, but for the eight lines of words below
    screenshot rgb:got.rgb && convert "$1" -scale 200% -depth 8 rgb:want.rgb || return 1
    cmp -n $((480 * 624 * 3)) got.rgb want.rgb
}
last() { "$native" hash "$1" --demo "$2" | tail -n 1 | cut -d ' ' -f 1; } # GAME DEMO
if plays 'Glass Tide' play "$glass" --seed 0 --scale 2 --record keys.demo; then
    wait_cpu 100
    press Return
    wait_cpu 100
    press Return z z z z z z z z Left Right x # through the menus into the stage
    wait_cpu 40
    press p period F12
    check 'a screenshot' wait_until grep -q '^saved ' err
    check 'is where it is said to be' test -s "$(saved)"
    check 'the window shows it, to the last pixel' wait_until shows "$(saved)"
    stop
    check 'the demo holds on Linux' "$native" verify "$glass" keys.demo
    "$native" render "$glass" --demo keys.demo --frames "$(last "$glass" keys.demo)" -o shown >/dev/null
    check 'and ends in the picture that was seen' cmp "$(saved)" "$(echo shown/*.png)"
fi

# ---- one file, many programs ----
pids=
for _ in 1 2 3 4 5 6; do
    (for _ in 1 2 3; do "$program" pack "$repo/roms/testcard" -o same.rom || exit 1; done) >/dev/null 2>&1 &
    pids="$pids $!"
done
bad=0
for pid in $pids; do wait "$pid" || bad=1; done
same 'six that save one file at once' 0 $bad
check 'it is whole' "$program" list same.rom
check 'and nothing else is left' eval '! ls same.rom.*'

# ---- hot reload ----
game g <<'LUA'
local step = require 'step'
local x, dot = 0, sprite.put { sprite = 'dot', x = 0, y = 0 }
task.go(function()
  while true do
    x = x + step
    dot.x, dot.y = x // 30 % 240, 60
    wait(1)
  end
end)
LUA
echo 'return 1' >g/step.lua
title=$(sed -n 's/.*title = "\([^"]*\)".*/\1/p' g/rom.lua)
if plays "$title" play g --seed 5 --scale 1; then
    wait_cpu 20
    echo 'return 4' >new.lua
    check 'an editor of Windows may rename over it' wine cmd /c move /y new.lua 'g\step.lua'
    check 'which is read again' wait_until grep -q 'curtain: g: reloaded' err
    echo 'return = 3' >new.lua
    mv new.lua g/step.lua
    check 'a mistake is reported' wait_until grep -q 'reload failed: g: step.lua:1' err
    stop
fi

# ---- how it ends ----
if plays 'Glass Tide' play "$glass" --seed 1 --scale 1 --stage one --record broken-off.demo; then
    wait_cpu 20
    kill -INT $child
    check 'Ctrl+C ends it' wait_until has_exited
    wait $child
    same 'well' 0 $?
    kill_program
    check 'its run is saved' "$native" verify "$glass" broken-off.demo
fi

. "$repo/tests/windows/clicks.sh"
finish

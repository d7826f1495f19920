#!/usr/bin/env bash
# windows.sh - curtain.exe under Wine, held to the program of this machine: demos, numbers, a list of commands byte for
# byte; and a window with real keys: pictures, sound, paths, a folder that cannot be written, two instances, hot reload.
#
#     tests/windows.sh          TAP. `make windows` and `make` come first. Exit 1: something differs.
#     tests/windows.sh --clicks     double clicks alone
#
# Wine's own folder is build/windows/wine. The table of the commands is build/windows/commands.txt, and the pictures of
# the window that are there to be looked at are build/windows/*.png.
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
strings() { # FILE TEXT: which is there as UTF-16
    python3 -c 'import sys; sys.exit(sys.argv[2].encode("utf-16-le") not in open(sys.argv[1], "rb").read())' "$@"
}
check 'it has a version resource' strings "$exe" "$("$native" version | sed -n '1s/curtain \([^ ]*\) .*/\1/p')"
check 'it has a manifest that asks for fine pixels' grep -aq PerMonitorV2 "$exe"
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
room() { python3 - "$1" <<'PY'
import struct, sys
exe = open(sys.argv[1], "rb").read(4096)
pe = struct.unpack("<I", exe[60:64])[0]
sections, optional = struct.unpack("<H", exe[pe + 6:pe + 8])[0], struct.unpack("<H", exe[pe + 20:pe + 22])[0]
headers = struct.unpack("<I", exe[pe + 24 + 60:pe + 24 + 64])[0]
sys.exit(headers - (pe + 24 + optional + 40 * sections) < 40)
PY
}
check 'its header has room for the section of an export' room "$exe"

# ---- the same machine ----
x86_64-w64-mingw32-gcc -std=gnu99 -O2 -D__USE_MINGW_ANSI_STDIO=1 -static "$repo/tests/windows/numbers.c" -o numbers.exe
gcc -std=gnu99 -O2 "$repo/tests/windows/numbers.c" -o numbers -lm
numbers() { diff <(./numbers) <(wine "$1" | tr -d '\r'); }
check 'numbers and their texts are those of Linux' numbers numbers.exe
for game in "$repo"/roms/*/; do
    demos=("$game"demos/*.demo)
    [ -e "${demos[0]}" ] || continue
    check "$(basename "$game"): ${#demos[@]} demos hold" "$program" verify "$game" "${demos[@]}"
    same "$(basename "$game"): and say the same as on Linux" "$("$native" verify "$game" "${demos[@]}" | cksum)" \
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
runs() { # SIDE: out, err and code of each, in SIDE.said
    side=$1
    mkdir -p "$scratch/$side.said"
    (
        cd "$scratch/$side" || exit 2
        # shellcheck disable=SC2030,SC2031
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
n=0
{
    echo '| command | exit code | bytes printed | same |'
    echo '|---|---|---|---|'
    while read -r line; do
        n=$((n + 1))
        is=yes
        for of in out err code; do cmp -s linux.said/$n.$of windows.said/$n.$of || is=no; done
        echo "| \`${line//|/\\|}\` | $(cat linux.said/$n.code) | $(cat linux.said/$n.{out,err} | wc -c) | $is |"
    done < <(commands)
} >"$into/commands.txt"
alike() { # FOLDER FOLDER
    local n=0 bad=0 line
    while read -r line; do
        n=$((n + 1))
        for of in out err code; do
            cmp -s "$1.said/$n.$of" "$2.said/$n.$of" && continue
            echo "$line: $of"
            diff "$1.said/$n.$of" "$2.said/$n.$of" | head -n 6
            bad=1
        done
    done < <(commands)
    return $bad
}
check "$n commands print the same bytes, and have the same exit code" alike linux windows
check "and write the same files: $(find linux -type f | wc -l)" diff -r linux windows
sed 's/^/# /' "$into/commands.txt"

# ---- paths ----
card() { cksum < <(cd windows && "$@" --frames 60); }
same 'the sign between folders is / or \' "$(card "$native" hash games/testcard)" \
    "$(card "$program" hash 'games\testcard')"
deep=$(printf 'とても長いフォルダー-%.0s' 1 2 3)
long=$scratch/paths/ゲーム\ の\ フォルダー
mkdir -p "$long"
cp -r "$repo/examples/first" "$long/日本語 と 空白"
cd "$long" || exit 2
check 'a game in a folder of Japanese and blanks' "$program" check "日本語 と 空白"
"$program" hash '日本語 と 空白' --frames 60 --record '記録 一.demo' >ours
same 'has the hash it has on Linux' "$("$native" hash '日本語 と 空白' --frames 60 | cksum)" "$(cksum <ours)"
check 'its demo is where it was asked for' "$native" verify '日本語 と 空白' '記録 一.demo'
far=$(as_windows "$long")
for _ in 1 2 3 4; do far="$far\\$deep"; done
check 'a path of more than 260 characters' "$program" pack '日本語 と 空白' -o "$far\\card.rom"
packed=$(tr '\\' / <<<"${far#Z:}")/card.rom
check 'is written' test -s "$packed"
check 'and read' "$program" list "$far\\card.rom"
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
    echo old >locked/card.rom
    mount -o remount,ro locked
    refuse 'a folder that cannot be written' 'locked/new.rom: cannot be written' \
        "$program" pack "$repo/roms/testcard" -o locked/new.rom
    refuse 'a file in it too' 'cannot be written' "$program" palette "$repo/examples/first/art/palette.png" --bank 1 \
        -o locked/bank.gpl
    same 'which is as it was' old "$(cat locked/card.rom)"
fi

# ---- an export ----
# The same players for both programs; here the program itself is one.
mkdir -p both/players
cp "$native" both/linux
cp "$exe" both/windows.exe
cp "$native" both/players/curtain-player-linux
cp "$exe" both/players/curtain-player.exe
cp "$repo"/build/players/{player.html,curtain_libretro.so} both/players/ || not_ok 'make web, make library: the players'
"$program" export "$repo/examples/moth" >said 2>&1
check 'an export ends in .exe' test -s moth.exe
check 'and is the game' eval 'wine moth.exe version | head -n 1 | grep -q "(moth)"'
for kind in linux windows web libretro; do
    both/linux export "$repo/examples/moth" --$kind -o "there-$kind.so"
    wine both/windows.exe export "$repo/examples/moth" --$kind -o "here-$kind.so"
    check "--$kind: the bytes are those of Linux" cmp "there-$kind.so" "here-$kind.so"
done
both/linux export "$repo/examples/moth" --all -o there
wine both/windows.exe export "$repo/examples/moth" --all -o here
check '--all: so are those of the zip files' diff -r there here
check 'an exported program has the game, its icon and version' python3 "$repo/tests/cli/pe_read.py" here-windows.so
check 'its manifest is that of the program' \
    cmp "$repo/tools/windows/curtain.manifest" <(python3 "$repo/tests/cli/pe_read.py" here-windows.so 24 1)
"$native" hash "$repo/examples/moth" --press fire --frames 300 --record moth.demo >moth.hash
both/linux export "$repo/examples/moth" --windows --keys -o keys.exe
check 'its demo holds' wine keys.exe verify "$repo/examples/moth" moth.demo
same 'and has the hashes of Linux' "$(cksum <moth.hash)" "$(wine keys.exe hash --press fire --frames 300 | cksum)"
own_folder() (unset XDG_DATA_HOME; wine "$1" help config | sed -n 's,^ *\(.*\)/curtain\.conf$,\1,p' | head -n 1)
same 'its settings are in its own folder' C:/users"/$(id -un)/AppData/Roaming/curtain-moth" "$(own_folder moth.exe)"
# As signtool does: the certificate follows at a multiple of 8, and the header leads to it.
openssl req -x509 -newkey rsa:2048 -nodes -keyout key.pem -out cert.pem -days 2 -subj /CN=Author \
    -addext extendedKeyUsage=codeSigning 2>/dev/null
check 'it can be signed' osslsigncode sign -certs cert.pem -key key.pem -h sha256 -in moth.exe -out signed.exe
check 'the signature is good' osslsigncode verify -CAfile cert.pem signed.exe
check 'and it is the game' eval 'wine signed.exe version | head -n 1 | grep -q "(moth)"'
cp signed.exe bad.exe
printf X | dd of=bad.exe bs=1 seek=$(($(stat -c %s moth.exe) - 9)) conv=notrunc 2>/dev/null
detects 'a byte of the game is another' 'MISMATCH' osslsigncode verify -CAfile cert.pem bad.exe
refuse '... which the program sees, too' 'damaged' wine bad.exe version

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
look() { screenshot "png:$into/$1.png"; } # NAME: kept for people
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
    check 'a picture of the title' look title
    press Return z z z z z z z z Left Right x # through the menus into the stage
    wait_cpu 40
    check 'a picture of play' look play
    press p period F12
    check 'a screenshot' wait_until grep -q '^saved ' err
    check 'is where it is said to be' test -s "$(saved)"
    check 'the window shows it, to the last pixel' wait_until shows "$(saved)"
    stop
    check 'the demo holds on Linux' "$native" verify "$glass" keys.demo
    "$native" render "$glass" --demo keys.demo --frames "$(last "$glass" keys.demo)" -o shown >/dev/null
    check 'and ends in the picture that was seen' cmp "$(saved)" "$(echo shown/*.png)"
    "$native" hash "$glass" --seed 0 --frames "$(last "$glass" keys.demo)" | tail -n 1 >idle
    check 'keys were played: without them it ends otherwise' \
        test "$("$native" hash "$glass" --demo keys.demo | tail -n 1)" != "$(cat idle)"
fi
if plays 'Glass Tide' play "$glass" --seed 0 --scale 2 --stage nautilus/chambers --invincible; then
    xdotool keydown z
    wait_cpu 900
    check 'a picture of a boss' look boss
    xdotool keyup z
    press Escape
    wait_cpu 30
    check 'a picture of the pause' look pause
    press Down Down Return
    wait_cpu 30
    check 'a picture of the settings' look settings
    stop
fi

# ---- sound: what SDL's disk driver is given is what is rendered ----
printf '%s\n' 'away = go-on' 'resample = no' >data/curtain/curtain.conf
export SDL_DISKAUDIODELAY=20 # and the file has SDL's name for it: on Windows SDL 2.26 confuses two variables
played() { [ -f sdlaudio.raw ] && [ "$(wc -c <sdlaudio.raw)" -ge "$1" ]; } # BYTES: as many at least
if SDL_AUDIODRIVER=disk plays 'Glass Tide' play "$glass" --seed 3 --scale 1 --record sound.demo; then
    press Return z z z Left
    check 'it sounds' wait_until played 400000
    stop
    check 'its demo holds' "$native" verify "$glass" sound.demo
    "$native" render "$glass" --demo sound.demo --frames "$(last "$glass" sound.demo)" --wav want.wav >/dev/null
    heard() { python3 "$repo/tests/machine/played.py" same "$1" want.wav; }
    check 'what was played is what Linux renders' heard sdlaudio.raw
fi

# ---- a window that is moved, minimised, and left ----
rm -f data/curtain/curtain.conf
still() { screenshot rgb:one.rgb && sleep 1 && screenshot rgb:two.rgb && cmp -s one.rgb two.rgb; }
moves() { ! still; }
if plays 'Glass Tide' play "$glass" --seed 1 --scale 1 --stage one --record away.demo; then
    wait_cpu 20
    check 'it moves' wait_until moves
    for at in 300x200 40x60; do timeout 100 xdotool windowmove --sync "$win" ${at/x/ }; done
    check 'it moves, moved' wait_until moves
    xev -name another >/dev/null 2>&1 &
    other=$!
    another() { another=$(xdotool search --onlyvisible --name '^another$' 2>/dev/null) && [ -n "$another" ]; }
    check 'another window' wait_until another
    timeout 100 xdotool windowactivate --sync "$another"
    check 'without the keys it opens the menu' wait_until still
    timeout 100 xdotool windowactivate --sync "$win"
    press Return # the menu's first line
    check 'and goes on, the keys back' wait_until moves
    kill $other
    wait $other 2>/dev/null
    other=
    small=$win
    xdotool windowminimize "$small"
    sleep 1
    check 'minimised it is not seen' eval '! find_window'
    timeout 100 xdotool windowmap "$small" windowactivate "$small" 2>/dev/null
    check 'and seen again' wait_until find_window
    timeout 100 xdotool windowactivate --sync "$win"
    press Return z
    check 'it plays on' wait_until moves
    timeout 100 xdotool windowsize --sync "$win" 500 700
    check 'larger, too' wait_until moves
    stop
    check 'the demo holds' "$native" verify "$glass" away.demo
fi

# ---- two instances ----
if plays 'Glass Tide' play "$glass" --seed 1 --scale 1 --stage one; then
    first=$child
    "$program" play "$glass" --seed 2 --scale 1 --stage one >second.out 2>second.err &
    other=$!
    both() { [ "$(xdotool search --onlyvisible --name '^Glass Tide$' 2>/dev/null | wc -l)" = 2 ]; }
    check 'two instances at once' wait_until both
    wait_cpu 20
    kill -INT "$first" "$other"
    ended() { ! kill -0 "$first" 2>/dev/null && ! kill -0 "$other" 2>/dev/null; }
    check 'both end' wait_until ended
    kill -KILL "$other" 2>/dev/null
    other=
    kill_program
    same 'neither complains' '' "$(grep -h curtain: err second.err)"
    same 'and no half a file is left' '' "$(find data -name '*.tmp')"
fi
pids=
for _ in 1 2 3 4 5 6; do
    (for _ in 1 2 3; do "$program" pack "$repo/roms/testcard" -o same.rom || exit 1; done) >/dev/null 2>&1 &
    pids="$pids $!"
done
bad=0
for _ in 1 2 3 4 5 6 7 8; do
    [ ! -e same.rom ] || "$program" list same.rom >/dev/null 2>&1 || bad=1
done
for pid in $pids; do wait "$pid" || bad=1; done
same 'six that save one file at once: it is whole at all times' 0 $bad
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
    echo 'return 3' >new.lua
    mv new.lua g/step.lua
    reloads() { [ "$(grep -c 'curtain: g: reloaded' err)" -ge "$1" ]; }
    check 'a file that is replaced is read again' wait_until reloads 1
    echo 'return 4' >new.lua
    check 'an editor of Windows may rename over it' wine cmd /c move /y new.lua 'g\step.lua'
    check 'which is read again' wait_until reloads 2
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

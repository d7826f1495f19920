#!/usr/bin/env bash
# exported.sh - an exported game in a real (virtual) X server: its title and icon, the frames that `curtain render`
# makes, no developer's key unless it has --keys; and in a folder that has nothing but it and the libraries it is
# linked with. With CURTAIN_LONG=1 that folder is a bare Debian of debootstrap with only SDL2 and Lua.
. "$(dirname "$0")/../xserver.sh"
export SDL_AUDIODRIVER=dummy
null=$curtain curtain=$OUT/curtain

cp -r "$repo/examples/first" lanterns
sed -i 's/title = "First Light"/id = "lanterns", title = "Lanterns", icon = "ship"/' lanterns/rom.lua
"$curtain" export lanterns -o game || exit 2
"$curtain" export lanterns -o keys --keys || exit 2

# ---- title, icon, keys ----

icon() { xprop -id "$win" -notype _NET_WM_ICON 2>/dev/null | grep -o 'Icon ([^)]*)'; }
class() { xprop -id "$win" -notype WM_CLASS | sed 's/.*= //'; }
flags() { "$null" verify lanterns "$1" --json | jq -r '.flags[]'; }
pressed() { # KEY...
    local key
    for key; do
        xdotool keydown "$key"
        wait_cpu 3
        xdotool keyup "$key"
        wait_cpu 3
    done
}
if start Lanterns ./game --scale 2 --record game.demo; then
    same 'its window has its icon' 'Icon (72 x 72)' "$(wait_until icon >/dev/null && icon)"
    same 'and its class is that of the file' '"game", "game"' "$(class)"
    pressed period comma slash BackSpace b grave F5 h
    stop
    same 'none of the keys that make a run no run' '' "$(flags game.demo)"
fi
if start Lanterns ./keys --scale 2 --record keys.demo; then
    pressed period
    stop
    same 'with --keys they are there' assisted "$(flags keys.demo)"
fi

# ---- alone ----

bare_folder() { # ROOT: what the loader takes, and SDL, which the program opens; a window's title needs X's locales
    local file sdl
    sdl=$(realpath -s "$(cc -print-file-name=libSDL2-2.0.so.0)")
    for file in "$sdl" $( (ldd game; ldd "$sdl") | grep -oE '/[^ ]+' | sort -u); do
        mkdir -p "$1/${file%/*}" && cp -L "$file" "$1/$file" || return
    done
    mkdir -p "$1/usr/share/X11" && cp -r /usr/share/X11/locale "$1/usr/share/X11"
}
bare_debian() { # ROOT: of Debian's packages
    command -v debootstrap >/dev/null || { echo 'debootstrap is not installed'; return 1; }
    debootstrap --variant=minbase --include=libsdl2-2.0-0,liblua5.4-0 \
        "$(. /etc/os-release && echo "$VERSION_CODENAME")" "$1" >"$1.log" 2>&1 || { tail "$1.log"; return 1; }
}
# alone WHAT ROOT: the exported program runs there, in a window, and plays a demo to its end. Nothing of ours is in its
# environment but the display; there is no /proc.
alone() {
    local what=$1 root=$2 inside=(chroot "$2" /usr/bin/env -i HOME=/home DISPLAY="$DISPLAY" SDL_AUDIODRIVER=dummy)
    [ "$(id -u)" = 0 ] || inside=(unshare -r "${inside[@]}")
    mkdir -p "$root/usr/bin" "$root/home" "$root/tmp/.X11-unix"
    cp -L game "$root/" && cp -L /usr/bin/env "$root/usr/bin/"
    ln "/tmp/.X11-unix/X${DISPLAY#:}" "$root/tmp/.X11-unix/" 2>/dev/null
    "$null" hash lanterns --press fire --frames 60 --record "$root/run.demo" >/dev/null
    same "$what: it says what it is" 'Lanterns 1 (lanterns)' "$("${inside[@]}" /game version 2>&1 | head -1)"
    check "$what: it plays a demo to its end" "${inside[@]}" /game --demo /run.demo --mute
    "${inside[@]}" /game --scale 2 >"$scratch/out" 2>"$scratch/err" &
    child=$!
    check "$what: its window has a picture" wait_until pictures
    same "$what: and nothing to complain of" '' "$(cat "$scratch/err")"
    kill_program
}
pictures() { # on the screen, more colours than black and one
    xwd -silent -root -out "$scratch/seen.xwd" && convert "xwd:$scratch/seen.xwd" "$scratch/seen.png" &&
        [ "$(identify -format %k "$scratch/seen.png")" -gt 3 ]
}
mkdir alone
check 'a folder with the libraries alone' bare_folder alone
alone 'libraries alone' "$PWD/alone"
if [ "${CURTAIN_LONG:-}" = 1 ]; then
    mkdir debian
    check 'a bare Debian' bare_debian "$PWD/debian"
    alone 'a bare Debian' "$PWD/debian"
fi
finish

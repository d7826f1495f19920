#!/usr/bin/env bash
# exported.sh - an exported game in a real (virtual) X server: its title and icon, the frames that `curtain render`
# makes, no developer's key unless it has --keys; and in a folder that has nothing but it and the libraries it is
# linked with. tests/players.sh runs exported games in bare roots of Debian.
. "$(dirname "$0")/../xserver.sh"
export SDL_AUDIODRIVER=dummy
null=$curtain curtain=$OUT/curtain

cp -r "$repo/examples/first" lanterns
sed -i 's/title = "First Light"/id = "lanterns", title = "Lanterns", icon = "ship"/' lanterns/rom.lua
"$curtain" export lanterns -o game || exit 2
"$curtain" export lanterns -o keys --keys || exit 2

# ---- title, icon, keys ----

icon() { xprop -id "$win" -notype _NET_WM_ICON 2>/dev/null | grep -q 'Icon (72 x 72)'; }
flags() { "$null" verify lanterns run.demo --json | jq -r '.flags[]'; }
pressed() { # KEY...
    local key
    for key; do
        xdotool keydown "$key"
        wait_cpu 3
        xdotool keyup "$key"
        wait_cpu 3
    done
}
if start Lanterns ./game --scale 2 --record run.demo; then
    check 'its window has its icon' wait_until icon
    same 'and its class is that of the file' '"game", "game"' "$(xprop -id "$win" -notype WM_CLASS | sed 's/.*= //')"
    pressed period comma slash BackSpace b grave F5 h
    stop
    same 'no key of authors works' '' "$(flags)"
fi
if start Lanterns ./keys --scale 2 --record run.demo; then
    pressed period
    stop
    same 'with --keys they do' assisted "$(flags)"
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
# alone ROOT: the exported program runs there, in a window, and plays a demo to its end. Nothing of ours is in its
# environment but the display; there is no /proc.
alone() {
    local root=$1 inside=(chroot "$1" /usr/bin/env -i HOME=/home DISPLAY="$DISPLAY" SDL_AUDIODRIVER=dummy)
    [ "$(id -u)" = 0 ] || inside=(unshare -r "${inside[@]}")
    mkdir -p "$root/usr/bin" "$root/home" "$root/tmp/.X11-unix"
    cp -L game "$root/" && cp -L /usr/bin/env "$root/usr/bin/"
    ln "/tmp/.X11-unix/X${DISPLAY#:}" "$root/tmp/.X11-unix/" 2>/dev/null
    "$null" hash lanterns --press fire --frames 60 --record "$root/run.demo" >/dev/null
    check "$root: it plays a demo to its end" "${inside[@]}" /game --demo /run.demo --mute
    start Lanterns "${inside[@]}" /game --scale 2 || return
    same "$root: its window has no complaint" '' "$(cat err)"
    kill_program
}
mkdir alone
check 'a folder with the libraries alone' bare_folder alone
alone alone
finish

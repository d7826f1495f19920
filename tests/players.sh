#!/usr/bin/env bash
# players.sh - the Linux programs of make players on other machines: which libraries they need; and in a bare root of
# every Debian release that the mirror has, they play a demo with the hashes of this machine, say what to install
# when SDL2 is missing, and open a window when it is installed.
#
#     tests/players.sh [RELEASE...]     TAP. Exit 1: something differs. Needs root, and what `make players` builds.
#
# The table of the releases is build/linux/releases.
. "$(dirname "$0")/tap.sh"
sandbox
native=$curtain
players=$repo/build/players
table=$repo/build/linux/releases
root=$repo/build/chroot/test
game=$repo/roms/glasstide demo=$repo/roms/glasstide/demos/attract.demo
trap 'cd /; rm -rf "$scratch" "$root" "$root.new"' EXIT
for file in "$players"/{curtain-player-linux,curtain-linux,curtain_libretro.so}; do
    [ -x "$file" ] || { not_ok "$file is there: make players"; finish; }
done
inside() { "$repo/tools/chroot.sh" run "$root" "$@"; }
glibc_of() { # ROOT: such as 2.31
    root=$1 inside getconf GNU_LIBC_VERSION | cut -d ' ' -f 2
}

# ---- the files ----
needs() { # FILE GLIBC: at most that, and nothing but the C library
    local other newest
    other=$(objdump -p "$1" | awk '$1 == "NEEDED" { print $2 }' | grep -vxE 'lib(c|m)\.so\.6|lib(dl|pthread)\.so\.[02]')
    newest=$(objdump -T "$1" | grep -oP 'GLIBC_\K[0-9.]+' | sort -V | tail -n 1)
    [ -z "$other" ] || echo "needs $other"
    [ "$(printf '%s\n' "$newest" "$2" | sort -V | tail -n 1)" = "$2" ] || { echo "needs glibc $newest"; return 1; }
    [ -z "$other" ] && [ -n "$newest" ]
}
oldest=$(glibc_of "$repo/build/chroot/compiler")
for file in curtain-player-linux curtain-linux curtain_libretro.so; do
    check "$file needs nothing but glibc $oldest" needs "$players/$file" "$oldest"
done

# ---- what is compared ----
"$native" pack "$game" -o game.rom
"$native" hash "$game" --demo "$demo" --every 600 >hashes
"$native" render "$game" --demo "$demo" --frames 600 -o pictures >/dev/null
"$native" hash "$repo/examples/first" --press fire --frames 90 --record short.demo >/dev/null
"$players/curtain-linux" export "$repo/examples/first" --linux -o first
[ -s hashes ] && [ -x first ] || { not_ok 'this machine plays the demo, and exports a game'; finish; }

# ---- in each release ----
missing='SDL 2.0.10 or later is required; install the package libsdl2-2.0-0 (Debian, Ubuntu), SDL2'
missing+=' (Fedora) or sdl2 (Arch, Homebrew)'
run_here() { inside env -C /game SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy HOME=/game "$@"; }
plays() { # the exported game, its demo to the end
    run_here ./first --demo short.demo --mute
}
says_missing() {
    plays >"$scratch/out" 2>&1
    [ $? = 3 ] || { echo "exit code is not 3"; return 1; }
    [ "$(sed -n '1s/^[^:]*: //p' "$scratch/out")" = "$missing" ] || { cat "$scratch/out"; return 1; }
}
same_hashes() { # DEMO
    run_here ./curtain-linux hash game.rom --demo "$1" --every 600 | diff hashes -
}
same_picture() {
    run_here ./curtain-linux render game.rom --demo attract.demo --frames 600 -o pictures >/dev/null &&
        diff -r pictures "$root/game/pictures"
}
loads() { # FILE: every symbol of a library is there
    run_here LD_BIND_NOW=1 "LD_PRELOAD=$1" true 2>"$scratch/err"
    cat "$scratch/err"
    [ ! -s "$scratch/err" ]
}
release() { # NAME
    local name=$1 sdl glibc failed=$tap_failed
    tap_failed=0
    rm -rf "$root"
    check "$name: a bare root" "$repo/tools/chroot.sh" make "$name" "$root"
    [ -d "$root" ] || return
    mkdir "$root/game"
    cp "$players"/curtain{-linux,_libretro.so} first game.rom "$demo" short.demo "$root/game/"
    glibc=$(glibc_of "$root")
    check "$name: with the same hashes" same_hashes attract.demo
    check "$name: and the same picture" same_picture
    check "$name: every symbol of the libretro core is there" loads ./curtain_libretro.so
    check "$name: without SDL2 it says what to install" says_missing
    check "$name: SDL2 can be installed" "$repo/tools/chroot.sh" install "$root" libsdl2-2.0-0
    sdl=$(run_here ./curtain-linux version | sed -n 's/^platform SDL //p')
    check "$name: the game plays in a window, with SDL $sdl" plays
    echo "| $name | $glibc | $sdl | $([ $tap_failed = 0 ] && echo yes || echo '**no**') |" >>"$table"
    tap_failed=$((tap_failed | failed))
}
{
    echo '| release | glibc | SDL2 | passed |'
    echo '|---|---|---|---|'
} >"$table"
releases=${*:-$("$repo/tools/chroot.sh" releases)}
for name in $releases; do release "$name"; done
check 'the mirror has releases' [ -n "$releases" ]
sed 's/^/# /' "$table"
finish

#!/bin/sh
# Installs what is missing from Debian's packages; says nothing when all is there.
#
#     tools/deps.sh [--say] [null] [play] [test] [docs] [ports] [fuzz] [all] [bench] [bulletml] [cross] [web]
#     [firefox] [windows] [players]
#
# null: what curtain-null is built with; play: that, and SDL2; test: also the libraries with which curtain packs OGG,
# FLAC and modules (it opens them when it needs them, and is built the same without); all: what only make test-all
# needs; ports: RetroArch, that the libretro core is tested in; bulletml: libbulletml, and the games whose documents
# are run beside it; web: what a page is built with, and tested in; firefox: where it is tested too; windows: the cross
# compiler for Windows, and Wine, which runs its programs here; players: what makes the Debian roots in which programs
# for other machines are compiled and tested. Without arguments: play, test, fuzz and bench. With --say it installs
# nothing: it says, in one line to paste, what is missing, and exits with 3. On macOS, tools/macos/deps.sh does the
# same.
set -eu
[ "$(uname -s)" != Darwin ] || exec "$(dirname "$0")/macos/deps.sh" "$@"
say=""
if [ "${1:-}" = --say ]; then
    say=yes
    shift
fi
[ $# -gt 0 ] || set -- play test fuzz bench

missing=""
have() { command -v "$1" >/dev/null 2>&1; }
header() { [ -e "/usr/include/$1" ]; }
shared() { # NAME: a shared library that curtain opens; without a compiler it is not known, so it is asked for
    have cc && [ "$(cc -print-file-name="$1")" != "$1" ]
}
library() { # NAME HEADER: the Makefile asks pkg-config for it
    if have pkg-config; then pkg-config --exists "$1"; else header "$2"; fi
}
need() { # PACKAGE...: these are missing
    missing="$missing $*"
}
pages() { # Python's own, or the system's, has what tools/docs/docs.py reads and colours pages with
    local python
    for python in python3 /usr/bin/python3; do
        if "$python" -c 'import markdown_it, pygments' 2>/dev/null; then return; fi
    done
    need python3-markdown-it python3-pygments
}

for what; do
    case $what in
    null | play)
        have cc || need gcc
        header stdio.h || need libc6-dev
        have pkg-config || need pkg-config
        library lua5.4 lua5.4/lua.h || need liblua5.4-dev
        [ "$what" = null ] || library sdl2 SDL2/SDL.h || need libsdl2-dev
        header stb/stb_image.h || need libstb-dev
        [ -n "$say" ] || [ -e /usr/share/fonts/truetype/misaki/misaki_gothic.ttf ] || need fonts-misaki
        [ -n "$say" ] || [ -e /usr/share/fonts/X11/misc/f12.pcf.gz ] || need xfonts-efont-unicode
        [ -n "$say" ] || have pcf2bdf || need pcf2bdf
        ;;
    test)
        header cmocka.h || need libcmocka-dev
        shared libsndfile.so.1 || need libsndfile1
        shared libopenmpt.so.0 || need libopenmpt0
        header libfixmath/fix16.h || need libfixmath-dev
        header mpfr.h || need libmpfr-dev
        have luac5.4 || need lua5.4
        have luacheck || need lua-check
        pages
        python3 -c 'import ctypes' 2>/dev/null || need python3
        python3 -c 'import yaml' 2>/dev/null || need python3-yaml
        have clang-format || need clang-format
        have git || need git
        have nm || need binutils
        have jq || need jq
        have unzip || need unzip
        have pgrep || need procps
        have clang || need clang
        have Xvfb || need xvfb
        have xdotool || need xdotool
        have setxkbmap || need x11-xkb-utils
        have xwd || need x11-apps
        have xprop || need x11-utils
        have openbox || need openbox
        have identify || need imagemagick
        [ -e /usr/share/i18n/locales/de_DE ] || need locales
        have desktop-file-validate || need desktop-file-utils
        have update-mime-database || need shared-mime-info
        have gio || need libglib2.0-bin
        have appstreamcli || need appstream
        have mandoc || need mandoc
        have pcf2bdf || need pcf2bdf
        [ -e /usr/share/fonts/X11/misc/f12.pcf.gz ] || need xfonts-efont-unicode
        ;;
    docs) pages ;;
    ports)
        have retroarch || need retroarch
        have python3 || need python3
        have Xvfb || need xvfb
        have identify || need imagemagick
        ;;
    fuzz)
        have clang || need clang
        header cmocka.h || need libcmocka-dev
        shared libsndfile.so.1 || need libsndfile1
        shared libopenmpt.so.0 || need libopenmpt0
        ls /usr/lib/llvm-*/lib/clang/*/lib/linux/libclang_rt.fuzzer-* >/dev/null 2>&1 || need libclang-rt-14-dev
        ;;
    all)
        ls /usr/lib/llvm-*/lib/clang/*/lib/linux/libclang_rt.msan-* >/dev/null 2>&1 || need libclang-rt-14-dev
        have valgrind || need valgrind
        have cppcheck || need cppcheck
        have chromium || need chromium
        have chromedriver || need chromium-driver
        have debootstrap || need debootstrap
        ;;
    bench)
        header libfixmath/fix16.h || need libfixmath-dev
        have objcopy || need binutils
        have xz || need xz-utils
        ;;
    bulletml)
        have c++ || need g++
        header bulletml/bulletmlrunner.h || need libbulletml-dev
        [ -e /usr/share/games/mu-cade/barrage ] || need mu-cade-data
        [ -e /usr/share/games/noiz2sa/boss ] || need noiz2sa-data
        [ -e /usr/share/games/parsec47/large ] || need parsec47-data
        [ -e /usr/share/games/rrootage/normal ] || need rrootage-data
        [ -e /usr/share/games/torus-trooper/barrage ] || need torus-trooper-data
        [ -e /usr/share/games/tumiki-fighters/barrage ] || need tumiki-fighters-data
        ;;
    cross)
        have aarch64-linux-gnu-gcc || need gcc-aarch64-linux-gnu
        have arm-linux-gnueabihf-gcc || need gcc-arm-linux-gnueabihf
        have i686-linux-gnu-gcc || need gcc-i686-linux-gnu
        have s390x-linux-gnu-gcc || need gcc-s390x-linux-gnu
        [ -e /usr/aarch64-linux-gnu/include/stdio.h ] || need libc6-dev-arm64-cross
        [ -e /usr/arm-linux-gnueabihf/include/stdio.h ] || need libc6-dev-armhf-cross
        [ -e /usr/i686-linux-gnu/include/stdio.h ] || need libc6-dev-i386-cross
        [ -e /usr/s390x-linux-gnu/include/stdio.h ] || need libc6-dev-s390x-cross
        have qemu-s390x-static || need qemu-user-static
        have clang || need clang
        have wasm-ld || need lld
        header wasm32-wasi/stdio.h || need wasi-libc
        ls /usr/lib/llvm-*/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a >/dev/null 2>&1 ||
            need libclang-rt-14-dev-wasm32
        have node || need nodejs
        have dpkg-source || need dpkg-dev
        have xz || need xz-utils
        have file || need file
        have git || need git
        ;;
    web)
        have clang || need clang
        have wasm-ld || need lld
        have zopfli || need zopfli
        header wasm32-wasi/stdio.h || need wasi-libc
        ls /usr/lib/llvm-*/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a >/dev/null 2>&1 ||
            need libclang-rt-14-dev-wasm32
        have dpkg-source || need dpkg-dev
        have xz || need xz-utils
        have node || need nodejs
        have chromium || need chromium
        have identify || need imagemagick
        ;;
    firefox)
        have firefox-esr || need firefox-esr
        ;;
    windows)
        have x86_64-w64-mingw32-gcc || need gcc-mingw-w64-x86-64
        [ -e /usr/lib/wine/wine64 ] || need wine64
        have osslsigncode || need osslsigncode
        have openssl || need openssl
        have dpkg-source || need dpkg-dev
        have xz || need xz-utils
        have python3 || need python3
        ;;
    players)
        have debootstrap || need debootstrap
        [ -e /usr/share/distro-info/debian.csv ] || need distro-info-data
        have dpkg-source || need dpkg-dev
        have xz || need xz-utils
        ;;
    *)
        echo "tools/deps.sh: \"$what\" is none of null, play, test, docs, ports, fuzz, all, bench, bulletml," \
            "cross, web, firefox, windows, players" >&2
        exit 2
        ;;
    esac
done
[ -n "$missing" ] || exit 0

if ! have apt-get; then
    echo "curtain: please install the equivalents of these Debian packages:$missing" >&2
    exit 3
fi
root=""
[ "$(id -u)" = 0 ] || root=sudo
if [ "$say" ]; then
    echo "curtain: something is missing; this installs it: ${root:+sudo }apt-get install$missing" >&2
    exit 3
fi
[ -z "$root" ] || have sudo || { echo "curtain: please run as root: apt-get install$missing" >&2; exit 3; }
echo "curtain: installing$missing"
$root apt-get update -qq
# shellcheck disable=SC2086
$root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null

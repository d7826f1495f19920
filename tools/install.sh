#!/bin/sh
# install.sh - puts what make built, and what belongs to it, below $DESTDIR$PREFIX, or takes it away again.
#
#     DESTDIR=... PREFIX=/usr/local tools/install.sh install|uninstall
#
# One list serves both. What others have put into the folders stays, and so do folders that are not Curtain's own. The
# documents as one file are there after `make docs` only, the library after `make library`, the players that exports are
# copies of after `make players`, or `make web` for browsers alone.
set -eu
cd "$(dirname "$0")/.."
root=${DESTDIR:-}${PREFIX:-/usr/local}
bin=bin man=share/man/man1 doc=share/doc/curtain data=share/curtain

# MODE FILE TARGET, a line each, the target below the prefix. No name has a blank.
list() {
    echo "755 build/curtain $bin/curtain"
    echo "755 build/curtain-player $bin/curtain-player"
    echo "755 build/curtain-null $bin/curtain-null"
    echo "644 build/curtain.1 $man/curtain.1"
    echo "644 build/curtain-null.1 $man/curtain-null.1"
    echo "644 share/curtain.desktop share/applications/curtain.desktop"
    echo "644 share/curtain-mime.xml share/mime/packages/curtain.xml"
    echo "644 share/org.curtain.Curtain.metainfo.xml share/metainfo/org.curtain.Curtain.metainfo.xml"
    for size in 48 128 256; do
        echo "644 share/icons/$size.png share/icons/hicolor/${size}x$size/apps/curtain.png"
    done
    find README.md CHANGELOG.md CONTRIBUTING.md LICENSE docs -type f | sort | sed "s,.*,644 & $doc/&,"
    echo "644 build/curtain.html $doc/curtain.html"
    find examples roms -type f ! -path 'roms/*/source/*' | sort | sed "s,.*,644 & $data/&,"
}

# What make library made; only then is it installed.
list_library() {
    echo "644 src/lib/curtain.h include/curtain.h"
    echo "644 build/curtain.pc lib/pkgconfig/curtain.pc"
    echo "644 build/libcurtain.a lib/libcurtain.a"
    echo "755 build/libcurtain.so lib/libcurtain.so.1"
    echo "755 build/curtain_libretro.so lib/libretro/curtain_libretro.so"
    echo "644 platform/libretro/curtain_libretro.info share/libretro/info/curtain_libretro.info"
}

# Those that make players made, make web or make library.
list_players() {
    for player in curtain-player-linux curtain-linux curtain-player.exe curtain.exe curtain_libretro.so player.html; do
        echo "755 build/players/$player $data/players/$player"
    done
}

# What desktops look up is made anew: here, and not where a package is made, whose installation does it.
look_up() {
    [ -z "${DESTDIR:-}" ] || return 0
    [ ! -d "$root/share/mime" ] || ! command -v update-mime-database >/dev/null ||
        update-mime-database "$root/share/mime"
    [ ! -d "$root/share/applications" ] || ! command -v update-desktop-database >/dev/null ||
        update-desktop-database "$root/share/applications"
}

case ${1:-} in
install)
    {
        list
        [ ! -e build/curtain_libretro.so ] || list_library
        list_players
    } | while read -r mode file target; do
        case $file in build/curtain.html | build/players/*) [ -e "$file" ] || continue ;; esac
        install -d "$root/${target%/*}"
        install -m "$mode" "$file" "$root/$target"
    done
    pc=$root/lib/pkgconfig/curtain.pc
    [ ! -e build/curtain_libretro.so ] || [ ! -e "$pc" ] ||
        sed "s,^prefix=.*,prefix=${PREFIX:-/usr/local}," build/curtain.pc >"$pc"
    [ ! -e build/curtain_libretro.so ] || ln -sf libcurtain.so.1 "$root/lib/libcurtain.so"
    look_up
    ;;
uninstall)
    {
        list
        list_library
        list_players
    } | while read -r mode file target; do
        rm -f "$root/$target"
    done
    rm -f "$root/lib/libcurtain.so"
    for own in "$root/$doc" "$root/$data"; do
        [ ! -d "$own" ] || find "$own" -depth -type d -empty -delete
    done
    look_up
    ;;
*)
    echo "tools/install.sh: expected install or uninstall, got \"${1:-}\"" >&2
    exit 2
    ;;
esac

#!/usr/bin/env bash
# libraries.sh - builds SDL2 for Windows from Debian's source package, below build/windows.
#
#     tools/windows/libraries.sh
#
# Each part is built once: its folder in build/windows/lib appears when it is complete, so an interrupted build resumes
# at the part that was interrupted. A failed part prints the end of its log, build/windows/NAME.log.
set -eu
cd "$(dirname "$0")/../.."
suite=bookworm # SDL 2.26.5
host=x86_64-w64-mingw32
root=$PWD/build/windows

# part NAME PACKAGE: runs build_NAME SOURCE PREFIX, unless build/windows/lib/NAME exists
part() {
    local name=$1 package=$2 source=$root/source/$1 prefix=$root/lib/$1 log=$root/$1.log
    [ ! -d "$prefix" ] || return 0
    echo "  BUILD $package for Windows"
    tools/source.sh "$package" "$suite" "$source"
    rm -rf "$prefix.new"
    mkdir -p "$prefix.new"
    if ! (set -e; "build_$name" "$source" "$prefix.new") >"$log" 2>&1 </dev/null; then
        tail -n 20 "$log" >&2
        echo "tools/windows/libraries.sh: $package does not build; log: $log" >&2
        exit 1
    fi
    mv "$prefix.new" "$prefix"
}

# configure writes the prefix into no file that is used: the Makefile names folders itself.
build_sdl2() {
    mkdir -p "$root/obj/sdl2"
    cd "$root/obj/sdl2"
    [ -f Makefile ] || "$1/configure" --host=$host --prefix=/ --disable-shared --enable-static
    make -j2
    make DESTDIR="$2" install
    [ -s "$2/lib/libSDL2.a" ]
}

part sdl2 libsdl2

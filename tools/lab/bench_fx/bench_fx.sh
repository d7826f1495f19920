#!/bin/sh
# Curtain's arithmetic against libfixmath's: against Debian's build of it, and against its source built with the flags
# Curtain has, as it is, without its caches, and with its table of sines. The source is fetched from where apt gets
# packages, and stays in the build folder; when it cannot be had, Debian's build is compared alone.
#
#     OUT=build/release CC=cc FLAGS="..." LIBS="..." tools/lab/bench_fx/bench_fx.sh [--build] OBJECT...
#
# --build: fetches nothing and measures nothing; only builds the program, with Debian's build of libfixmath.
# OBJECT: the board's objects but for trig.o, and those of the measuring program.
# shellcheck disable=SC2086 # flags and libraries are lists
set -eu
cd "$(dirname "$0")/../../.."
: "${OUT:=build/release}" "${CC:=cc}" "${FLAGS:=-std=c11 -fwrapv -ffp-contract=off -O2}"
FLAGS="$FLAGS -falign-functions=64"
dir=$OUT/bench_fx
only_build=""
if [ "${1:-}" = --build ]; then
    only_build=yes
    dir=$OUT/bench_fx_build
    shift
fi
mkdir -p "$dir"

# A private list of sources: what the system has configured, for source packages.
fetch() (
    cd "$1"
    mkdir -p lists/partial
    apt-cache policy libfixmath-dev |
        sed -n 's|^ *[0-9-]* \([a-z+]*://[^ ]*\) \([^ /]*\)/\([^ ]*\) .*|deb-src \1 \2 \3|p' | sort -u >sources.list
    [ -s sources.list ] || return 1
    options="-qq -o Dir::Etc::sourcelist=$PWD/sources.list -o Dir::Etc::sourceparts=/dev/null"
    options="$options -o Dir::State::lists=$PWD/lists"
    apt-get $options update
    apt-get $options source --download-only libfixmath || true # Debian's own changes are not needed
    name=$(sed -n '/^Checksums-Sha256/,/^[^ ]*:$/s/^ [0-9a-f]* [0-9]* \(.*\.orig\.tar\..*\)$/\1/p' ./*.dsc)
    sed -n "/^Checksums-Sha256/,/^Files/s/^ \([0-9a-f]*\) [0-9]* $name\$/\1  $name/p" ./*.dsc | sha256sum -c --quiet
    mkdir -p source
    tar -xf "$name" -C source
)

source_dir() {
    find "$dir/source" -name fix16_trig.c -printf '%h\n' 2>/dev/null | head -n 1
}

# side NAME LIBRARY: the table theirs_NAME and its library in one object, which shows the table alone.
side() {
    $CC $FLAGS -DSIDE="theirs_$1" -c tools/lab/bench_fx/bench_fx_theirs.c -o "$dir/$1.table.o"
    $CC -r -nostdlib "$dir/$1.table.o" "$2" -o "$dir/$1.o"
    objcopy --keep-global-symbol="theirs_$1" "$dir/$1.o"
}

# build NAME FLAG...: the library from source.
build() {
    name=$1
    shift
    rm -rf "${dir:?}/$name"
    mkdir -p "$dir/$name"
    for c in "$(source_dir)"/*.c; do
        $CC $FLAGS -w "$@" -c "$c" -o "$dir/$name/$(basename "$c" .c).o"
    done
    ar rcs "$dir/$name.a" "$dir/$name"/*.o
    side "$name" "$dir/$name.a"
}

[ -n "$(source_dir)" ] || { rm -rf "$dir/fetched" && mkdir -p "$dir/fetched"; }
if [ -z "$only_build$(source_dir)" ] && (set -e; fetch "$dir/fetched") >"$dir/fetch.log" 2>&1; then
    mv "$dir/fetched/source" "$dir/source"
fi

side debian "$($CC -print-file-name=liblibfixmath.a)"
if [ -n "$(source_dir)" ]; then
    build o2
    build uncached -DFIXMATH_NO_CACHE
    build lut -DFIXMATH_SIN_LUT
else
    [ "$only_build" ] || echo "libfixmath's source cannot be had ($dir/fetch.log says why): Debian's build alone"
    for name in o2 uncached lut; do
        $CC $FLAGS -DABSENT -DSIDE="theirs_$name" -c tools/lab/bench_fx/bench_fx_theirs.c -o "$dir/$name.o"
    done
fi
$CC $FLAGS -c tools/lab/bench_fx/bench_fx_ours.c -o "$dir/ours.o"
$CC $FLAGS -c src/base/trig.c -o "$dir/trig.o"
$CC $FLAGS "$@" "$dir/ours.o" "$dir/trig.o" "$dir/debian.o" "$dir/o2.o" "$dir/uncached.o" "$dir/lut.o" ${LIBS:-} \
    -o "$dir/bench_fx"
[ -z "$only_build" ] || exit 0

echo \
    "machine: $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo 2>/dev/null | head -n 1), load $(cut -d' ' -f1 \
    /proc/loadavg)"
echo "$($CC --version | head -n 1), $FLAGS"
taskset -c 0 "$dir/bench_fx" roms/glasstide roms/glasstide/demos/run.demo

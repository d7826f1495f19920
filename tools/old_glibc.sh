#!/usr/bin/env bash
# old_glibc.sh - runs a command that compiles programs for other people's machines: in a root of the oldest Debian
# release that this machine's mirror has, because a program needs the glibc it was linked with, or a newer one.
#
#     tools/old_glibc.sh make ...
#
# That root is made once, as build/chroot/compiler, with a compiler and make. This repository and this machine's
# headers of stb and SDL2 are mounted in it. Users other than root compile here, with this machine's glibc.
set -eu
cd "$(dirname "$0")/.."
root=build/chroot/compiler

if [ "$(id -u)" != 0 ]; then
    echo "  compiling for $(getconf GNU_LIBC_VERSION) (as root: for the oldest Debian that the mirror has)"
    exec "$@"
fi
if [ ! -d $root ]; then
    release=$(tools/chroot.sh releases | head -n 1)
    [ -n "$release" ] || { echo "tools/old_glibc.sh: the mirror has no Debian release" >&2; exit 3; }
    tools/chroot.sh make "$release" $root gcc libc6-dev make pkg-config
fi
echo "  compiling in Debian $(. $root/etc/os-release && echo "${VERSION_CODENAME:-$PRETTY_NAME}")," \
    "$(tools/chroot.sh run $root getconf GNU_LIBC_VERSION)"
binds=(--bind "$PWD")
for headers in /usr/include/stb /usr/include/SDL2 "/usr/include/$(cc -print-multiarch)/SDL2"; do
    [ ! -d "$headers" ] || binds+=(--bind "$headers")
done
tools/chroot.sh run $root "${binds[@]}" "$@"

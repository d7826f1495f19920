#!/bin/sh
# Installs what is missing from Debian's packages. Says nothing when all is there.
set -eu

missing=""

have() { command -v "$1" >/dev/null 2>&1; }
header() { [ -e "/usr/include/$1" ]; }

have gcc || missing="$missing gcc libc6-dev"
have pkg-config || missing="$missing pkg-config"
header lua5.4/lua.h || missing="$missing liblua5.4-dev"
header SDL2/SDL.h || missing="$missing libsdl2-dev"
header stb/stb_image.h || missing="$missing libstb-dev"
header cmocka.h || missing="$missing libcmocka-dev"
have lua5.4 || missing="$missing lua5.4"
have clang || missing="$missing clang"
have clang-format || missing="$missing clang-format"
have git || missing="$missing git"
have python3 || missing="$missing python3"
have Xvfb || missing="$missing xvfb"
have xdotool || missing="$missing xdotool"
have xwd || missing="$missing x11-apps"
have nm || missing="$missing binutils"
ls /usr/lib/llvm-*/lib/clang/*/lib/linux/libclang_rt.fuzzer-* >/dev/null 2>&1 || missing="$missing libclang-rt-14-dev"

[ -n "$missing" ] || exit 0

if ! have apt-get; then
    echo "curtain: please install the equivalents of these Debian packages:$missing" >&2
    exit 3
fi
root=""
if [ "$(id -u)" != 0 ]; then
    have sudo || { echo "curtain: please run as root: apt-get install$missing" >&2; exit 3; }
    root=sudo
fi
echo "curtain: installing$missing"
$root apt-get update -qq
# shellcheck disable=SC2086
DEBIAN_FRONTEND=noninteractive $root apt-get install -y --no-install-recommends $missing

#!/bin/sh
# deps.sh - prints the commands that install what is missing on macOS, and exits with 3; installs nothing.
#
#     tools/macos/deps.sh [--say] [null] [play] [test]
#
# Called by tools/deps.sh, whose arguments it takes. stb has no Homebrew package: its headers go to build/include.
set -eu
[ "${1:-}" != --say ] || shift
[ $# -gt 0 ] || set -- play test
prefix=${BREW:-$(brew --prefix 2>/dev/null || true)}
formulas="" steps=""

have() { command -v "$1" >/dev/null 2>&1; }
formula() { # NAME FILE: the file is in the formula, below Homebrew's prefix
    [ -e "$prefix/$2" ] || formulas="$formulas $1"
}
step() { steps="$steps
    $1"; }

xcode-select -p >/dev/null 2>&1 || step "xcode-select --install"
[ -n "$prefix" ] || step "install Homebrew as https://brew.sh says"
have pkg-config || formulas="$formulas pkgconf"
formula lua@5.4 opt/lua@5.4/lib/pkgconfig/lua5.4.pc
[ -e build/include/stb/stb_image.h ] || step "git clone --depth 1 https://github.com/nothings/stb build/include/stb"
for what; do
    case $what in
    null) ;;
    play) formula sdl2 lib/libSDL2-2.0.0.dylib ;;
    test) formula cmocka include/cmocka.h ;;
    *)
        echo "curtain: \"$what\" has no macOS build; run it on Linux" >&2
        exit 3
        ;;
    esac
done
[ -z "$formulas" ] || step "brew install$formulas"
[ -n "$steps" ] || exit 0
echo "curtain: something is missing; these commands install it:$steps" >&2
exit 3

#!/usr/bin/env bash
# install.sh - what make install puts where: the programs, the documents, and the examples and games that README says to
# copy, which the installed program checks and packs. One file for a friend, with another game in it. make null asks for
# no SDL2.
. "$(dirname "$0")/../tap.sh"
repo=$PWD
unset MAKEFLAGS MAKELEVEL MFLAGS

# A copy of the tree, with what is built of the release.
tree=$scratch/tree
mkdir -p "$tree/build/release"
cp -a Makefile README.md docs examples fb platform roms scripts src tools "$tree"
mkdir "$tree/tests"
for part in src fb platform gen embed curtain-bare curtain curtain-null game.rom game.is; do
    [ ! -e "build/release/$part" ] || cp -a "build/release/$part" "$tree/build/release/"
done
makes() { make --no-print-directory -s -C "$tree" "$@"; }

check 'make install' makes install DESTDIR="$scratch/root" PREFIX=/usr
share=$scratch/root/usr/share/curtain
installed=$scratch/root/usr/bin/curtain-null
check 'the program is there' "$installed" version
check 'so is the one with a window' test -x "$scratch/root/usr/bin/curtain"
check 'so are the documents' test -s "$scratch/root/usr/share/doc/curtain/manual.md"
for dir in examples/first examples/sandbox roms/glasstide; do
    check "$dir is installed, whole" diff -r "$dir" "$share/$dir"
done
cd "$scratch" || exit 2
cp -r "$share/examples/first" mygame
check 'an installed example, copied, is fine' "$installed" check mygame
check 'and packs' "$installed" pack mygame -o mygame.rom
check 'and runs' "$installed" hash mygame.rom --frames 60
cd "$repo" || exit 2

# The game that is built in is the one asked for, whatever was built in before, and follows its files.
built_in() { # GAME [ARGUMENT]...: of make
    local game=$1 want got
    shift
    makes "$@" build/curtain || return 1
    want=$("$OUT/curtain-null" hash "$game" --frames 30 --parts) &&
        got=$("$tree/build/curtain" hash --frames 30 --parts) || return 1
    [ "$want" = "$got" ] || { echo "built in is another game" && return 1; }
}
check 'one file with a game in it' built_in examples/first GAME=examples/first
check 'another game, without a clean' built_in roms/testcard GAME=roms/testcard
cp -r examples/first "$tree/mine"
check 'a game of one'"'"'s own' built_in "$tree/mine" GAME=mine
touch -d '2 days ago' "$tree/mine/main.lua" "$tree/mine/rom.lua"
echo 'board.note(7)' >>"$tree/mine/main.lua"
check 'which has changed' built_in "$tree/mine" GAME=mine
echo 'return 1' >"$tree/mine/more.lua"
check 'a file more' built_in "$tree/mine" GAME=mine
rm "$tree/mine/more.lua"
check 'a file less' built_in "$tree/mine" GAME=mine
check 'and the game of its own again' built_in roms/glasstide
not_again() { # nothing that is there is made once more
    touch "$scratch/then" && makes build/curtain && [ ! "$tree/build/curtain" -nt "$scratch/then" ] &&
        [ ! "$tree/build/release/game.rom" -nt "$scratch/then" ]
}
check 'nothing is built twice' not_again
check 'it is one file' bash -c 'cd / && exec "$1" hash --frames 1' - "$tree/build/curtain"

# What make null asks for, on a machine that has nothing.
asks() { # WHAT: with no programs and no headers
    mkdir -p "$scratch/bin"
    ln -sf "$(command -v dirname)" "$(command -v sh)" "$scratch/bin/"
    sed 's,/usr/include/,/none/,' tools/deps.sh >"$scratch/deps.sh"
    PATH=$scratch/bin sh "$scratch/deps.sh" "$1" 2>&1
}
without_sdl() { asks null | grep -q 'gcc .*liblua5.4-dev' && ! asks null | grep -q sdl; }
check 'what is needed without a window has no SDL2' without_sdl
with_sdl() { asks play | grep -q libsdl2-dev; }
check 'with one it has' with_sdl
asks_null() { make -n null | grep -qx 'tools/deps.sh null'; }
check 'make null asks for the former' asks_null
finish

#!/usr/bin/env bash
# install.sh - what make install puts where: the programs, the documents, the examples and games that README says to
# copy, which the installed program checks and packs; the manual page and the desktop's entry, which their checkers
# pass; and make uninstall takes all of it away. One file for a friend, with another game in it. What is missing is said
# by make and make all, which install nothing, and installed by make play; make null asks for no SDL2.
. "$(dirname "$0")/../tap.sh"
repo=$PWD
unset MAKEFLAGS MAKELEVEL MFLAGS

# A copy of the tree, with what is built of the release.
tree=$scratch/tree
mkdir -p "$tree/build/release"
cp -a Makefile README.md CHANGELOG.md LICENSE docs examples fb platform roms scripts share src tools "$tree"
mkdir "$tree/tests" && cp tests/tests.mk tests/tiers "$tree/tests/"
for part in src fb platform gen lib embed curtain-bare curtain curtain-player curtain-null game.rom game.is; do
    [ ! -e "build/release/$part" ] || cp -a "build/release/$part" "$tree/build/release/"
done
makes() { make --no-print-directory -s -C "$tree" "$@"; }

echo '<p>all of it' >"$tree/build/curtain.html"
check 'make install' makes install DESTDIR="$scratch/root" PREFIX=/usr
check 'the page that make docs has made is beside the pages' cmp \
    "$tree/build/curtain.html" "$scratch/root/usr/share/doc/curtain/curtain.html"
share=$scratch/root/usr/share/curtain
installed=$scratch/root/usr/bin/curtain-null
mkdir -p "$tree/build/players"
core=$("$installed" version | sed -n '1s/.*(core \([0-9]*\),.*/\1/p')
printf '<meta name="generator" content="Curtain, core %s">@TITLE@ @ROM@' "$core" >"$tree/build/players/player.html"
check 'with the player for browsers, once make web has made it' makes install DESTDIR="$scratch/root" PREFIX=/usr
check 'of which the installed program makes a page' \
    "$installed" export roms/testcard --web -o "$scratch/page.html"
for dir in examples/first examples/sandbox examples/shooter roms/glasstide; do
    check "$dir is installed, without what made it" diff -r -x source "$dir" "$share/$dir"
done
cd "$scratch" || exit 2
cp -r "$share/examples/first" mygame
check 'an installed example, copied, is fine' "$installed" check mygame
check 'and runs' "$installed" hash mygame --frames 60
mkdir alone && cp "$installed" alone/ && rm -rf mine
check 'the program alone, with nothing installed beside it, makes a game' alone/curtain-null new mine
check 'which is the one that is installed' diff -r -x '.*' -x rom.lua -x README.md mine "$share/examples/shooter"
rm -rf mine
cd "$repo" || exit 2

# What the desktop and man look for.
usr=$scratch/root/usr
page() { # NAME: as man shows it
    man -l "$usr/share/man/man1/$1.1" 2>&1 | tr -s ' \n' ' ' >"$scratch/page"
    grep -q 'NAME curtain, curtain-null - play, record and verify' "$scratch/page" || { cat "$scratch/page"; return 1; }
}
read_page() { (cd "$usr/share/man" && page curtain); }
if command -v man >/dev/null; then check 'man shows the page' read_page; else echo '# no man here'; fi
entry=$usr/share/applications/curtain.desktop
check 'the entry of the menu is valid' desktop-file-validate "$entry"
starts() { [ -x "$usr/bin/$(sed -n 's/^Exec=\([a-z]*\) play --dialog %f$/\1/p' "$entry")" ]; }
check 'it starts the installed program' starts
icons() { # of three sizes
    local size
    for size in 48 128 256; do
        identify -format '%wx%h' "$usr/share/icons/hicolor/${size}x$size/apps/$(sed -n 's/^Icon=//p' "$entry").png" |
            grep -qx "${size}x$size" || return 1
    done
}
check 'its icon is there, of each size' icons
data=$usr/share/metainfo/org.curtain.Curtain.metainfo.xml
check 'the data for software centres are valid' appstreamcli validate --no-net "$data"

# The types of files; machine/double_click.sh opens them.
known() { update-mime-database "$usr/share/mime" && update-desktop-database "$usr/share/applications"; }
check 'the type is made known' known
find "$usr/share/mime" -mindepth 1 -maxdepth 1 ! -name packages -exec rm -r {} +
rm "$usr/share/applications/mimeinfo.cache"
makes install PREFIX="$scratch/here" >/dev/null 2>&1
by_itself() {
    [ -s "$scratch/here/share/mime/mime.cache" ] &&
        grep -q x-curtain "$scratch/here/share/applications/mimeinfo.cache"
}
check 'make install makes it known, where it is installed for good' by_itself
makes uninstall PREFIX="$scratch/here" >/dev/null 2>&1
forgotten() { ! grep -q curtain "$scratch/here/share/mime/globs2" "$scratch/here/share/applications/mimeinfo.cache"; }
check '... and make uninstall unknown' forgotten

# Away again: all that was put there, and nothing else.
gone() { # what is left is FILE..., and no folder of ours is without a file
    local left
    left=$(cd "$usr" && find . -type f | sort)
    [ "$left" = "$*" ] || { echo "left: $left"; return 1; }
    [ -z "$(find "$usr" -type d -name curtain -empty)" ]
}
echo 'return 1' >"$share/examples/first/mine.lua"
touch "$usr/bin/other"
uninstall() { makes uninstall DESTDIR="$scratch/root" PREFIX=/usr; }
check 'make uninstall' uninstall
check 'what others put there stays' gone "./bin/other
./share/curtain/examples/first/mine.lua"
rm "$share/examples/first/mine.lua" "$usr/bin/other"
check 'once more' uninstall
check 'nothing is left' gone
ours() { [ ! -e "$share" ] && [ ! -e "$usr/share/doc/curtain" ]; }
check 'nor any folder of its own' ours

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
cp -r examples/first "$tree/mine"
check 'a game of one'"'"'s own' built_in "$tree/mine" GAME=mine
touch -d '2 days ago' "$tree/mine/main.lua" "$tree/mine/rom.lua"
echo 'board.note(7)' >>"$tree/mine/main.lua"
check 'which has changed' built_in "$tree/mine" GAME=mine
echo 'return 1' >"$tree/mine/more.lua"
check 'a file more' built_in "$tree/mine" GAME=mine
check 'and the game of its own again' built_in roms/glasstide
not_again() { # nothing that is there is made once more
    touch "$scratch/then" && makes build/curtain && [ ! "$tree/build/curtain" -nt "$scratch/then" ] &&
        [ ! "$tree/build/release/game.rom" -nt "$scratch/then" ]
}
check 'nothing is built twice' not_again

# A machine that has make and the plainest programs, apt-get, which writes down that it was asked, and no headers.
bare=$scratch/bin
mkdir -p "$bare"
for word in dirname env find id make mkdir sh sort; do ln -sf "$(command -v $word)" "$bare/"; done
printf '#!/bin/sh\necho "$@" >>"%s/asked"\n' "$scratch" >"$bare/apt-get"
printf '#!/bin/sh\nexec "$@"\n' >"$bare/sudo"
chmod +x "$bare/apt-get" "$bare/sudo"
sed -i 's,/usr/include/,/none/,' "$tree/tools/deps.sh"
asks() { # GOAL: of make there; what it says is in $scratch/says, what apt-get is asked in $scratch/asked
    : >"$scratch/asked"
    PATH=$bare make --no-print-directory -C "$tree" "$1" >"$scratch/says" 2>&1
}
says() { # GOAL PACKAGES: make fails with one line to paste; apt-get is not asked
    asks "$1" && { echo "make $1 does not fail"; return 1; }
    cat "$scratch/says"
    grep -qE "^curtain: something is missing; this installs it: (sudo )?apt-get install $2\$" "$scratch/says" &&
        [ ! -s "$scratch/asked" ]
}
check 'make says what is missing, and installs nothing' \
    says all 'gcc libc6-dev pkg-config liblua5.4-dev libsdl2-dev libstb-dev'
check 'make null does, and asks for no SDL2' says null 'gcc libc6-dev pkg-config liblua5.4-dev libstb-dev'
installs() { # GOAL PACKAGE...: each of them asked of apt-get
    local package
    asks "$1"
    cat "$scratch/says"
    for package in "${@:2}"; do grep -q "^install .* $package\b" "$scratch/asked" || return 1; done
}
check 'make play installs it' installs play gcc libsdl2-dev
finish

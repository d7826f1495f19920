#!/usr/bin/env bash
# export.sh - `curtain export`: one file that is the game, whatever it is called and however it is started; its name,
# folders and icon; what it does not do; and what becomes of one that is damaged, cut short, or may not be read. The
# same for other systems, of players; and a zip file of each.
. "$(dirname "$0")/../tap.sh"
sandbox
export SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy
null=$curtain curtain=$OUT/curtain

cp -r "$repo/examples/first" lanterns
sed -i 's/title = "First Light"/id = "lanterns", title = "Paper \\\\ Lanterns", author = "You", icon = "ship"/' \
    lanterns/rom.lua
expect_error 'a game is exported' 0 '' "$curtain" export lanterns -o game
is_game() { [ "$("$@" version | head -1)" = 'Paper \ Lanterns 1 (lanterns)' ]; }
check 'it says what it is' is_game ./game
same 'anybody who can read it can run it' "$(stat -c %a game | tr 0-7 00004444)" "$(stat -c %a game | tr 0-7 04040404)"

# The icon is no part of what is recorded, and a game without one is as it was.
sums() { "$null" list "$1" | tail -n 2 | cut -d ' ' -f 2 | paste -sd ' '; }
cp -r lanterns plain
sed -i 's/icon = "ship", //; s/, icon = "ship"//' plain/rom.lua
same 'the game is the same with an icon' "$(sums plain | cut -d ' ' -f 1)" "$(sums lanterns | cut -d ' ' -f 1)"
check '... and the ROM another' [ "$(sums plain)" != "$(sums lanterns)" ]
cp lanterns/art/bullets.png lanterns/art/icon.png
check 'nor of one in a file' bash -c 'sed -i "s,icon = \"ship\",icon = \"art/icon.png\"," lanterns/rom.lua &&
    "$1" check lanterns' - "$null"
python3 "$repo/tests/cli/png_make.py" lanterns/art/icon.png 12 15 ffffff
input_error 'one that is too small' \
    'lanterns: art/icon.png: expected an icon whose longer side is 16 to 1024 px, got 12 x 15' export lanterns -o other
sed -i 's,icon = "art/icon.png",icon = "ship",' lanterns/rom.lua

# However it is started.
mkdir -p bin "with a blank"
cp game "with a blank/pâté \$1"
check 'renamed' is_game "./with a blank/pâté \$1"
ln -s "../game" bin/lanterns
check 'through PATH' is_game env PATH="$scratch/bin:$PATH" lanterns
cp game gone
check 'which is removed as it starts' bash -c 'exec 9<gone; rm gone; sleep 0; exec /proc/self/fd/9 version >/dev/null'
cat game bin/lanterns >longer
chmod +x longer
check 'with something behind' is_game ./longer
"$curtain" pack lanterns -o lanterns.rom
"$curtain" export lanterns.rom -o of_rom
check 'of a ROM it is the same file as of its folder' cmp game of_rom

# It plays its game: a demo of it ends well, and says so if it is another one.
"$null" hash lanterns --press fire --frames 40 --record run.demo >/dev/null
expect_error 'it plays' 0 '' ./game --demo run.demo --mute
rm lanterns.rom
"$curtain" export lanterns -o keys --keys
same 'with --keys it has all commands, and its game is the built-in one' "$("$null" hash lanterns --frames 40)" \
    "$(./keys hash --frames 40)"
check '... and replays its demos' ./keys verify lanterns run.demo
not_here() { ! grep -aq "$1" "$2"; }
check 'the built-in game is not given along' not_here 'Glass Tide' game

# Its own name and folders.
mkdir -p data/curtain-lanterns && echo 'loud = 3' >data/curtain-lanterns/curtain.conf
./game >said 2>&1 & # its window waits for the file
game=$!
until [ -s said ] || ! kill -0 $game 2>/dev/null; do sleep 0.05; done
kill -KILL $game
wait $game 2>/dev/null
check 'messages have its name' grep -q '^lanterns: .*curtain.conf:1: unknown setting "loud"' said
rm -r data/curtain-lanterns
same 'settings are its own' "$PWD/data/curtain-lanterns/curtain.conf" \
    "$(./game help config | grep -o '/[^ ]*curtain.conf' | head -1)"
lists() { ./game help; }
same 'its help has the options of playing, and no developer'"'"'s key' '1 1 0 0 0' \
    "$(for word in ' --fullscreen ' ' pause  ' ' console ' ' reload ' ' render '; do lists | grep -c -- "$word"; done |
        paste -sd ' ')"
plays='plays Paper \ Lanterns'
for command in 'render' 'verify a b' 'export a'; do
    expect_error "it does not $command" 2 \
        "lanterns: ${command%% *}: not available; this program only $plays (see --help)" \
        ./game $command
done
check 'it says whose work it is' grep -qF 'Paper \ Lanterns is by You. ' <(./game licences)

# Files that are not whole.
size=$(stat -c %s game)
itself="this program's own file"
head -c $((size - 100)) game >shorter
chmod +x shorter
expect_error 'cut short' 2 \
    "curtain: $itself is truncated: $((size - 100)) bytes, expected $size including its game" ./shorter
cp game spoiled
printf '\0\0\0\0' | dd of=spoiled bs=1 seek=$((size - 100)) conv=notrunc 2>/dev/null
expect_error 'other bytes' 2 "curtain: $itself is damaged: the game in it is corrupt" ./spoiled
python3 - game spoiled <<'END'
import sys
b = bytearray(open(sys.argv[1], "rb").read())
b[b.index(b"<a game may stand behind curtain") + 56] ^= 1
open(sys.argv[2], "wb").write(b)
END
expect_error 'the game is another than the one that was exported' 2 \
    "curtain: $itself is damaged: the game in it is corrupt" \
    ./spoiled version
cp game unreadable
chmod 111 unreadable
as_other() { "$@"; }
if [ "$(id -u)" = 0 ]; then # to whom nothing is unreadable
    chmod a+rx "$scratch"
    as_other() { setpriv --reuid=65534 --regid=65534 --clear-groups "$@"; }
fi
expect_error 'may be run, and not read' 3 "curtain: $itself: cannot be read (Permission denied)" as_other ./unreadable

# What export refuses.
echo 'nonsense(' >>lanterns/main.lua
input_error 'a game with an error' \
    "lanterns: main.lua:$(($(wc -l <lanterns/main.lua) + 1)): unexpected symbol near <eof>" \
    export lanterns -o game
check '... and the program that was there is as it was' is_game ./game
sed -i '$d' lanterns/main.lua
input_error 'in place of a folder' \
    'lanterns: a folder with this name exists; choose another file with -o' export lanterns
input_error 'in place of a file that is none of its own' \
    'run.demo: already exists and is not an exported program; remove it first' export lanterns -o run.demo
expect_error 'where nothing can be written' 3 \
    'curtain: /proc/none/game: cannot be written (No such file or directory)' \
    "$curtain" export lanterns -o /proc/none/game
expect_error 'by an exported program' 2 \
    'lanterns: export: this program is the exported game Paper \ Lanterns; use curtain to export games' \
    ./keys export lanterns
expect_error 'by a program without a window' 2 \
    'curtain: export: a copy of this program would have no window; use curtain, or add --linux or --windows' \
    "$null" export lanterns --keys -o game
expect_error '... but it makes the same program' 0 '' "$null" export lanterns -o same
check '... of the same bytes' cmp same game

# An entry for the desktop, with an icon.
expect_error 'an entry' 0 '' "$curtain" export lanterns -o 'with a blank/50 $x\ `b` "c"' --desktop
entry='with a blank/50 $x\ `b` "c".desktop'
check '... is valid' desktop-file-validate "$entry"
same '... with its name' 'Name=Paper \\ Lanterns' "$(grep ^Name= "$entry")"
started() { # as a desktop would: by GLib
    rm -f ran
    printf '#!/bin/sh\nexec touch "%s/ran"\n' "$PWD" >"$1"
    chmod +x "$1"
    gio launch "$2" && for _ in $(seq 100); do [ -e ran ] && return; sleep 0.1; done
    return 1
}
check '... which starts it, with all that is odd in its path' started 'with a blank/50 $x\ `b` "c"' "$PWD/$entry"
icon=with\ a\ blank/'50 $x\ `b` "c".png'
same 'an icon of a sprite: a square of whole pixels' 144x144 "$(identify -format '%wx%h' - <"$icon")"
same '... of this path' "$PWD/${icon//\\/\\\\}" "$(sed -n 's/^Icon=//p' "$entry")"
input_error 'beside files of somebody' 'new.png: already exists; remove it, or choose another file with -o' \
    export lanterns -o "$(touch new.png && echo new)" --desktop
check '... and nothing was written' test ! -e new

# ---- for other systems: players are next to the program, or in its installation ----

mkdir -p tree/bin tree/share/curtain/players
cp "$null" tree/bin/curtain-null
tool=$PWD/tree/bin/curtain-null
players=$PWD/tree/share/curtain/players
curtain=$tool
while read -r option player; do
    input_error "no player: $option" \
        "export: cannot find the player $player in players or ../share/curtain/players, relative \
to this program's folder; run \`make players\` in Curtain's source tree" export lanterns "--$option" -o "new.so"
done <<'END'
linux curtain-player-linux
windows curtain-player.exe
web player.html
libretro curtain_libretro.so
all curtain-player-linux
END
check '... and nothing was written' test ! -e new.so
version=$("$tool" version | sed -n '1s/.*(core \([0-9]*\),.*/\1/p')
player=$players/player.html
page() { # CORE [ROM-MARK]
    printf '<meta name="generator" content="Curtain, core %s">\n<title>@TITLE@</title>\n<h1>@TITLE@</h1>\n' "$1"
    printf '<script>%s</script>\n@ROM' "${2-@ROM@}"
}
sed -i 's/title = "[^"]*"/title = "Sun \& <Sea> @ROM@"/' lanterns/rom.lua
page "$version" >"$player"
expect_error 'a page is made, by a program without a window too' 0 '' "$tool" export lanterns --web
same 'with its title' '<title>Sun &amp; &lt;Sea&gt; &#64;ROM&#64;</title>
<h1>Sun &amp; &lt;Sea&gt; &#64;ROM&#64;</h1>' "$(sed -n 2,3p lanterns.html)"
same 'and all that was there' "@ROM$(page "$version" | head -1)" "$(tail -n 1 lanterns.html)$(head -1 lanterns.html)"
sed -n 's,^<script>\(.*\)</script>$,\1,p' lanterns.html | base64 -d >in.rom
"$tool" pack lanterns -o lanterns.rom
check 'and its game, compressed' cmp in.rom lanterns.rom
page $((version + 1)) >"$player"
input_error 'a player of another core version' \
    "$player: expected core version $version, got $((version + 1)); rebuild it with \`make players\`" \
    export lanterns --web -o new.html
for wrong in "$(page "$version" '@ROM@@ROM@')" "$(page x)"; do
    printf '%s' "$wrong" >"$player"
    input_error "what is no player: ${#wrong} bytes" "$player: not a valid player; rebuild it with \`make players\`" \
        export lanterns --web -o new.html
done
check '... and nothing was written' test ! -e new.html

cp "$OUT/curtain_libretro.so" "$players" || not_ok 'the core is there'
core=$players/curtain_libretro.so
expect_error 'a core is made' 0 '' "$tool" export lanterns --libretro
same 'and what front ends read of it' 'display_name = "Sun & <Sea> @ROM@"
supports_no_game = "true"
savestate_features = "deterministic"' \
    "$(grep -E '^(display_name|supports_no_game|savestate_features)' lanterns_libretro.info)"
called() { # CORE: what it calls itself, and what files it takes
    python3 - "$1" <<'END'
import ctypes, sys
class Info(ctypes.Structure):
    _fields_ = [("name", ctypes.c_char_p), ("version", ctypes.c_char_p), ("ends", ctypes.c_char_p),
                ("path", ctypes.c_bool), ("block", ctypes.c_bool)]
core, info = ctypes.CDLL(sys.argv[1]), Info()
core.retro_get_system_info(ctypes.byref(info))
print(info.name.decode(), info.ends.decode())
END
}
same 'it has the name of its game' 'Sun & <Sea> @ROM@ ' "$(called ./lanterns_libretro.so)"
same 'and one without a game its own' 'Curtain rom' "$(called "$core")"
touch mine.info
input_error 'beside files of somebody' 'mine.info: already exists; remove it, or choose another file with -o' \
    export lanterns --libretro -o mine.so
input_error 'what is none is not replaced' 'run.demo.so: already exists and is not an exported core; remove it first' \
    export lanterns --libretro -o "$(cp run.demo run.demo.so && echo run.demo.so)"
input_error 'a name that front ends pass over' \
    '--libretro: expected a file name ending in .so after -o, got "lanterns.core"' \
    export lanterns --libretro -o lanterns.core
python3 - "$OUT/curtain_libretro.so" "$core" <<'END'
import sys
b = bytearray(open(sys.argv[1], "rb").read())
b[b.index(b"<a game may stand behind curtain") + 60] += 1
open(sys.argv[2], "wb").write(b)
END
input_error 'a core of another core version' \
    "$core: expected core version $version, got $((version + 1)); rebuild it with \`make players\`" \
    export lanterns --libretro -o new.so
check '... and nothing was written' test ! -e new.so -a ! -e new.info
page "$version" >"$player"

# ---- Linux: the players are copies of the programs here ----

cp "$OUT/curtain-player" "$players/curtain-player-linux"
cp "$OUT/curtain" "$players/curtain-linux"
sed -i 's/title = "[^"]*"/title = "Paper \\\\ Lanterns"/' lanterns/rom.lua
expect_error 'a program for Linux, by a program without a window too' 0 '' "$tool" export lanterns --linux -o other
check 'is the game' is_game ./other
"$tool" export lanterns --linux --keys -o full
check 'with --keys it has all commands' ./full hash --frames 1
mkdir tree/bin/players
cp "$player" tree/bin/players/curtain-player-linux
input_error 'a player next to the program is the one used' \
    "$PWD/tree/bin/players/curtain-player-linux: not a valid player; rebuild it with \`make players\`" \
    export lanterns --linux -o new
rm -r tree/bin/players

# ---- Windows: what is changed in the file, of a small one; tests/windows.sh runs a whole one ----

exe=$players/curtain-player.exe
pe() { python3 "$repo/tests/cli/pe_$1.py" "${@:2}"; }
pe make "$exe" "$version"
sed -i 's/title = "[^"]*"/title = "Lanterns ☂𝄞"/' lanterns/rom.lua
expect_error 'a program for Windows' 0 '' "$tool" export lanterns --windows
same 'has sections, resources and a version as it should' 'sections .text .unused .reloc .rsrc
resources 3/1 3/2 3/3 3/4 14/1 16/1 24/1
version 0 1 0 0 1 0 0 0
CompanyName: You
FileDescription: Lanterns ☂𝄞
FileVersion: 0.1.0
InternalName: lanterns
OriginalFilename: lanterns.exe
ProductName: Lanterns ☂𝄞
ProductVersion: 1
Comments: Made with Curtain 0.1.0
translation 4b00409' "$(pe read lanterns.exe)"
same 'the manifest is the old one' '<assembly>a manifest</assembly>' "$(pe read lanterns.exe 24 1)"
check 'an icon for Windows to read' eval 'pe read lanterns.exe icon >of.ico'
same '... of four sizes' '16x16 32x32 48x48 256x256' "$(identify -format '%wx%h ' of.ico | sed 's/ $//')"
for old in 'old icon' 'old version' 'signature, names'; do
    check "nothing is left of the player's: $old" not_here "$old" lanterns.exe
done
in_exe() { # FILE: the ROM in it, where its mark says
    python3 - "$1" <<'END'
import struct, sys
b = open(sys.argv[1], "rb").read()
at, size = struct.unpack_from("<QQ", b, b.index(b"<a game may stand behind curtain") + 40)
assert at % 16 == 0 and at + size == len(b), (at, size, len(b))
sys.stdout.buffer.write(b[at:])
END
}
"$tool" pack lanterns -o lanterns.rom
check 'the game is behind it, where the mark says' cmp <(in_exe lanterns.exe) lanterns.rom
check 'in an export for Linux too' cmp <("$tool" export lanterns --linux -o game && in_exe game) lanterns.rom
cp -r lanterns plainer
sed -i 's/, icon = "ship"//; s/ author = "You"//; s/,,/,/' plainer/rom.lua
"$tool" export plainer --windows -o plainer.exe
same 'without an icon and author: the icon is the old one' "$(pe read lanterns.exe 24 1)
$(printf 'old icon%.0s' 1 2 3 4 5 6 7 8 9)
resources 3/1 14/1 16/1 24/1" "$(pe read plainer.exe 24 1; echo; pe read plainer.exe 3 1; echo; pe read plainer.exe |
    sed -n 2p)"
not_windows='expected an x86-64 Windows program with space for another section'
cp "$exe" whole.exe
spoil_exe() { # NAME BYTE VALUE: that number of the player's headers is another
    python3 - whole.exe "$exe" "$2" "$3" <<'END'
import struct, sys
b = bytearray(open(sys.argv[1], "rb").read())
struct.pack_into("<I", b, int(sys.argv[3]), int(sys.argv[4]))
open(sys.argv[2], "wb").write(b)
END
    input_error "$1" "$exe: $not_windows" export lanterns --windows -o new.exe
}
sections=$((128 + 24 + 240))
spoil_exe 'a player that is no program' 128 0
spoil_exe 'one whose header is full' $((128 + 24 + 60)) $((sections + 3 * 40))
spoil_exe 'one whose section runs past its end' $((sections + 40 + 16)) 1048576
pe make "$exe" $((version + 1))
input_error 'one of another core version' \
    "$exe: expected core version $version, got $((version + 1)); rebuild it with \`make players\`" \
    export lanterns --windows -o new.exe
check '... and nothing was written' test ! -e new.exe
pe make "$exe" "$version"

# ---- a zip file of each ----

cp "$OUT/curtain_libretro.so" "$core"
sed -i 's/title = "[^"]*"/title = "Paper \\\\ Lanterns"/' lanterns/rom.lua
mv "$player" away
input_error 'a zip of each, and a player is missing' "export: cannot find the player player.html in players or \
../share/curtain/players, relative to this program's folder; run \`make players\` in Curtain's source tree" \
    export lanterns --all
check '... and nothing was written' test ! -e lanterns-exports
mv away "$player"
expect_error 'a zip of each' 0 '' "$tool" export lanterns --all
same 'in a folder of the id' 'lanterns-libretro.zip lanterns-linux.zip lanterns-web.zip lanterns-windows.zip' \
    "$(cd lanterns-exports && echo *)"
list() { # ZIP: mode, name, date of each file, as Python reads it, after a look at all bytes
    python3 - "$1" <<'END'
import sys, zipfile
z = zipfile.ZipFile(sys.argv[1])
assert z.testzip() is None
for i in z.infolist():
    assert i.date_time == (1980, 1, 1, 0, 0, 0) and i.create_system == 3 and i.flag_bits == 1 << 11
    print("%o %s" % (i.external_attr >> 16, i.filename))
END
}
of_all() { # KIND FILES: what is in its zip
    local zip=lanterns-exports/lanterns-$1.zip
    same "$1: its files" "$2
100644 README.txt
100644 licences.txt" "$(list "$zip")"
    check '... are as unzip wants them' unzip -tqq "$zip"
    mkdir "of-$1" && unzip -qq "$zip" -d "of-$1"
}
of_all linux '100755 lanterns'
of_all windows '100755 lanterns.exe'
of_all web '100644 index.html'
of_all libretro '100644 lanterns_libretro.so
100644 lanterns_libretro.info'
check 'the program for Linux runs, unpacked' is_game of-linux/lanterns
for pair in linux:lanterns windows:lanterns.exe web:index.html libretro:lanterns_libretro.so; do
    "$tool" export lanterns "--${pair%:*}" -o one.so
    check "${pair%:*}: what is exported alone" cmp one.so "of-${pair%:*}/${pair#*:}"
    rm one.so
done
lines() { # FOLDER FILE: of how many lines how many end in CR LF
    echo "$2 $(grep -c '' "$1/$2") $(grep -c $'\r$' "$1/$2")"
}
for kind in linux windows web libretro; do
    for text in README.txt licences.txt; do
        n=$(grep -c '' "of-$kind/$text")
        same "$kind: ends of lines" "$text $n $([ $kind = windows ] && echo "$n" || echo 0)" "$(lines "of-$kind" $text)"
    done
    same "$kind: whose game it is" 'Paper \ Lanterns
by You' "$(head -n 2 of-$kind/README.txt | tr -d '\r')"
done
for name in fire bomb focus special start select; do
    "$null" help play | sed -n "s/^  p1\.$name  *\([^ ]*\) .*/\1/p" >key
    check "the key of $name is the default one: $(cat key)" grep -qE "^  $(cat key)(,| )" of-linux/README.txt
done
check 'one player: no keys of another' bash -c '! grep -q "Player 2" of-linux/README.txt'
settings=$(./game help config | sed -n "s,^ *$XDG_DATA_HOME/\(.*\)/curtain.conf$,\1,p")
for kind in linux windows; do
    same "$kind: where files are" 2 "$(grep -c "[/\\]$settings" "of-$kind/README.txt")"
done
for notice in Lua.org 'Sam Lantinga' 'mingw-w64 project' 'Rich Felker' 'The Curtain authors'; do
    check "licences: $notice" grep -q "$notice" of-linux/licences.txt
done
cp -r lanterns-exports before
expect_error 'zip files are replaced' 0 '' "$tool" export lanterns --all -o lanterns-exports
check '... by the same bytes' diff -r before lanterns-exports
(cd lanterns && zip -q ../foreign.zip rom.lua) 2>/dev/null || python3 -m zipfile -c foreign.zip lanterns/rom.lua
cp foreign.zip lanterns-exports/lanterns-web.zip
rm lanterns-exports/lanterns-linux.zip
input_error 'but not those of others' \
    'lanterns-exports/lanterns-web.zip: already exists and is not an exported zip file; remove it first' \
    export lanterns --all
check '... and nothing was written' test ! -e lanterns-exports/lanterns-linux.zip
sed -i 's/return {/return { players = 2,/' lanterns/rom.lua
"$tool" export lanterns --all -o two
check 'two players: the keys of both' grep -q '^Player 2:' <(unzip -p two/lanterns-linux.zip README.txt)
finish

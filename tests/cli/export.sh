#!/usr/bin/env bash
# export.sh - `curtain export`: one file that is the game, whatever it is called and however it is started; its name,
# folders and icon; what it does not do; and what becomes of one that is damaged, cut short, or may not be read.
. "$(dirname "$0")/../tap.sh"
sandbox
export SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy
null=$curtain curtain=$OUT/curtain

says() { # NAME CODE LINE COMMAND...: all of stderr
    local name=$1 code=$2 line=$3 got
    shift 3
    "$@" >out 2>err
    got=$?
    same "$name" "$line"$'\n'"exit $code" "$(cat err)"$'\n'"exit $got"
}
bad() { # NAME LINE ARGUMENT...
    local name=$1 line=$2
    shift 2
    says "$name" 2 "curtain: $line" "$curtain" "$@"
}

cp -r "$repo/examples/first" lanterns
sed -i 's/title = "First Light"/id = "lanterns", title = "Paper \\\\ Lanterns", author = "You", icon = "ship"/' \
    lanterns/rom.lua
says 'a game is exported' 0 '' "$curtain" export lanterns -o game
is_game() { [ "$("$@" version | head -1)" = 'Paper \ Lanterns 1 (lanterns)' ]; }
check 'it says what it is' is_game ./game
check 'it is a program' test -x game
same 'anybody who can read it can run it' "$(stat -c %a game | tr 0-7 00004444)" "$(stat -c %a game | tr 0-7 04040404)"

# The icon is no part of what is recorded, and a game without one is as it was.
sums() { "$null" list "$1" | tail -n 2 | cut -d ' ' -f 2 | paste -sd ' '; }
cp -r lanterns plain
sed -i 's/icon = "ship", //; s/, icon = "ship"//' plain/rom.lua
same 'the game is the same with an icon' "$(sums plain | cut -d ' ' -f 1)" "$(sums lanterns | cut -d ' ' -f 1)"
check '... and the ROM another' [ "$(sums plain)" != "$(sums lanterns)" ]
check 'check has nothing to say of it' "$null" check lanterns
cp lanterns/art/bullets.png lanterns/art/icon.png
check 'nor of one in a file' bash -c 'sed -i "s,icon = \"ship\",icon = \"art/icon.png\"," lanterns/rom.lua &&
    "$1" check lanterns' - "$null"
truncate -s 90 lanterns/art/icon.png
refuse 'a file that is no picture' 'lanterns: art/icon.png: ' "$curtain" export lanterns -o other
python3 "$repo/tests/cli/png_make.py" lanterns/art/icon.png 12 15 ffffff
bad 'one that is too small' \
    'lanterns: art/icon.png: expected an icon whose longer side is 16 to 1024 px, got 12 x 15' export lanterns -o other
rm lanterns/art/icon.png
bad 'one that is not there' 'lanterns: rom.lua:2: art/icon.png does not exist' export lanterns -o other
sed -i 's,icon = "art/icon.png",icon = "ship",' lanterns/rom.lua

# However it is started.
mkdir -p bin "with a blank"
cp game "with a blank/pâté \$1"
check 'renamed' is_game "./with a blank/pâté \$1"
ln -s "../game" bin/lanterns
check 'by a link' is_game bin/lanterns
check 'through PATH' is_game env PATH="$scratch/bin:$PATH" lanterns
elsewhere() (cd / && is_game "$1")
check 'from elsewhere' elsewhere "$PWD/game"
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
says 'it plays' 0 '' ./game --demo run.demo --mute
rm lanterns.rom
"$curtain" export lanterns -o keys --keys
same 'with --keys it has all commands, and its game is the built-in one' "$("$null" hash lanterns --frames 40)" \
    "$(./keys hash --frames 40)"
check '... and replays its demos' ./keys verify lanterns run.demo
not_here() { ! grep -aq "$1" "$2"; }
check 'the built-in game is not given along' not_here 'Glass Tide' game
refuse 'planted: in curtain it is' '' bash -c "! grep -aq 'Glass Tide' '$curtain' || { echo is there; false; }"
small() { [ "$(stat -c %s game)" -lt $(($(stat -c %s "$curtain") * 2 / 3)) ]; }
check 'nor what debuggers read' small

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
    "$(for word in ' --fullscreen ' ' pause ' ' console ' ' reload ' ' render '; do lists | grep -c -- "$word"; done |
        paste -sd ' ')"
plays='plays Paper \ Lanterns'
for command in 'render' 'hash' 'verify a b' 'pack a' 'list a' 'unpack a b' 'check a' 'sound a' 'export a' 'capture'; do
    # shellcheck disable=SC2086
    says "it does not $command" 2 "lanterns: ${command%% *}: not available; this program only $plays (see --help)" \
        ./game $command
done
says 'nor plays another game' 2 "lanterns: other.rom: cannot open; this program only $plays (see --help)" ./game \
    other.rom
says 'an option that there is not' 2 'lanterns: unknown option --fulscreen (did you mean --fullscreen?)' \
    ./game --fulscreen
check 'it says whose work it is' grep -qF 'Paper \ Lanterns is by You. ' <(./game licences)

# Files that are not whole.
size=$(stat -c %s game)
itself="this program's own file"
for cut in 1 100 5000; do
    head -c $((size - cut)) game >cut
    chmod +x cut
    says "cut short by $cut bytes" 2 \
        "curtain: $itself is truncated: $((size - cut)) bytes, expected $size including its game" ./cut
done
rom=$("$curtain" pack lanterns -o rom && stat -c %s rom)
for at in 1 $((rom / 2)) $((rom - 1)); do
    cp game spoiled
    printf 'X' | dd of=spoiled bs=1 seek=$((size - at)) conv=notrunc 2>/dev/null
    cmp -s game spoiled && printf 'Y' | dd of=spoiled bs=1 seek=$((size - at)) conv=notrunc 2>/dev/null
    says "a byte is another, $at before its end" 2 \
        "curtain: $itself is damaged: the game in it has changed" ./spoiled
done
cp game unreadable
chmod 111 unreadable
as_other() { "$@"; }
if [ "$(id -u)" = 0 ]; then # to whom nothing is unreadable
    chmod a+rx "$scratch"
    as_other() { setpriv --reuid=65534 --regid=65534 --clear-groups "$@"; }
fi
says 'may be run, and not read' 3 "curtain: $itself: cannot be read (Permission denied)" as_other ./unreadable

# What export refuses.
bad 'no game' 'export: expected ROM (see curtain help export)' export
bad 'a game that is not there' 'none: no such file or folder' export none
echo 'nonsense(' >>lanterns/main.lua
bad 'a game with an error' "lanterns: main.lua:$(($(wc -l <lanterns/main.lua) + 1)): unexpected symbol near <eof>" \
    export lanterns -o game
check '... and the program that was there is as it was' is_game ./game
sed -i '$d' lanterns/main.lua
bad 'in place of a folder' 'lanterns: is a folder; name the output file with -o' export lanterns
bad 'in place of a file that is none of its own' \
    'run.demo: already exists and is not an exported program; remove it first' export lanterns -o run.demo
bad 'nor of curtain itself' 'mine: already exists and is not an exported program; remove it first' \
    export lanterns -o "$(cp "$curtain" mine && echo mine)"
says 'in place of an older one' 0 '' "$curtain" export lanterns -o game
says 'where nothing can be written' 3 'curtain: /proc/none/game: cannot be written (No such file or directory)' \
    "$curtain" export lanterns -o /proc/none/game
says 'by an exported program' 2 \
    'lanterns: export: this program is an exported game, Paper \ Lanterns; export with curtain' ./keys export lanterns
says 'by a program without a window' 2 \
    'curtain: export: this program has no window; use curtain, not curtain-null' \
    "$null" export lanterns -o game
bad 'an option of it elsewhere' '--keys does not work with pack (only with export)' pack lanterns --keys
bad 'another one' '--desktop does not work with play (only with export)' play lanterns --desktop

# An entry for the desktop, with an icon.
says 'an entry' 0 '' "$curtain" export lanterns -o 'with a blank/50 $x\ `b` "c"' --desktop
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
bad 'beside files of somebody' 'new.png: already exists; remove it, or choose another file with -o' \
    export lanterns -o "$(touch new.png && echo new)" --desktop
check '... and nothing was written' test ! -e new

# ---- pages and cores: what they are made of stands beside the program, or in its installation ----

mkdir -p tree/bin tree/share/curtain tree/lib/libretro
cp "$null" tree/bin/curtain-null
tool=$PWD/tree/bin/curtain-null
bad() { # NAME LINE ARGUMENT...: of that program
    local name=$1 line=$2
    shift 2
    says "$name" 2 "curtain: $line" "$tool" "$@"
}
bad 'no player' "export: player.html is not next to this program or in its installed share/curtain; run \`make web\` \
in Curtain's source tree" export lanterns --web
bad 'no core' "export: curtain_libretro.so is not next to this program or in its installed lib/libretro; run \
\`make library\` in Curtain's source tree" export lanterns --libretro
check '... and nothing was written' test ! -e lanterns.html -a ! -e lanterns_libretro.so
version=$("$tool" version | sed -n '1s/.*(core \([0-9]*\),.*/\1/p')
player=$PWD/tree/share/curtain/player.html
page() { # CORE [ROM-MARK]
    printf '<meta name="generator" content="Curtain, core %s">\n<title>@TITLE@</title>\n<h1>@TITLE@</h1>\n' "$1"
    printf '<script>%s</script>\n@ROM' "${2-@ROM@}"
}
sed -i 's/title = "[^"]*"/title = "Sun \& <Sea> @ROM@"/' lanterns/rom.lua
page "$version" >"$player"
says 'a page is made, by a program without a window too' 0 '' "$tool" export lanterns --web
same 'with its title' '<title>Sun &amp; &lt;Sea&gt; &#64;ROM&#64;</title>
<h1>Sun &amp; &lt;Sea&gt; &#64;ROM&#64;</h1>' "$(sed -n 2,3p lanterns.html)"
same 'and all that was there' "@ROM$(page "$version" | head -1)" "$(tail -n 1 lanterns.html)$(head -1 lanterns.html)"
sed -n 's,^<script>\(.*\)</script>$,\1,p' lanterns.html | base64 -d >in.rom
"$tool" pack lanterns -o lanterns.rom
check 'and its game, compressed' cmp in.rom lanterns.rom
says 'a page is replaced' 0 '' "$tool" export lanterns --web -o lanterns.html
cp "$player" mine.html
bad 'what is none is not' 'mine.html: already exists and is not an exported page; remove it first' \
    export lanterns --web -o mine.html
bad 'nor is a program' 'game: already exists and is not an exported page; remove it first' export lanterns --web -o game
page $((version + 1)) >"$player"
bad 'a player of another core version' \
    "$player: has core version $((version + 1)), this program has $version; rebuild it with make web" \
    export lanterns --web -o new.html
for wrong in "$(page "$version" '')" "$(page "$version" '@ROM@@ROM@')" "$(page x)" ''; do
    printf '%s' "$wrong" >"$player"
    bad "what is no player: ${#wrong} bytes" "$player: not a player that can hold a game; build one with make web" \
        export lanterns --web -o new.html
done
check '... and nothing was written' test ! -e new.html

cp "$OUT/curtain_libretro.so" tree/lib/libretro/ || not_ok 'the core is there'
core=$PWD/tree/lib/libretro/curtain_libretro.so
says 'a core is made' 0 '' "$tool" export lanterns --libretro
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
says 'a core is replaced' 0 '' "$tool" export lanterns --libretro
touch mine.info
bad 'beside files of somebody' 'mine.info: already exists; remove it, or choose another file with -o' \
    export lanterns --libretro -o mine.so
bad 'what is none is not replaced' 'run.demo.so: already exists and is not an exported core; remove it first' \
    export lanterns --libretro -o "$(cp run.demo run.demo.so && echo run.demo.so)"
bad 'a name that front ends pass over' '--libretro: expected -o with a name that ends in .so, got "lanterns.core"' \
    export lanterns --libretro -o lanterns.core
head -c 5000 "$OUT/curtain_libretro.so" >"$core"
bad 'a core that is none' "$core: not a core that can hold a game; build one with make library" \
    export lanterns --libretro -o new.so
python3 - "$OUT/curtain_libretro.so" "$core" <<'END'
import sys
b = bytearray(open(sys.argv[1], "rb").read())
b[b.index(b"<a game may stand behind curtain") + 60] += 1
open(sys.argv[2], "wb").write(b)
END
bad 'a core of another core version' \
    "$core: has core version $((version + 1)), this program has $version; rebuild it with make library" \
    export lanterns --libretro -o new.so
check '... and nothing was written' test ! -e new.so -a ! -e new.info
bad 'both at once' '--libretro cannot be combined with --web; run export twice' export lanterns --web --libretro
bad 'a page with keys' '--keys cannot be combined with --web' export lanterns --web --keys
bad 'a core with an entry' '--desktop cannot be combined with --libretro' export lanterns --libretro --desktop
bad 'an option of it elsewhere' '--web does not work with pack (only with export)' pack lanterns --web
says 'where nothing can be written' 3 'curtain: /proc/none/a.html: cannot be written (No such file or directory)' \
    "$tool" export lanterns --web -o "$(page "$version" >"$player"; echo /proc/none/a.html)"
finish

#!/usr/bin/env bash
# double_click.sh - a double click on a game or a replay, as a desktop does it: `gio open` finds the type of the file
# and the program by what `curtain register` or `make install` has written, and the window shows the game. The program,
# the user's folder and the files have blanks, Japanese and characters that shells and desktop entries treat specially
# in their names. Errors are shown in a window.
. "$(dirname "$0")/../xserver.sh"
xprop -root -spy _NONE >/dev/null 2>&1 & # the server resets when its last client leaves, and refuses others then
other=$!
for tool in gio xwininfo update-mime-database update-desktop-database desktop-file-validate; do
    command -v $tool >/dev/null || { not_ok "$tool is installed"; finish; }
done
export SDL_AUDIODRIVER=dummy LC_ALL=C.UTF-8 HOME="$scratch/私の ホーム" XDG_CONFIG_HOME="$scratch/config"
unset XDG_DATA_HOME GIO_LAUNCHED_DESKTOP_FILE
export XDG_DATA_DIRS=$scratch/system # of this test alone
own=$HOME/.local/share
program="$scratch/100\$ of \$HOME, \"ゲーム\" & \`co\`\\/curtain"
mkdir -p "${program%/*}" "$XDG_DATA_DIRS/mime/packages" "$own/curtain"
cp "$OUT/curtain" "$program"
printf 'scale = 4\n' >"$own/curtain/curtain.conf"

# With fire in the first frame the dot is elsewhere, for the rest of the run.
game g <<'LUA'
local dot = sprite.put { sprite = 'dot', x = 12, y = 12 }
task.go(function()
  wait(2)
  if pad.down('fire') then dot.x, dot.y = 40, 30 end
end)
LUA
mkdir '遊び 場'
cd '遊び 場' || exit 2
"$curtain" pack ../g -o 'あの ゲーム.rom' >"$scratch/none"
"$curtain" hash ../g --press fire --frames 1200 --record 'ある 記録.demo' >/dev/null
cp 'あの ゲーム.rom' no-ending
head -c 4096 /dev/zero >other.rom
"$curtain" render ../g --frames 60 -o "$scratch/played" >/dev/null
"$curtain" render ../g --demo 'ある 記録.demo' --frames 60 -o "$scratch/replayed" >/dev/null

kind() { gio info -a standard::content-type "$1" 2>&1 | sed -n 's/.*content-type: //p'; }
shows() { # FOLDER: the window shows its frame, four times as large
    screenshot rgb:got.rgb && convert "$scratch/$1/000060.png" -scale 400% -depth 8 rgb:want.rgb && cmp got.rgb want.rgb
}
process() { # the program that a double click has started; none
    local exe
    for exe in /proc/[0-9]*/exe; do
        [ "$(readlink "$exe")" != "${runs:-$program}" ] || { exe=${exe%/exe} && echo "${exe#/proc/}" && return; }
    done
    echo none
}
box() { # the window of an error, which xdotool does not find
    win=$(xwininfo -root -tree | sed -n 's/^ *\(0x[0-9a-f]*\) "Curtain": ().*/\1/p') && [ -n "$win" ]
}
clicks() { # FILE LOOK: opens a window, that LOOK finds
    title=Probe child=none
    gio open "$1" >opened 2>&1 && wait_until "$2" || { cat opened; return 1; }
    child=$(process)
}
opens() { # FILE FOLDER: in a window, that shows the frame
    local is
    clicks "$1" find_window || return
    wait_until shows "$2"
    is=$?
    [ "$child" = none ] || kill -KILL "$child"
    wait_until has_exited
    return $is
}
dismissed() { # a key that comes before the box listens is lost, so it is pressed again
    xdotool windowfocus "$win" key Return 2>/dev/null
    sleep 0.2
    has_exited
}
reports() { # FILE SENTENCE: a window shows an error, and the program ends once it is closed
    clicks "$1" box && wait_until dismissed && grep -F "$2" opened || { cat opened; return 1; }
}
register() { # NAME EXIT-CODE-AND-OUTPUT [ARGUMENT]
    "${runs:-$program}" register ${3:+"$3"} >output 2>&1
    same "$1" "$2" "$? $(cat output)"
}
registered="0 Curtain games (.rom) now open with this program.
Curtain replays (.demo) now open with this program."
removed="0 Curtain games (.rom) no longer open with this program.
Curtain replays (.demo) no longer open with this program."

# ---- curtain register ----
refuse 'before, nobody opens a game' 'Failed to find default application' opens 'あの ゲーム.rom' played
find "$HOME" -type f | sort >before
register 'register' "$registered"
check 'its entry is valid' desktop-file-validate "$own/applications/curtain.desktop"
same 'a game is a game, by its name and without' 'application/x-curtain-rom application/x-curtain-rom' \
    "$(kind 'あの ゲーム.rom') $(kind no-ending)"
check 'a double click plays the game' opens 'あの ゲーム.rom' played
check 'a double click plays the replay' opens 'ある 記録.demo' replayed
check 'a ROM that is no game of Curtain' reports other.rom 'other.rom: not a Curtain ROM'

# ---- where a replay finds its game ----
mkdir -p 'below/demos'
cp 'ある 記録.demo' below/demos/r.demo
check 'a replay without its game names what it needs' reports below/demos/r.demo \
    'r.demo: recorded with the game "probe" (checksum '
cp 'あの ゲーム.rom' below/game.rom
check 'the game may be in the folder above' opens below/demos/r.demo replayed
rm -r below

# ---- again, and back ----
cp -r "$own" "$scratch/once"
register 'register again' "$registered"
check 'changes nothing' diff -r "$scratch/once" "$own"
register 'register --remove' "$removed" --remove
left() { find "$HOME" -type f ! -path '*/share/mime/*' ! -name mimeinfo.cache | sort | diff before - &&
    ! grep -rl curtain "$own/mime" "$own/applications"; }
check 'removes everything' left
entry=$own/applications/curtain.desktop
register 'register --remove again' "0 Nothing to remove: $entry does not exist." --remove
list='[Default Applications]
application/x-curtain-rom=viewer.desktop;'
echo "$list" >"$own/applications/mimeapps.list"
"$program" register >output 2>&1
check 'another default stays, and is named' grep -q 'Another program still opens' output
"$program" register --remove >output 2>&1
same 'and is as it was' "$list" "$(cat "$own/applications/mimeapps.list")"
rm "$own/applications/mimeapps.list"
echo '[Desktop Entry]' >"$entry"
register "an entry that somebody else wrote stays" \
    "0 $entry was not written by curtain register; nothing was changed."
rm "$entry"
mkdir empty 50%
PATH=$scratch/empty "$program" register >output 2>&1
same 'without the desktops'"'"' tools' '3 1' "$? $(grep -c 'update-mime-database failed or is not installed' output)"
cp "$program" 50%/curtain
runs=50%/curtain register 'a path that desktops cannot start' \
    "2 curtain: register: $PWD/50%/curtain: the program's path must not contain %, line breaks or control characters"

# ---- make install ----
"$program" register --remove >/dev/null 2>&1
unset MAKEFLAGS MAKELEVEL MFLAGS
make --no-print-directory -s -C "$repo" PREFIX="$scratch/usr" install >output 2>&1 ||
    not_ok 'make install' "$(cat output)"
export XDG_DATA_DIRS=$scratch/usr/share PATH="$scratch/usr/bin:$PATH" runs=$scratch/usr/bin/curtain
check 'installed for all: a double click plays the game' opens 'あの ゲーム.rom' played
cat >"$XDG_DATA_DIRS/mime/packages/emulator.xml" <<'XML'
<?xml version="1.0" encoding="UTF-8"?>
<mime-info xmlns="http://www.freedesktop.org/standards/shared-mime-info">
  <mime-type type="application/x-emulator"><comment>ROM</comment><glob pattern="*.rom"/></mime-type>
</mime-info>
XML
update-mime-database "$XDG_DATA_DIRS/mime"
same 'an emulator keeps its own ROMs' 'application/x-emulator application/x-curtain-rom' \
    "$(kind other.rom) $(kind 'あの ゲーム.rom')"

finish

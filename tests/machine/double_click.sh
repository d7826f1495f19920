#!/usr/bin/env bash
# double_click.sh - a double click on a game or a replay, as a desktop does it: `gio open` finds the type of the file
# and the program by what `curtain register` or `make install` has written, and the window shows the game. The program,
# the user's folder and the files have blanks, Japanese and characters that shells and desktop entries treat specially
# in their names. Errors are shown in a window.
. "$(dirname "$0")/../xserver.sh"
xprop -root -spy _NONE >/dev/null 2>&1 & # the server resets when its last client leaves, and refuses others then
for tool in gio xwininfo update-mime-database update-desktop-database desktop-file-validate; do
    command -v $tool >/dev/null || { not_ok "$tool is installed"; finish; }
done
export SDL_AUDIODRIVER=dummy LC_ALL=C.UTF-8 HOME="$scratch/私の ホーム" XDG_CONFIG_HOME="$scratch/config"
unset XDG_DATA_HOME GIO_LAUNCHED_DESKTOP_FILE
export XDG_DATA_DIRS=$scratch/system # of this test alone
null=$curtain
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
"$null" pack ../g -o 'あの ゲーム.rom'
"$null" hash ../g --press fire --frames 1200 --record 'ある 記録.demo' >/dev/null
cp 'あの ゲーム.rom' no-ending
head -c 4096 /dev/zero >other.rom
"$null" render ../g --frames 60 -o "$scratch/played" >/dev/null
"$null" render ../g --demo 'ある 記録.demo' --frames 60 -o "$scratch/replayed" >/dev/null

kind() { gio info -a standard::content-type "$1" 2>&1 | sed -n 's/.*content-type: //p'; }
opener() { gio mime "application/x-curtain-$1" 2>/dev/null | sed -n 's/^Default.*: //p'; }
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
ends() {
    [ "$child" = none ] || kill -KILL "$child"
    wait_until has_exited
    child=none
}
box() { # the window of an error, which xdotool does not find
    win=$(xwininfo -root -tree | sed -n 's/^ *\(0x[0-9a-f]*\) "Curtain": ().*/\1/p') && [ -n "$win" ]
}
clicks() { # FILE LOOK: opens a window, that LOOK finds
    title=Probe child=none
    gio open "$1" >opened 2>&1 || { cat opened; return 1; }
    wait_until "$2" || { echo 'no window'; cat opened; return 1; }
    child=$(process)
}
opens() { # FILE FOLDER: in a window, that shows the frame
    local is
    clicks "$1" find_window || return
    wait_until shows "$2"
    is=$?
    ends
    return $is
}
dismissed() { # a key that comes before the box listens is lost, so it is pressed again
    xdotool windowfocus "$win" key Return 2>/dev/null
    sleep 0.2
    has_exited
}
says() { # FILE SENTENCE: a window shows an error, and the program ends once it is closed
    clicks "$1" box || return
    wait_until dismissed || { ends; echo 'it does not end'; return 1; }
    grep -F "$2" opened || { cat opened; return 1; }
}

# ---- before ----
refuse 'before, nobody opens a game' 'Failed to find default application' opens 'あの ゲーム.rom' played
find "$HOME" -type f | sort >before

# ---- curtain register ----
"$program" register >said 2>&1
same 'register' "0 Curtain games (.rom) now open with this program.
Curtain replays (.demo) now open with this program." "$? $(cat said)"
check 'its entry is valid' desktop-file-validate "$own/applications/curtain.desktop"
same 'a game is a game, by its name and without' 'application/x-curtain-rom application/x-curtain-rom' \
    "$(kind 'あの ゲーム.rom') $(kind no-ending)"
same 'a replay is a replay' application/x-curtain-demo "$(kind 'ある 記録.demo')"
same 'both have their default' 'curtain.desktop curtain.desktop' "$(opener rom) $(opener demo)"
check 'a double click plays the game' opens 'あの ゲーム.rom' played
check 'also without an ending' opens no-ending played
check 'a double click plays the replay' opens 'ある 記録.demo' replayed
mkdir -p 'below/demos'
cp 'ある 記録.demo' below/demos/r.demo
check 'a replay without its game names what it needs' says below/demos/r.demo \
    'r.demo: recorded with the game "probe" (checksum '
cp 'あの ゲーム.rom' below/game.rom
check 'the game may be in the folder above' opens below/demos/r.demo replayed
rm below/game.rom
cp -r ../g below/folder
check 'and be a folder' opens below/demos/r.demo replayed
echo '-- changed' >>below/folder/main.lua
check 'another version of it is named' says below/demos/r.demo 'recorded with another version of Probe'
mkdir -p "$own/curtain/roms"
hash=$("$null" verify ../g below/demos/r.demo --json | jq -r .recorded.rom)
cp 'あの ゲーム.rom' "$own/curtain/roms/probe-$hash.rom"
check 'a ROM that is stored for replays comes before it' opens below/demos/r.demo replayed
rm -r "$own/curtain/roms" below/folder
echo none >bad.demo
check 'a replay that is none' says bad.demo 'bad.demo: not a demo'
check 'a ROM that is no game of Curtain' says other.rom 'other.rom: not a Curtain ROM'

# ---- again, with what others have there ----
cp -r "$own" "$scratch/once"
"$program" register >said 2>&1
check 'register again changes nothing' diff -r "$scratch/once" "$own"
"$program" register --remove >said 2>&1
same 'register --remove' "0 Curtain games (.rom) no longer open with this program.
Curtain replays (.demo) no longer open with this program." "$? $(cat said)"
left() { find "$HOME" -type f ! -path '*/share/mime/*' ! -name mimeinfo.cache | sort | diff before - &&
    ! grep -rl curtain "$own/mime" "$own/applications"; }
check 'and nothing is left' left
"$program" register --remove >said 2>&1
same '... and once removed, there is nothing to remove' \
    "0 Nothing to remove: $own/applications/curtain.desktop does not exist." "$? $(cat said)"
check '... a game is not opened any more' eval '! opens no-ending played'
for list in '[Added Associations]
text/plain=a.desktop;' '[Default Applications]
text/plain=a.desktop
application/x-curtain-rom=viewer.desktop;

[Removed Associations]
application/x-curtain-rom=b.desktop'; do
    printf '%s\n' "$list" >"$own/applications/mimeapps.list"
    "$program" register >said 2>&1
    same 'another default stays, and is named' "$(grep -c viewer <<<"$list")" \
        "$(grep -c 'Another program still opens' said)"
    "$program" register --remove >said 2>&1
    same '... and other lines are as they were' "$list" "$(cat "$own/applications/mimeapps.list")"
done
rm "$own/applications/mimeapps.list"
echo '[Desktop Entry]' >"$own/applications/curtain.desktop"
entry=$own/applications/curtain.desktop
for option in '' --remove; do
    "$program" register $option >said 2>&1
    same "an entry that somebody else wrote stays: register $option" \
        "0 $entry was not written by curtain register; nothing was changed. [Desktop Entry]" \
        "$? $(cat said) $(cat "$entry")"
done
rm "$own/applications/curtain.desktop"
mkdir empty
PATH=$scratch/empty "$program" register >said 2>&1
same 'without the desktops'"'"' tools' '3 1' "$? $(grep -c 'update-mime-database failed or is not installed' said)"
"$program" register --remove >/dev/null 2>&1
mkdir 50%
cp "$program" 50%/curtain
50%/curtain register >said 2>&1
same 'a path that desktops cannot start' \
    "2 curtain: register: $PWD/50%/curtain: the program's path must not contain %, line breaks or control characters" \
    "$? $(cat said)"
ln -s "$program" "$scratch/link"
"$scratch/link" register >/dev/null 2>&1
check 'started by a link, it is the program itself' grep -qF 'ゲーム' "$own/applications/curtain.desktop"
"$program" register --remove >/dev/null 2>&1

# ---- make install ----
unset MAKEFLAGS MAKELEVEL MFLAGS
make --no-print-directory -s -C "$repo" PREFIX="$scratch/usr" install >said 2>&1 || not_ok 'make install' "$(cat said)"
export XDG_DATA_DIRS=$scratch/usr/share PATH="$scratch/usr/bin:$PATH" runs=$scratch/usr/bin/curtain
check 'installed for all: a double click plays the game' opens 'あの ゲーム.rom' played
check '... and the replay' opens 'ある 記録.demo' replayed

# An emulator that has *.rom, too.
cat >"$XDG_DATA_DIRS/mime/packages/emulator.xml" <<'XML'
<?xml version="1.0" encoding="UTF-8"?>
<mime-info xmlns="http://www.freedesktop.org/standards/shared-mime-info">
  <mime-type type="application/x-emulator"><comment>ROM</comment><glob pattern="*.rom"/></mime-type>
</mime-info>
XML
update-mime-database "$XDG_DATA_DIRS/mime"
same 'beside an emulator: its ROMs are its own, games are ours' 'application/x-emulator application/x-curtain-rom' \
    "$(kind other.rom) $(kind 'あの ゲーム.rom')"
"$program" register >/dev/null 2>&1
runs=$program
check 'register comes before an installation' opens 'ある 記録.demo' replayed
"$program" register --remove >/dev/null 2>&1
runs=$scratch/usr/bin/curtain
check '... and leaves it as it was' opens 'ある 記録.demo' replayed

# ---- an exported game ----
"$OUT/curtain" export ../g -o probe
title=Probe
./probe 'ある 記録.demo' --scale 4 >said 2>&1 &
child=$!
wait_until find_window
check 'an exported game plays its replays' wait_until shows replayed
kill_program
cp "$repo/roms/testcard/demos/card.demo" .
./probe card.demo >said 2>&1
same '... and no others' '2 probe: card.demo: recorded with the game "testcard"; this program only plays Probe' \
    "$? $(cat said)"
./probe register >said 2>&1
same '... and does not register' 2 $?
finish

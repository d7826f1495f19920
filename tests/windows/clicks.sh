# shellcheck shell=bash disable=SC2154
# clicks.sh - double clicks, for ../windows.sh: on programs, and, after `curtain register`, on games and replays; the
# registry before and after.
child=none # Windows starts them
[ -n "$wm" ] || start_openbox
[ -e moth.exe ] || "$program" export "$repo/examples/moth" >/dev/null 2>&1

leaves() { # the window that a double click has opened, by a key
    xdotool windowactivate --sync "$win" 2>/dev/null
    xdotool keydown ctrl && sleep 1 && xdotool keydown q && sleep 1 && xdotool keyup q keyup ctrl
    wait_until eval '! find_window'
}

# ---- a double click on a program ----
title=$(sed -n 's/.*title = "\([^"]*\)".*/\1/p' "$repo/examples/moth/rom.lua")
wine start "$(as_windows "$scratch/moth.exe")" >/dev/null 2>&1
check 'an exported game opens its window' wait_until find_window
same 'and no console' '' "$(xdotool search --onlyvisible --name moth.exe 2>/dev/null)"
check 'and ends' leaves

# ---- a double click on a game or a replay ----
where=$scratch/クリック\ と\ 空白
mkdir -p "$where" data/curtain
cp "$exe" "$where/curtain.exe"
here() { wine "$where/curtain.exe" "$@" | tr -d '\r'; }
printf 'scale = 4\n' >data/curtain/curtain.conf
# With fire in the first frame the dot is elsewhere, for the rest of the run.
game click <<'LUA'
local dot = sprite.put { sprite = 'dot', x = 12, y = 12 }
task.go(function()
  wait(2)
  if pad.down('fire') then dot.x, dot.y = 40, 30 end
end)
LUA
"$native" pack click -o "$where/あの ゲーム.rom"
"$native" hash click --press fire --frames 3600 --record "$where/ある 記録.demo" >/dev/null
head -c 4096 /dev/zero >"$where/other.rom"
"$native" render click --frames 60 -o clicked-played >/dev/null
"$native" render click --demo "$where/ある 記録.demo" --frames 60 -o clicked-replayed >/dev/null
export XDG_DATA_HOME; XDG_DATA_HOME=$(as_windows "$scratch/data") # as tests/windows/curtain does
frame() { # FOLDER: the window shows its frame, four times as large
    screenshot rgb:got.rgb && convert "$1/000060.png" -scale 400% -depth 8 rgb:want.rgb && cmp got.rgb want.rgb
}
opens() { # FILE FOLDER: in a window, that shows the frame
    local is
    title=Probe
    wine start "$(as_windows "$where/$1")" >opened 2>&1 || { cat opened; return 1; }
    wait_until find_window && wait_until frame "$2"
    is=$?
    leaves
    return $is
}
reports() { # FILE: a box shows an error
    title=Curtain
    wine start "$(as_windows "$where/$1")" >/dev/null 2>&1
    wait_until find_window || return
    xdotool windowactivate --sync "$win" key Return
    wait_until eval '! find_window'
}
classes() { # [KEY]: of the user, and below
    rm -f classes.reg
    wine reg export "HKCU\\Software\\Classes${1:+\\$1}" classes.reg /y >/dev/null 2>&1
    iconv -f UTF-16 -t UTF-8 classes.reg | tr -d '\r'
}
value() { classes "$1" | sed -n 's/^@="\(.*\)"$/\1/p' | head -n 1 | sed 's/\\\(.\)/\1/g'; }
# Windows shows the classes of the user below HKEY_CLASSES_ROOT, Wine 8 only those of the machine.
merge() { # copy | delete
    local key
    for key in .rom .demo Curtain.Game Curtain.Replay; do
        if [ "$1" = copy ]; then
            wine reg copy "HKCU\\Software\\Classes\\$key" "HKLM\\Software\\Classes\\$key" /s /f
        else
            wine reg delete "HKLM\\Software\\Classes\\$key" /f
        fi
    done >/dev/null 2>&1
}
wine reg add 'HKCU\Software\Classes' /f >/dev/null 2>&1 # Windows always has it
classes >classes.before
said='Curtain games (.rom) now open with this program.
Curtain replays (.demo) now open with this program.'
same 'register' "$said" "$(here register)"
there=$(as_windows "$where/curtain.exe")
same 'the program' "\"$there\" play \"%1\"" "$(value 'Curtain.Game\shell\open\command')"
same 'the endings' 'Curtain.Game Curtain.Replay' "$(value .rom) $(value .demo)"
classes >classes.once
merge copy
check 'a double click plays the game' opens 'あの ゲーム.rom' clicked-played
check 'and the replay' opens 'ある 記録.demo' clicked-replayed
check 'a ROM that is no game is reported in a box' reports other.rom
merge delete
here register >/dev/null
same 'register again changes nothing' "$(cat classes.once)" "$(classes)"
same 'register --remove' 'Curtain games (.rom) no longer open with this program.
Curtain replays (.demo) no longer open with this program.' "$(here register --remove)"
same 'and nothing is left' "$(cat classes.before)" "$(classes)"
for root in HKCU HKLM; do wine reg add "$root\\Software\\Classes\\.rom" /ve /d Emulator.Rom /f >/dev/null 2>&1; done
classes >classes.emulator
check 'another program that opens .rom files is named' \
    eval 'here register | grep -q "^Another program still opens Curtain games (.rom)"'
same '... and stays' Emulator.Rom "$(value .rom)"
here register --remove >/dev/null
same '... and register --remove leaves it' "$(cat classes.emulator)" "$(classes)"
for root in HKCU HKLM; do wine reg delete "$root\\Software\\Classes\\.rom" /f >/dev/null 2>&1; done
rm data/curtain/curtain.conf

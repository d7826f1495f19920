#!/usr/bin/env bash
# start.sh - follows the lessons of docs/tutorial as a reader does: runs their commands in order, makes their edits in
# the game that lesson 1 creates, and compares the error messages they show.
#
#     start.sh [--made DIR [LESSON]]   copy the finished game of that lesson, 1 to 3, to DIR, for tools/pictures.sh
. "$(dirname "$0")/../tap.sh"
first=$repo/docs/tutorial/1-first-game.md
second=$repo/docs/tutorial/2-boss-fight.md
third=$repo/docs/tutorial/3-items-and-dialogue.md
sandbox
mkdir bin
cat >bin/curtain <<END
#!/bin/sh
# No window here: play runs 300 frames from the same start.
[ "\$1" != play ] || { shift; set -- hash "\$@" --frames 300 --every 300; }
[ "\$1" != export ] || exec "$OUT/curtain" "\$@" # the exported program needs a window
exec "$curtain" "\$@"
END
chmod +x bin/curtain
PATH=$PWD/bin:$PATH

# Prints "LINE KIND [FILE]" for each code block of the page and writes its text to steps/LINE.
steps() { # PAGE
    rm -rf steps && mkdir steps
    awk '/^```/ { if (on) { on = 0; next } on = FNR; $1 = substr($1, 4); print on, $0; printf "" >("steps/" on); next }
        on { print >("steps/" on) }' "$1"
}
# Replaces the text of steps/FIND in FILE by that of steps/WRITE; FILE must have it exactly once.
edit() { # FILE FIND WRITE
    python3 - "$@" <<'PY'
import sys
file, find, write = sys.argv[1:]
find, write = (open(f"steps/{s}", encoding="utf-8").read().rstrip("\n") for s in (find, write))
text = open(file, encoding="utf-8").read()
if text.count(find) != 1:
    sys.exit(f"{file} has {text.count(find)} times: {find}")
open(file, "w", encoding="utf-8").write(text.replace(find, write))
PY
}
slip() { # FILE WRITE: makes the edit, saves the error message in said.line, and restores the file
    cp "$1" "$1.good"
    edit "$1" "$found" "$2" || return
    curtain play mygame >said 2>&1
    cp "$1.good" "$1"
    rm "$1.good"
    sed 's/^curtain: //' said >said.line
}
# A block is a command (sh), text to find in FILE, its replacement (write), a mistake (slip) whose message is in the
# next block (said), or a new file.
walk() { # PAGE: all blocks in order
    local line kind file found=''
    while read -r line kind file; do
        kind=$kind${file:+ $file} file=${file#* }
        case $kind in
        sh) sh -eu "steps/$line" >told 2>&1 || { echo "line $line: $(cat "steps/$line" told)"; return 1; } ;;
        "lua find "*) grep -qF -- "$(head -1 "steps/$line")" "$file" && found=$line ||
            { echo "line $line: $file has no such line"; return 1; } ;;
        "lua write "*) edit "$file" "$found" "$line" && found=$line || { echo "line $line"; return 1; } ;;
        "lua new "*) [ ! -e "$file" ] && cp "steps/$line" "$file" || { echo "line $line: $file exists"; return 1; } ;;
        "lua slip "*) slip "$file" "$line" || return ;;
        said) diff "steps/$line" said.line || return ;;
        *) echo "line $line: a block of an unknown kind: $kind"; return 1 ;;
        esac
    done < <(steps "$1")
}
lesson1() { # PAGE
    rm -rf mygame out ./*.gif ./*.rom said said.line
    walk "$1"
}
lesson2() { # PAGE: continues with a copy of lesson 1's game
    rm -rf mygame out
    cp -r made1 mygame
    walk "$1"
}
lesson3() { # PAGE: continues with a copy of lesson 2's game
    rm -rf mygame out
    cp -r made2 mygame
    walk "$1"
}
if [ "${1:-}" = --made ]; then
    last=${3:-1}
    lesson1 "$first" && cp -r mygame made1 &&
        { [ "$last" -lt 2 ] || { lesson2 "$second" && cp -r mygame made2; }; } &&
        { [ "$last" -lt 3 ] || lesson3 "$third"; } && cp -r mygame "$2"
    exit
fi

check "lesson 1: every step works, in order" lesson1 "$first"
check "the boss has the new phase" grep -q 'spell = "My First Spell"' mygame/bosses/keeper.lua
check "check finds nothing" "$curtain" check mygame
check "boss.gif is a GIF" test "$(head -c 6 boss.gif)" = GIF89a
"$curtain" capture mygame --stage keeper/feast --invincible --press fire --frames 60:360 -o other.gif
check "it shows the new phase and no other" bash -c '! cmp -s boss.gif other.gif'
check "mygame.rom runs" "$curtain" hash mygame.rom --frames 60
check "the exported program is that game" grep -q mygame <(out/mygame --help)
cp -r mygame made1

sed 's/speed = 4, focus = 1.8, lives/speed = 9, focus = 1.8, lives/' "$first" >bad.md
detects "a line that the game does not have" "has no such line" lesson1 bad.md

pictures() { # SHEET...
    local sheet
    for sheet; do check "out/$sheet.png is a picture" grep -q IHDR "out/$sheet.png"; done
}
check "lesson 2: every step works, in order" lesson2 "$second"
check "check finds nothing" "$curtain" check mygame
pictures entrance portrait moths dawn
cp -r mygame made2
check "lesson 3: every step works, in order" lesson3 "$third"
check "check finds nothing" "$curtain" check mygame
check "the game's tests hold" "$curtain" test mygame
pictures items power ward talk
finish

#!/usr/bin/env bash
# start.sh - docs/tutorial/1-first-game.md, gone through as a reader does: its commands run in their order, its edits
# are made in the game they made, the slip says what the page says, and at the end there is a GIF of the boss that was
# written.
#
#     start.sh [--made DIR]      the game that comes of it goes to DIR, for tools/pictures.sh
. "$(dirname "$0")/../tap.sh"
page=$repo/docs/tutorial/1-first-game.md
sandbox
mkdir bin
cat >bin/curtain <<END
#!/bin/sh
# There is no window here: play is a run of some seconds with the same start.
[ "\$1" != play ] || { shift; set -- hash "\$@" --frames 300 --every 300; }
[ "\$1" != export ] || exec "$OUT/curtain" "\$@" # the page's program is the one with a window
exec "$curtain" "\$@"
END
chmod +x bin/curtain
PATH=$PWD/bin:$PATH

# Prints "LINE KIND [FILE]" of each block of the page, and writes its text to steps/LINE.
steps() { # PAGE
    rm -rf steps && mkdir steps
    awk '/^```/ { if (on) { on = 0; next } on = FNR; $1 = substr($1, 4); print on, $0; printf "" >("steps/" on); next }
        on { print >("steps/" on) }' "$1"
}
# Takes the one place in FILE that has the text of steps/FIND and puts that of steps/WRITE there.
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
slip() { # FILE: with the line of the page in it the game does not begin, and says so
    cp "$1" "$1.good"
    edit "$1" "$found" "$2" || return
    curtain play mygame >said 2>&1
    cp "$1.good" "$1"
    rm "$1.good"
    sed 's/^curtain: //' said >said.line
}
walk() { # PAGE: all steps in their order
    local line kind file found='' n=0
    rm -rf mygame out ./*.gif ./*.rom said said.line
    while read -r line kind file; do
        kind=$kind${file:+ $file} file=${file#* }
        case $kind in
        sh) sh -eu "steps/$line" >told 2>&1 || { echo "line $line: $(cat "steps/$line" told)"; return 1; } ;;
        "lua find "*) grep -qF -- "$(head -1 "steps/$line")" "$file" && found=$line ||
            { echo "line $line: $file has no such line"; return 1; } ;;
        "lua write "*) edit "$file" "$found" "$line" && found=$line || { echo "line $line"; return 1; } ;;
        "lua slip "*) slip "$file" "$line" || return ;;
        said) diff "steps/$line" said.line || return ;;
        *) echo "line $line: a block of an unknown kind: $kind"; return 1 ;;
        esac
        n=$((n + 1))
    done < <(steps "$1")
    [ $n -gt 12 ] || { echo "only $n blocks"; return 1; }
}
if [ "${1:-}" = --made ]; then
    walk "$page" && cp -r mygame "$2"
    exit
fi
check "all of the page can be done, in its order" walk "$page"
check "the boss has the phase that was written" grep -q 'spell = "My First Spell"' mygame/bosses/keeper.lua
check "there is nothing to say about the game" "$curtain" check mygame
film() { [ "$(head -c 6 "$1")" = GIF89a ] && [ "$(wc -c <"$1")" -gt 100000 ]; }
check "there is a GIF" film boss.gif
"$curtain" capture mygame --stage keeper/feast --invincible --press fire --frames 60:360 -o other.gif
check "of that phase, and not of another" bash -c '! cmp -s boss.gif other.gif'
check "and a ROM, which runs" "$curtain" hash mygame.rom --frames 60
check "and a program, which is that game" grep -q mygame <(out/mygame --help)

sed 's/speed = 4, focus = 1.8, lives/speed = 9, focus = 1.8, lives/' "$page" >bad.md
refuse "planted: a line that the game has not" "has no such line" walk bad.md
sed 's/did you mean "speed"/did you mean "spread"/' "$page" >bad.md
refuse "planted: another message" 'did you mean "spread"' walk bad.md
sed 's/pattern.rose {/pattern.rosé {/' "$page" >bad.md
refuse "planted: an edit that does not run" "bosses/keeper.lua" walk bad.md
sed 's/--stage keeper\/mine/--stage keeper\/yours/' "$page" >bad.md
refuse "planted: a command that does not" "keeper/yours" walk bad.md
finish

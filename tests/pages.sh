# shellcheck shell=bash
# pages.sh - sourced by the tests of the pages: a folder where a reader's commands work, and how each kind of code block
# is run. The player has no window here: `curtain play` is checked as `curtain hash` with the same start.
. "$(dirname "${BASH_SOURCE[0]}")/tap.sh"
case $OUT in /*) ;; *) OUT=$PWD/$OUT ;; esac
pages=$PWD/tests/cli
bench=$scratch/bench
mkdir -p "$bench/build" "$scratch/blocks"
cp -r examples "$bench/examples"
cp -r examples/first "$bench/mygame"
ln -s "$PWD/roms" "$bench/roms"
cat >"$bench/build/curtain" <<END
#!/bin/sh
set -eu
[ "\${1:-}" != export ] || exec "$OUT/curtain" "\$@"
[ "\${1:-}" = play ] || exec "$OUT/curtain-null" "\$@"
shift
game=
for word; do
    shift
    case \$word in
    --scale=* | --fullscreen | --mute) continue ;;
    examples/* | roms/* | mygame) game=\$word ;;
    esac
    set -- "\$@" "\$word"
done
[ -n "\$game" ] || set -- roms/glasstide "\$@"
exec "$OUT/curtain-null" hash "\$@" --every 1000
END
chmod +x "$bench/build/curtain"
ln -s curtain "$bench/build/curtain-null"

take() { # the page's blocks into $scratch/blocks
    rm -f "$scratch"/blocks/*
    python3 "$pages/snippets.py" "$1" "$scratch/blocks"
}
run() { # DIR STAGE FRAMES
    "$bench/build/curtain" hash "$1" ${2:+--stage "$2"} --frames "$3" --every 100000 --difficulty normal --verbose
}
game() { # a sandbox of its own, in $game
    game=$scratch/game
    rm -rf "$game"
    cp -r examples/sandbox "$game"
}
piece() { # FILE: a game with that music alone
    game
    echo 'return { title = "Piece", music = { try = { file = "try.mml" } } }' >"$game/rom.lua"
    echo >"$game/main.lua"
    cp "$1" "$game/try.mml"
}
words() { grep -oE "$1\(\"[^\"]+\"" "$2" | sed 's/.*("//; s/"$//'; }

told() { # FILE: what has just run ended with exit code 2 and says what the block after FILE does
    [ $? = 2 ] || { cat "$scratch/fault"; echo "no fault"; return 1; }
    grep -v '^[0-9]' "$scratch/fault" | head -1 | sed 's/^curtain: //; s/^[^ ]*game: //' | diff - "${1%.*}.says"
}
tried() { # as a reader tries it: try.lua in the sandbox as it is
    [ ! -s "$game/try.lua" ] || run "$game" try 60 || { echo "in the sandbox as it is"; return 1; }
}
block() { # FILE: runs it as its kind says
    local file=$1 name
    game
    case $file in
    *.task)
        { echo 'return function(e, p)'; cat "$file"; echo 'end'; } >"$game/try.lua"
        tried || return
        cp "$pages/drive.lua" "$game/main.lua"
        run "$game" drive 600
        ;;
    *.lua)
        cp "$file" "$game/try.lua"
        tried || return
        cp "$pages/drive.lua" "$game/main.lua"
        run "$game" drive 1800 || return
        for name in $(words 'stage\.def' "$file"); do run "$game" "$name" 900 || return; done
        ;;
    *.wide) # in a field wider than the screen
        sed -i 's/^  board = {/  field = { w = 480, view = { w = 240 } },\n&/' "$game/rom.lua"
        cp "$file" "$game/try.lua"
        cp "$pages/drive.lua" "$game/main.lua"
        run "$game" drive 600
        ;;
    *.main)
        cp "$file" "$game/main.lua"
        run "$game" "" 300
        ;;
    *.rom)
        cp "$file" "$game/rom.lua"
        cp "$repo"/examples/tape/music/reel.ogg "$game/music/"
        cp "$repo"/examples/tape/sfx/bell.flac "$game/sfx/"
        cp "$repo"/examples/moth/art/moth.ase "$game/art/"
        "$bench/build/curtain" pack "$game" -o "$scratch/game.rom"
        ;;
    *.main-error) # without what rom.lua gives room for
        sed -i '/^  board = {/,/}, --/d; /^  sounds = {/,/}, --/d' "$game/rom.lua"
        cp "$file" "$game/main.lua"
        run "$game" "" 10 >"$scratch/fault" 2>&1
        told "$file"
        ;;
    *.rom-error)
        cp "$file" "$game/rom.lua"
        "$bench/build/curtain" pack "$game" -o "$scratch/game.rom" >"$scratch/fault" 2>&1
        told "$file"
        ;;
    *.mml)
        piece "$file"
        "$bench/build/curtain" sound "$game" try -o "$scratch/try.wav" >"$scratch/found" &&
            grep -E 'peak -[0-9]{1,2}\.' "$scratch/found"
        ;;
    *.mml-error)
        piece "$file"
        "$bench/build/curtain" pack "$game" -o "$scratch/game.rom" >"$scratch/fault" 2>&1
        told "$file"
        ;;
    *.check) # in a game that has a language too
        mkdir "$game/lang"
        echo 'Hello = Hallo' >"$game/lang/de.txt"
        { printf 'return function(e, p) '; cat "$file"; echo 'end'; } >"$game/try.lua"
        "$bench/build/curtain" check "$game" >"$scratch/found"
        grep '^try.lua' "$scratch/found" | diff - "${file%.*}.says"
        ;;
    *.error)
        { printf 'return function(e, p) '; cat "$file"; echo 'end'; } >"$game/try.lua"
        run "$game" try 120 >"$scratch/fault" 2>&1
        told "$file"
        ;;
    *.tests) # a script of tests/; what it keeps is new
        mkdir -p "$game/tests"
        cp "$file" "$game/tests/try.lua"
        "$bench/build/curtain" test "$game" --update
        ;;
    *.tests-error)
        mkdir -p "$game/tests"
        cp "$file" "$game/tests/try.lua"
        "$bench/build/curtain" test "$game" >"$scratch/found" && return 1
        sed -n '2s/^ *//p' "$scratch/found" | diff - "${file%.*}.says"
        ;;
    *.yaml) # for a CI service: its commands run curtain as the guide says
        python3 "$pages/ci_file.py" "$file"
        ;;
    *.xml) # a BulletML document
        "$bench/build/curtain" bulletml "$file"
        ;;
    *.file)
        sed 1d "$file" | diff - "$(head -1 "$file")"
        ;;
    *.sh)
        (cd "$bench" && grep -vE '^(make|cp) ' "$file" | sed 's/^\(build\/\)\?curtain/build\/curtain/' | sh -eu)
        ;;
    *)
        echo "a block of an unknown kind"
        return 1
        ;;
    esac
}
blocks() { # PAGE KIND...: a test for each block of the page
    local page=$1 file
    take "$page"
    for file in $(ls "$scratch/blocks" | sort -n); do
        case $file in *.none | *.says | *.c | *.make) continue ;; esac
        check "$page:${file%.*} ${file#*.}" block "$scratch/blocks/$file"
    done
}

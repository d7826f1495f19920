#!/usr/bin/env bash
# library.sh - libcurtain: it has the names of curtain.h and no others, and no variable; C++ takes its header; states,
# several boards, slow frames; the example of docs/internals/library.md.
. "$(dirname "$0")/../tap.sh"
sandbox
cc=${CC:-cc}
lua="$(pkg-config --libs lua5.4) -pthread"
for name in states spoil boards slow ship saves run; do
    "$cc" -std=c11 -O1 -g -D_DEFAULT_SOURCE -Wall -Wextra -I"$repo/src/lib" "$repo/tests/machine/library/$name.c" \
        "$OUT/libcurtain.a" $lua -lm -o $name || not_ok "$name.c is built"
done
tap() { # PROGRAM...: its lines
    "$@" >output 2>&1 || not_ok "$*" "$(cat output)"
    while IFS= read -r line; do
        [ "$line" = "${line#ok - }" ] || ok "$1: ${line#ok - }"
    done <output
}

# ---- what it is made of ----

headers=$(grep -o 'curtain_[a-z_]*(' "$repo/src/lib/curtain.h" | tr -d '(' | sort -u)
same 'the archive has the names of curtain.h' "$headers" \
    "$(nm --defined-only --extern-only "$OUT/libcurtain.a" | awk 'NF == 3 { print $3 }' | sort -u)"
same 'so has the shared one' "$headers" \
    "$(nm -D --defined-only "$OUT/libcurtain.so" | awk 'NF == 3 { print $3 }' | sort -u)"
same 'it has no variable' '' "$(nm "$OUT/libcurtain.a" | grep -E ' [bBC] ')"
hosts='^(f?printf|puts|fopen|fwrite|open|write|time|clock|signal|sigaction|setitimer|exit|getenv|pthread_.*|plat_.*)$'
same 'and asks the host for nothing' '' \
    "$(nm -u "$OUT/libcurtain.a" | awk 'NF == 2 { print $2 }' | grep -E "$hosts")"

# ---- states, boards, time ----

for game in torture testcard glasstide; do
    "$curtain" pack "$repo/roms/$game" -o $game.rom >none || not_ok "$game is packed"
done
tap ./states torture.rom
tap ./states glasstide.rom queen/held
tap ./boards testcard.rom torture.rom
tap ./ship glasstide.rom one
mkdir -p tiny/lang
echo 'return { id = "tiny", screen = { w = 64, h = 64 }, board = { bullets = 64, lua_kib = 256 }, players = 2,
  difficulties = { "easy", "hard" }, dip = { coins = { "free", "one" }, pace = { min = 1, max = 5, default = 3 } } }' \
    >tiny/rom.lua
echo 'hello = salut' >tiny/lang/xy.txt
cat >tiny/main.lua <<'LUA'
task.go(function()
  wait(2)
  board.note(rng.int(1, 1000000) + save.get("n", 0))
  board.note(board.difficulty() == "hard" and 1 or 0)
  board.note(board.dip("coins") == "one" and 1 or 0)
  while true do
    if pad.pressed("fire") then save.set("n", save.get("n", 0) + 1) end
    wait(1)
  end
end)
LUA
"$curtain" pack tiny -o tiny.rom >none || not_ok 'tiny is packed'
many=10000
[ -z "${CURTAIN_LONG:-}" ] || many=100000
check "$many spoilt states are refused, or are a run" eval './spoil tiny.rom $many >spoilt'
check 'some of them are a run' grep -v ' 0 runs' spoilt
at_60() { "$curtain" hash tiny.rom --frames 60 --every 60 "$@" | sed -n 's/^60 //p'; }
same 'a seed' "$(at_60 --seed 5)" "$(./run tiny.rom seed 5)"
same 'difficulty, switches and language' "$(at_60 --seed 1 --difficulty hard --dip coins=one --lang xy)" \
    "$(./run tiny.rom difficulty hard switches coins=one lang xy)"
same 'bytes that are no saves' "$(./run tiny.rom)" "$(./run tiny.rom nvram 'what is no nvram is none')"
tap ./saves tiny.rom
tap ./saves glasstide.rom "$repo/roms/glasstide/demos/attract.demo"
check 'no memory is lost or wrong' valgrind -q --error-exitcode=1 --leak-check=full ./run tiny.rom
# slow NAME FAULT LUA: its turn of Lua in frame 40 ends in FAULT.
slow() {
    cp -r tiny "$1"
    echo "task.go(function() for f = 1, 40 do wait(1) end $3 board.note(1) end)" >>"$1/main.lua"
    "$curtain" pack "$1" -o "$1.rom" >none || not_ok "$1 is packed"
    tap ./slow "$1.rom" "$2"
}
at=$(($(wc -l <tiny/main.lua) + 1))
slow long '' 'for i = 1, 5000000 do end'
slow endless "main.lua:$at: infinite loop" 'for i = 1, forever do end'
slow error "main.lua:$at: boo" 'for i = 1, 5000000 do end error("boo")'

check 'C++ takes the header' "${CXX:-c++}" -std=c++11 -fsyntax-only -Wall -Wextra -Werror -x c++ \
    "$repo/src/lib/curtain.h"

# ---- bad input ----

check 'switches are set' ./run tiny.rom switches ' coins=one  pace=5 '
while IFS='|' read -r what value words; do
    refuse "$what: $value" "$words" ./run tiny.rom "$what" "$value"
done <<'WHAT'
difficulty|brutal|unknown difficulty "brutal"
lang|xx|language "xx": no lang/xx.txt in the game
switches|coins|switches: expected NAME=VALUE, got "coins"
switches|coin=one|switches: unknown switch "coin"
switches|pace=9|switches: pace: invalid value "9"
switches|pace=2x|switches: pace: invalid value "2x"
size|40|40 bytes long, but its header says
snapshots|5000|snapshots: expected at most 4096, got 5000
demo|nonsense|demo
WHAT

# ---- the example ----

check 'the example is built' "$cc" -std=c11 -O1 -w -I"$repo/src/lib" "$repo/platform/example/frames.c" \
    "$OUT/libcurtain.so" -Wl,-rpath,"$OUT" -lm -o frames
demo=$repo/roms/testcard/demos/card.demo
same 'it plays a demo' "600 frames, $("$curtain" hash testcard.rom --demo "$demo" --frames 600 --every 600 |
    sed -n 's/^600 //p')" "$(./frames testcard.rom "$demo" 120)"
"$curtain" render testcard.rom --demo "$demo" --frames 120,480 -o want
for frame in 000120 000480; do
    check "its picture $frame is render's" python3 "$repo/tests/golden/png.py" want/$frame.png $frame.png difference.png
done
same 'that many pictures' 4 "$(ls 000*.png | wc -l)"
finish

#!/usr/bin/env bash
# library.sh - libcurtain: it has the names of curtain.h and no others, and no variable; C, C++ and another language
# call it; states, several boards, slow frames; the example of docs/internals/library.md.
. "$(dirname "$0")/../tap.sh"
sandbox
cc=${CC:-cc}
lua="$(pkg-config --libs lua5.4) -pthread"
for name in states spoil boards slow ship host; do
    "$cc" -std=c11 -O1 -g -D_DEFAULT_SOURCE -Wall -Wextra -I"$repo/src/lib" "$repo/tests/machine/library/$name.c" \
        "$OUT/libcurtain.a" $lua -lm -o $name || not_ok "$name.c is built"
done
tap() { # PROGRAM...: its lines, and what it says otherwise
    local said
    said=$("$@" 2>&1) || { not_ok "$*" "$said"; return; }
    while IFS= read -r line; do
        case $line in
        'ok - '*) ok "$1: ${line#ok - }" ;;
        '#'*) echo "$line" ;;
        *) not_ok "$1: $line" ;;
        esac
    done <<<"$said"
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
    "$curtain" pack "$repo/roms/$game" -o $game.rom 2>/dev/null || not_ok "$game is packed"
done
tap ./states torture.rom
tap ./states glasstide.rom queen/held
tap ./boards testcard.rom torture.rom
tap ./ship glasstide.rom one
mkdir tiny
echo 'return { id = "tiny", screen = { w = 64, h = 64 }, board = { bullets = 64, lua_kib = 256 } }' >tiny/rom.lua
cat >tiny/main.lua <<'LUA'
task.go(function()
  while true do
    if pad.pressed("fire") then board.note(rng.int(1, 100)) end
    wait(1)
  end
end)
LUA
"$curtain" pack tiny -o tiny.rom || not_ok 'tiny is packed'
many=10000
[ -z "${CURTAIN_LONG:-}" ] || many=100000
check "$many spoilt states are refused, or are a run" ./spoil tiny.rom $many
cp .said said && sed 's/^/# /' said
check 'some of them are a run' sh -c '! grep -q " 0 runs" said'
mkdir -p given/lang
sed 's/"tiny",/"given", players = 2, difficulties = { "easy", "hard" }, dip = { coins = { "free", "one" } },/' \
    tiny/rom.lua >given/rom.lua
echo 'hello = salut' >given/lang/xy.txt
cat >given/main.lua <<'LUA'
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
"$curtain" pack given -o given.rom || not_ok 'given is packed'
at_60() { "$curtain" hash given.rom --frames 60 --every 60 "$@" | sed -n 's/^60 //p'; }
tap ./host given.rom given "$(at_60 --seed 5)" "$(at_60 --seed 6)" \
    "$(at_60 --seed 5 --difficulty hard --dip coins=one --lang xy)"
tap ./host given.rom saves
tap ./host glasstide.rom attract "$repo/roms/glasstide/demos/attract.demo"
command -v valgrind >/dev/null || not_ok 'valgrind is there'
check 'no memory is lost or wrong when a board is opened 100 times' valgrind -q --error-exitcode=1 --leak-check=full \
    ./boards tiny.rom testcard.rom often
# slow NAME FAULT LUA: its turn of Lua in frame 40 ends in FAULT.
slow() {
    cp -r tiny "$1"
    echo "task.go(function() for f = 1, 40 do wait(1) end $3 board.note(1) end)" >>"$1/main.lua"
    "$curtain" pack "$1" -o "$1.rom" || not_ok "$1 is packed"
    tap ./slow "$1.rom" "$2"
}
at=$(($(wc -l <tiny/main.lua) + 1))
slow long '' 'for i = 1, 5000000 do end'
slow endless "main.lua:$at: infinite loop" 'for i = 1, forever do end'
slow beside "main.lua:$at: infinite loop" 'local s = ("x"):rep(65535) for i = 1, 14000000 do end'
slow below '' 'local s = ("x"):rep(65535) for i = 1, 2250000 do end'
slow error "main.lua:$at: boo" 'for i = 1, 5000000 do end error("boo")'

# ---- other languages ----

cat >plus.cc <<'CC'
#include "curtain.h"
#include <cstdio>
#include <cstdlib>
#include <vector>

int main(int argc, char **argv)
{
    char err[256];
    std::vector<char> rom;
    std::FILE *f = std::fopen(argv[argc - 1], "rb");
    for (int c; (c = std::fgetc(f)) != EOF;)
        rom.push_back((char)c);
    std::fclose(f);
    curtain_config how{};
    how.rom = rom.data();
    how.rom_size = rom.size();
    how.seed = 9;
    std::vector<char> memory(curtain_memory(&how, err, sizeof err));
    curtain *c = curtain_open(&how, memory.data(), memory.size(), err, sizeof err);
    const uint16_t pads[CURTAIN_PADS] = { CURTAIN_FIRE, 0 };
    for (int i = 0; i < 60; i++)
        curtain_frame(c, pads);
    std::printf("60 %016llx\n", (unsigned long long)curtain_hash(c));
    curtain_close(c);
}
CC
cat >calls.py <<'PY'
import ctypes, sys
lib = ctypes.CDLL(sys.argv[1])


class Config(ctypes.Structure):
    _fields_ = [("rom", ctypes.c_char_p), ("rom_size", ctypes.c_size_t), ("seed", ctypes.c_uint64),
                ("difficulty", ctypes.c_char_p), ("lang", ctypes.c_char_p), ("switches", ctypes.c_char_p),
                ("section", ctypes.c_char_p), ("lives", ctypes.c_int), ("invincible", ctypes.c_bool),
                ("nvram", ctypes.c_void_p), ("nvram_size", ctypes.c_size_t), ("demo", ctypes.c_void_p),
                ("demo_size", ctypes.c_size_t), ("state_room", ctypes.c_size_t), ("snapshots", ctypes.c_uint32),
                ("alarm", ctypes.c_bool)]


for name, kind in (("memory", ctypes.c_size_t), ("open", ctypes.c_void_p), ("hash", ctypes.c_uint64)):
    getattr(lib, "curtain_" + name).restype = kind
rom, err = open(sys.argv[2], "rb").read(), ctypes.create_string_buffer(256)
how = Config(rom=rom, rom_size=len(rom), seed=9)
size = lib.curtain_memory(ctypes.byref(how), err, ctypes.c_size_t(256))
memory = ctypes.create_string_buffer(size)
c = ctypes.c_void_p(lib.curtain_open(ctypes.byref(how), memory, ctypes.c_size_t(size), err, ctypes.c_size_t(256)))
for _ in range(60):
    lib.curtain_frame(c, (ctypes.c_uint16 * 2)(16, 0))
print("60 %016x" % lib.curtain_hash(c))
lib.curtain_close(c)
PY
want=$("$curtain" hash testcard.rom --seed 9 --press fire --frames 60 --every 60 | tail -1)
check 'C++ takes the header' "${CXX:-c++}" -std=c++11 -Wall -Wextra -Werror -I"$repo/src/lib" plus.cc \
    "$OUT/libcurtain.a" $lua -lm -o plus
same 'and plays the same' "$want" "$(./plus testcard.rom)"
same 'a call from Python too' "$want" "$(python3 calls.py "$OUT/libcurtain.so" testcard.rom)"

# ---- bad input ----

cat >bad.c <<'C'
#include "common.h"
int main(int argc, char **argv)
{
    struct curtain_config how = { .seed = 1 };
    void *at;
    how.rom = read_file(argv[1], &how.rom_size);
    for (int i = 2; i + 1 < argc; i += 2) {
        const char *what = argv[i], *value = argv[i + 1];
        how.difficulty = !strcmp(what, "difficulty") ? value : how.difficulty;
        how.lang = !strcmp(what, "lang") ? value : how.lang;
        how.switches = !strcmp(what, "switches") ? value : how.switches;
        how.section = !strcmp(what, "section") ? value : how.section;
        how.lives = !strcmp(what, "lives") ? atoi(value) : how.lives;
        how.rom_size = !strcmp(what, "size") ? (size_t)atol(value) : how.rom_size;
        how.snapshots = !strcmp(what, "snapshots") ? (uint32_t)atol(value) : how.snapshots;
        how.demo = !strcmp(what, "demo") ? value : how.demo;
        how.demo_size = how.demo ? strlen(how.demo) : 0;
    }
    struct curtain *c = open_board(&how, &at);
    if (!c)
        return fprintf(stderr, "%s\n", err), 1;
    printf("%s\n", curtain_title(c));
    return 0;
}
C
"$cc" -std=c11 -O1 -I"$repo/src/lib" -I"$repo/tests/machine/library" bad.c "$OUT/libcurtain.a" $lua -lm -o bad
sed 's/board = {/dip = { coins = { "free", "one" }, pace = { min = 1, max = 5, default = 3 } }, board = {/' \
    tiny/rom.lua >tiny/rom.new && mv tiny/rom.new tiny/rom.lua && "$curtain" pack tiny -o dips.rom
check 'switches are set' ./bad dips.rom switches ' coins=one  pace=5 '
while IFS='|' read -r what value words; do
    refuse "$what: $value" "$words" ./bad dips.rom "$what" "$value"
done <<'WHAT'
difficulty|brutal|unknown difficulty "brutal"
lang|xx|language "xx": no lang/xx.txt in the game
lang|aaaaaaaaaaaaaaaaaaaaaaaaa|lang: expected at most 15 characters, got 25
switches|coins|switches: expected NAME=VALUE, got "coins"
switches|coin=one|switches: unknown switch "coin"
switches|coins=two|switches: coins: invalid value "two"
switches|pace=9|switches: pace: invalid value "9"
switches|pace=|switches: pace: invalid value ""
switches|pace=-|switches: pace: invalid value "-"
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

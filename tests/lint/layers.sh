#!/usr/bin/env bash
# layers.sh - every #include obeys the layers.
. "$(dirname "$0")/../tap.sh"

layers() { tree '*.c' '*.h' | xargs python3 tests/lint/layers.py; }
check "every include is of its own layer or below, and no directory is large" layers
layers | sed 's/^/# /'
cycles() { python3 tests/lint/cycles.py "$OUT"; }
check "no symbol is used in a lower layer, and no cycle of objects or file is long" cycles
cycles | cut -c 1-180 | sed 's/^/# /'

long || finish

# planted FILE INCLUDE: the same checks in a copy of the tree with one line more
cp -r --parents src fb platform "$scratch"
planted() {
    cp "$1" "$scratch/kept"
    echo "#include $2" >>"$scratch/$1"
    (cd "$scratch" && find src fb platform -name '*.[ch]' | xargs python3 "$OLDPWD/tests/lint/layers.py")
    local rc=$?
    cp "$scratch/kept" "$scratch/$1"
    return $rc
}
check "the copy is clean" planted src/machine/collision/hit.c '"../../base/geom.h"'
detects "base includes fb" "higher layer" planted src/base/geom.c '"../../fb/fb.h"'
detects "an entity includes the machine" "higher layer" planted src/entities/sparks.c '"../machine/machine.h"'
detects "the machine includes scripts" "higher layer" planted src/machine/work.c '"../script/vm.h"'
detects "scripts include the board" "higher layer" planted src/script/tasks.c '"../board/board.h"'
detects "an entity includes another" "no other but motion.h" planted src/entities/enemies.c '"bullets.h"'
detects "an entity sees Lua" "Lua is not for this file" planted src/entities/fix.c '<lua.h>'
detects "the packer sees Lua" "Lua is not for this file" planted src/workbench/pack/pack.c '<lauxlib.h>'
detects "the board includes the platform" "not for this layer" planted src/machine/video/video.c \
    '"../../../platform/platform.h"'
detects "a port looks inside" "a port includes" planted platform/null.c '"../src/player/input/keys.h"'
detects "a port sees the host's half" "a port includes" planted platform/sdl2.c '"host.h"'
detects "Windows' header in the player" "for the files of Windows alone" \
    planted src/player/verify.c '<windows.h>'
detects "stb in the machine" "stb is for" planted src/machine/video/video.c '<stb/stb_image.h>'
detects "the host's rounding" "for src/base/host.h alone" planted src/base/fx.h '<fenv.h>'
detects "the host's locale" "for src/base/host.h alone" planted src/player/verify.c '<locale.h>'
detects "directories in a cycle" \
    "directories in a cycle: src/player/play -> src/player/overlay (src/player/play/" \
    planted src/player/overlay/page.h '"../play/play.h"'
detects "a library's header" "<sndfile.h> need not be installed" \
    planted src/workbench/samples/sndfile.c '<sndfile.h>'
has_include() {
    planted src/workbench/samples/module.c $'"module.h"\n#if __has_include(<libopenmpt/libopenmpt.h>)\n#endif'
}
detects "a question for one" "<libopenmpt/libopenmpt.h> need not be installed" has_include
for i in $(seq 51); do echo >"$scratch/src/rom/more$i.c"; done
files=$(find "$scratch/src/rom" -name '*.[ch]' | wc -l)
detects "a directory too large" "src/rom: $files files; a directory has 50 at most" \
    planted src/rom/cart.c '"../base/bytes.h"'
rm "$scratch"/src/rom/more*.c

# ---- symbols: in the copy, with the same objects ----

mkdir "$scratch/out"
cp -rs "$PWD/$OUT/src" "$PWD/$OUT/fb" "$scratch/out"
object() { # FILE TEXT: is built in the copy
    echo "$2" >"$scratch/$1"
    rm -f "$scratch/out/${1%c}o"
    ${CC:-gcc} -c -o "$scratch/out/${1%c}o" "$scratch/$1"
}
planted_cycles() { (cd "$scratch" && python3 "$OLDPWD/tests/lint/cycles.py" out); }
check "the copy's objects are clean" planted_cycles
object src/base/up.c 'void board_tick(void); void up(void); void up(void) { board_tick(); }'
detects "base calls the board" "src/base/up.c uses board_tick of src/board/board.c, a higher layer" \
    planted_cycles
rm "$scratch/src/base/up.c"
for i in $(seq 9); do
    object "src/base/round$i.c" "void round$((i % 9 + 1))(void); void (*to$i)(void) = round$((i % 9 + 1)); \
void round$i(void); void round$i(void) {}"
done
detects "nine tables of functions in a ring" "a cycle of 9 objects, at most 8: src/base/round1.c" planted_cycles
rm "$scratch"/src/base/round*.c
yes '' | head -1001 >"$scratch/src/base/long.h"
detects "a long file" "src/base/long.h: 1001 lines, at most 1000" planted_cycles

detects "a clock in base" "there is no <time.h>" planted src/base/rng.h '<time.h>'
finish

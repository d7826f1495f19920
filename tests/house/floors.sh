#!/usr/bin/env bash
# floors.sh - every #include obeys the floors, and a planted one that does not is found.
. "$(dirname "$0")/../tap.sh"

floors() { tree '*.c' '*.h' | xargs python3 tests/house/floors.py; }
check "every include is of its own floor or below, and no room is large or in a circle" floors
floors | sed 's/^/# /'

# planted FILE INCLUDE: the same checks in a copy of the house with one line more
cp -r --parents src fb platform "$scratch"
planted() {
    cp "$1" "$scratch/kept"
    echo "#include $2" >>"$scratch/$1"
    (cd "$scratch" && find src fb platform -name '*.[ch]' | xargs python3 "$OLDPWD/tests/house/floors.py")
    local rc=$?
    cp "$scratch/kept" "$scratch/$1"
    return $rc
}
check "the copy is clean" planted src/board/hits/hit.c '"../../base/geom.h"'
refuse "planted: base includes fb" "higher floor" planted src/base/geom.c '"../../fb/fb.h"'
refuse "planted: a chip includes the board" "higher floor" planted src/chips/shown/pal.c '"../../board/board.h"'
refuse "planted: a chip includes another" "no other chip" planted src/chips/enemies.c '"bullets.h"'
refuse "planted: a chip of a room includes another" "no other chip" planted src/chips/shown/sparks.c '"../bullets.h"'
refuse "planted: a chip sees Lua" "only src/board sees Lua" planted src/chips/shown/fix.c '<lua.h>'
refuse "planted: the cabinet sees Lua" "only src/board sees Lua" planted src/cab/pack/pack.c '<lauxlib.h>'
refuse "planted: the board includes the platform" "only src/cab" planted src/board/draw/video.c \
    '"../../../platform/platform.h"'
refuse "planted: a port looks inside" "a port includes" planted platform/null.c '"../src/cab/host/keys.h"'
refuse "planted: a port sees the host's half" "a port includes" planted platform/sdl2.c '"host.h"'
refuse "planted: Windows' header in the cabinet" "for the files of Windows alone" planted src/cab/verify.c '<windows.h>'
refuse "planted: stb in the board" "stb is for" planted src/board/draw/video.c '<stb/stb_image.h>'
refuse "planted: the host's rounding" "for src/base/host.h alone" planted src/base/fx.h '<fenv.h>'
refuse "planted: the host's locale" "for src/base/host.h alone" planted src/cab/verify.c '<locale.h>'
refuse "planted: rooms in a circle" "rooms in a circle: src/board -> src/board/api (src/board/board.c:" \
    planted src/board/board.c '"api/api_parts.h"'
refuse "planted: a library's header" "<sndfile.h> need not be installed" planted src/cab/sound/sndfile.c '<sndfile.h>'
has_include() { planted src/cab/sound/module.c $'"module.h"\n#if __has_include(<libopenmpt/libopenmpt.h>)\n#endif'; }
refuse "planted: a question for one" "<libopenmpt/libopenmpt.h> need not be installed" has_include
for i in $(seq 27); do echo >"$scratch/src/board/rom/more$i.c"; done
files=$(find "$scratch/src/board/rom" -name '*.[ch]' | wc -l)
refuse "planted: a room too large" "src/board/rom: $files files; a room has 26 at most" \
    planted src/board/rom/cart.c '"../../base/bytes.h"'
rm "$scratch"/src/board/rom/more*.c
refuse "planted: a clock below the cabinet" "there is no <time.h>" planted src/base/rng.h '<time.h>'
finish

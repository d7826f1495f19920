#!/usr/bin/env bash
# floors.sh - every #include obeys the floors, and a planted one that does not is found.
. "$(dirname "$0")/../tap.sh"

floors() { tree '*.c' '*.h' | xargs python3 tests/house/floors.py; }
check "every include is of its own floor or below" floors

# planted FILE INCLUDE: the same checks in a copy of the house with one line more
cp -r --parents src fb platform "$scratch"
planted() {
    cp "$1" "$scratch/kept"
    echo "#include $2" >>"$scratch/$1"
    (cd "$scratch" && python3 "$OLDPWD/tests/house/floors.py" "$1")
    local rc=$?
    cp "$scratch/kept" "$scratch/$1"
    return $rc
}
check "the copy is clean" planted src/board/hits/hit.c '"../base/geom.h"'
refuse "planted: base includes fb" "higher floor" planted src/base/geom.c '"../../fb/fb.h"'
refuse "planted: a chip includes the board" "higher floor" planted src/chips/pal.c '"../board/board.h"'
refuse "planted: a chip includes another" "no other chip" planted src/chips/sparks.c '"bullets.h"'
refuse "planted: a chip sees Lua" "only src/board sees Lua" planted src/chips/fix.c '<lua.h>'
refuse "planted: the cabinet sees Lua" "only src/board sees Lua" planted src/cab/pack/pack.c '<lauxlib.h>'
refuse "planted: the board includes the platform" "only src/cab" planted src/board/draw/video.c \
    '"../../platform/platform.h"'
refuse "planted: a port looks inside" "a port includes" planted platform/null.c '"../src/cab/keys.h"'
refuse "planted: stb in the board" "stb is for" planted src/board/draw/video.c '<stb/stb_image.h>'
refuse "planted: the host's rounding" "for src/base/host.h alone" planted src/base/fx.h '<fenv.h>'
refuse "planted: the host's locale" "for src/base/host.h alone" planted src/cab/verify.c '<locale.h>'
refuse "planted: a clock below the cabinet" "there is no <time.h>" planted src/base/rng.h '<time.h>'
finish

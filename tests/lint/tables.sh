#!/usr/bin/env bash
# tables.sh - the tables of trig.c are what their maker makes.
. "$(dirname "$0")/../tap.sh"
sandbox

if python3 "$repo/tools/trig_tables.py" >made 2>why && cmp -s made "$repo/src/base/trig_tables.h"; then
    ok "tools/trig_tables.py makes src/base/trig_tables.h"
else
    not_ok "tools/trig_tables.py makes src/base/trig_tables.h" "$(cat why)" \
        "$(diff made "$repo/src/base/trig_tables.h" | head -n 5)"
fi
same "as good as trig.c and trig_guess.h say: less than 2^29.4 / 2^40, 4173 / 2^24, and 2.551 / 2^44" yes \
    "$(awk '/sines/ { s = $7 } /arcs/ { a = $7 } /headings/ { h = $7 }
        END { print s && s < 708000000 && a && a < 4173 && h && h < 2.551 ? "yes" : s " " a " " h }' why)"
finish

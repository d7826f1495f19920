#!/usr/bin/env bash
# phases.sh - every phase of every boss of Glass Tide can be survived at every difficulty: tests/demos/phases has a run
# of each, which holds, comes to the phase's end, and in which nobody is hit; the ship is not invincible. make survive
# writes them.
. "$(dirname "$0")/../tap.sh"
program=$OUT/curtain-null
game=roms/glasstide at=tests/demos/phases

wanted() { # each phase and difficulty, as its demo is called
    "$program" survive $game --all --frames 2 --json 2>/dev/null |
        sed -n 's,^{"section":"\([^"/]*\)/\([^"]*\)"\,"difficulty":"\([^"]*\)".*,\1-\2-\3,p' | sort
}
there() { ls "$1" | sed 's/\.demo$//' | sort; }
same 'a demo of each phase at each difficulty' "$(wanted)" "$(there $at)"

for demo in "$at"/*.demo; do echo "$demo"; done >"$scratch/demos"
xargs -P 2 -n 24 "$program" verify --json $game <"$scratch/demos" >"$scratch/told" 2>"$scratch/said"
# unhurt FILE: JSON a line
unhurt() {
    python3 - "$1" "$(wc -l <"$scratch/demos")" <<'END'
import json, sys
sys.path.insert(0, "tests/cli")
from demo_read import read
told = [json.loads(line) for line in open(sys.argv[1])]
assert len(told) == int(sys.argv[2]), "%d of %s demos" % (len(told), sys.argv[2])
ended = 0
for t in told:
    kinds = [m["kind"] for m in t.get("moments", [])]
    assert t["verdict"] == "holds", "%s: %s %s" % (t["file"], t["verdict"], t.get("difference"))
    assert "death" not in kinds, t["file"] + ": somebody is hit"
    ended += "won" in kinds or "lost" in kinds
    assert "phase" in kinds, t["file"] + ": the phase does not begin"
    assert read(open(t["file"], "rb").read())["invincible"] == 0, t["file"] + ": invincible"
assert ended == len(told), "only %d of them come to their end" % ended
END
}
check 'all hold, come to the end, and nobody is hit' unhurt "$scratch/told"
sed '1s/"kind":"phase"/"kind":"death"/' "$scratch/told" >"$scratch/hit"
detects 'one who is hit' 'somebody is hit' unhurt "$scratch/hit"
finish

#!/usr/bin/env bash
# clears.sh - Glass Tide can be played to its end: the demos of tests/demos/glasstide hold, without help and from
# power-on. All difficulties are cleared, and by each craft one; one game is lost, one is played in two. make demos
# records them (tools/demos.sh).
. "$(dirname "$0")/../tap.sh"
program=$OUT/curtain-null
game=roms/glasstide at=tests/demos/glasstide

for demo in "$at"/*.demo; do echo "$demo"; done |
    xargs -P 2 -I{} sh -c '"$1" verify --json "$2" "$3" >"$4/$(basename "$3" .demo).json"' - \
        "$program" $game {} "$scratch"

# says DEMO KEY WANT: what the replay of a demo came to
says() {
    python3 - "$scratch/$1.json" "$2" "$3" <<'END'
import json, sys
told = json.load(open(sys.argv[1]))
got = told
for key in sys.argv[2].split("."):
    got = got.get(key)
if str(got) != sys.argv[3]:
    sys.exit("%s is %s, expected %s; %s" % (sys.argv[2], got, sys.argv[3], told.get("difference")))
END
}
for demo in "$at"/*.demo; do
    name=$(basename "$demo" .demo)
    check "$name holds" says "$name" verdict holds
    check "$name: no help" says "$name" flags '[]'
    check "$name: from power-on" says "$name" start.practice ''
done
for difficulty in easy normal hard abyss; do
    check "$difficulty is cleared" says clear-$difficulty ended clear
    check "... and is $difficulty" says clear-$difficulty difficulty $difficulty
    check "... alone" says clear-$difficulty players 1
done
check 'a game is lost' says lose ended over
check 'a game in two is cleared' says two-players ended clear
check '... in two' says two-players players 2
detects 'another end' 'ended is over, expected clear' says lose ended clear

# Each craft comes through in one of them, alone and in some form; one that has to be earned, too: its demo begins with
# what the one before it left.
cleared_by_all() { # FOLDER
    python3 - "$1" "$game" <<'END'
import glob, json, re, sys
told = [json.load(open(f)) for f in glob.glob(sys.argv[1] + "/clear-*.json")]
flown = [t["ship"] for t in told if t["ended"] == "clear" and t["players"] == 1]
text = open(sys.argv[2] + "/main.lua").read()
ships = re.findall(r'"(\w+)"', re.search(r"\bplayers = \{([^}]*)\}", text)[1])
missing = [s for s in ships if not any(f == s or f.startswith(s + "_") for f in flown)]
sys.exit("nobody comes through in " + ", ".join(missing) if missing or not ships else 0)
END
}
check 'each craft comes through' cleared_by_all "$scratch"

finish

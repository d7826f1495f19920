#!/usr/bin/env bash
# replays.sh - the last runs of a game are kept by themselves: which, as what, for how long; the list with its screen;
# watching, from the run's start, also after the game was changed; taking over, saving under a name, deleting; rows of
# the scores. The port is a script's (port_keys.c): no window, no clock.
. "$(dirname "$0")/../kept.sh"
export KEYS_WHOLE=1
X=27 RIGHT=79 DELETE=76

# A dot that shows frame and chance.
kept_game <<'LUA'
local dot
stage.def("one", function() wait(250) stage.mark "late" wait(forever) end)
task.go(function()
  for i = 1, forever do
    if not dot or not dot.alive then dot = sprite.put { sprite = "dot", x = 0, y = 0, screen = true } end
    dot.x, dot.y = 4 + rng.int(0, 50), 20 + i % 24
    wait(1)
  end
end)
LUA
enters() { keys 400; for _ in 1 2; do keys 1 $Z; keys 6; done; keys 1 $ENTER; keys 400; } # a name: AAA
plays() { # OUT ARGUMENT...: standard input are the keys
    local out=$1
    shift
    ./player play g --no-resume "$@" >"$out" 2>err
}
list() { "$curtain" list "${1:-g}" --replays | sed -E 's,^[^ ]* [^ ]* ,,'; }
demos() { find $folder -name '*.demo' | sort; }
newest() { "$curtain" list g --replays | head -1 | cut -d' ' -f1; }
verdicts() { "$curtain" verify "${1:-g}" $(demos) | sed 's/.*: //' | sort | uniq -c | sed 's/^ *//'; }

# ---- which ----

{ begin; keys 200 $Z; ends; } | plays out --seed 5
same 'a run that was played to its end' '0:04 ship normal 2020 game over' "$(list)"
check 'its recording is of the frames up to there' test "$("$curtain" verify g $(demos) --json | jq .frames)" -lt 480
same 'and holds' '1 holds' "$(verdicts | cut -d, -f1)"
check 'nothing is left to go on with' test ! -e data/curtain/resume/probe.demo
{ begin; keys 250 $Z; } | plays out --seed 6
same 'one that was left' '0:05 ship normal 2520 unfinished' "$(list | head -1)"
{ begin; keys 40 $Z; } | plays out
{ begin; keys 20 $Z; ends; } | plays out
same 'not those that were left or over in three seconds' 2 "$(list | grep -c .)"
{ begin; keys 20; keys 3 $C $DOWN; keys 9; } | plays out
same 'but one that ended in a fault' '0:01 ship normal 20 script error' "$(list | head -1)"
same 'whose recording holds, and ends in it' 'holds, 195 frames, ends in the recorded fault' \
    "$("$curtain" verify g "$(newest)" | sed 's/.*: //')"
{ begin; keys 200 $Z; keys 30 $BACKSPACE; keys 60 $Z; ends; } | plays out
same 'one in which time ran back says so' '0:05 ship normal 2320 game over, branched' "$(list | head -1)"
{ begin; keys 240 $Z; ends; enters; } | plays out
rows() { "$curtain" list g --replays --json | jq -c '.rows[]'; }
same 'a row of the scores is in the replay that entered it' \
    '{"table":"normal","name":"AAA","ship":"","score":2420,"stage":1,"continues":0}' "$(rows | head -1)"
n=$(demos | wc -l)
{ keys 200; } | plays out --stage one --lives 3
{ keys 400; } | plays out --demo "$(newest)"
{ begin; keys 300 $Z; } | XDG_DATA_HOME=$scratch/none plays out --no-resume 2>/dev/null
same 'no try of practice, and no playback' "$n" "$(demos | wc -l)"
same 'they all hold, with the seeds and scores they had' "$n holds" \
    "$(verdicts | cut -d, -f1 | awk '{ n += $1; w = $2 } END { print n, w }')"

# Two in one power-on: a file each, the second from power-on too.
rm -rf data
{ begin; keys 200 $Z; ends; enters; begin; keys 100; keys 200 $Z; ends; } | plays out --seed 5
same 'two runs of one power-on' 2 "$(demos | wc -l)"
firsts=$("$curtain" list g --replays --json | jq .first | tr '\n' ' ')
check 'each begins where it began' test "${firsts%% *}" -gt 900

# ---- how many ----

rm -rf data
mkdir -p data/curtain
echo 'keep_replays = 3' >data/curtain/curtain.conf
for seed in 1 2 3 4 5; do { begin; keys $((190 + seed)) $Z; ends; } | plays out --seed $seed; done
same 'the last three' '1970 1960 1950' "$(list | cut -d' ' -f4 | xargs)"
echo 'keep_replays = 0' >data/curtain/curtain.conf
{ begin; keys 200 $Z; ends; } | plays out
same 'with 0 none is kept, and those that are there stay' 3 "$(demos | wc -l)"
rm data/curtain/curtain.conf

# ---- the screen ----

open_list() { keys 8; keys 1 $ESC; keys 3; keys 1 $DOWN; keys 3; keys 1 $Z; keys 4; }
{ open_list; keys 1 $DOWN; keys 4; } | KEYS_PPM=20 plays list
same 'the list stands over the game' 1 "$(part list 18 20 | sort -u | wc -l)"
colours() { python3 - picture.ppm <<'PY'
import sys
d = open(sys.argv[1], "rb").read()
p = d[d.index(b"255\n") + 4:]
print(len({p[i:i + 3] for i in range(0, len(p), 3)}))
PY
}
check 'with a picture in more colours than its own' test "$(colours)" -ge 3
{ open_list; keys 1 $Z; keys 4; keys 1 $DOWN; keys 3; keys 1 $Z; keys 3; echo "'the be"; echo "'st é"; keys 3
    keys 1 $BACKSPACE; keys 1; keys 1 $BACKSPACE; keys 2; keys 1 $ENTER; keys 9; } | plays out
same 'saved under a name, letter by letter' '0:04 ship normal 1970 game over "the best"' "$(list | head -1)"
{ open_list; keys 1 $Z; keys 4; keys 1 $DOWN; keys 3; keys 1 $Z; keys 3; echo "'other"; keys 2; keys 1 $ESC; keys 9; } |
    plays out
same 'Escape leaves it' 1 "$(list | grep -c 'the best')"
{ open_list; keys 1 $DOWN; keys 2; keys 1 $DELETE; keys 4; keys 1 $ENTER; keys 9; } | plays out
same 'Delete asks, and no is the answer that stands there' 3 "$(demos | wc -l)"
{ open_list; keys 1 $DOWN; keys 2; keys 1 $DELETE; keys 4; keys 1 $DOWN; keys 2; keys 1 $ENTER; keys 9; } | plays out
same 'with yes it is gone' '1970 1950' "$(list | cut -d' ' -f4 | xargs)"
echo 'keep_replays = 1' >data/curtain/curtain.conf
for seed in 6 7; do { begin; keys $((190 + seed)) $Z; ends; } | plays out --seed $seed; done
same 'what has a name does not go by itself' '1990 1970' "$(list | cut -d' ' -f4 | xargs)"
rm data/curtain/curtain.conf

# ---- watching ----

rm -rf data
{ begin; keys 230 $Z; ends; } | plays straight --seed 5
first=$("$curtain" list g --replays --json | jq .first)
last=$("$curtain" list g --replays --json | jq .frames)
watch() { open_list; keys 1 $Z; keys 4; keys 1 $Z; }
shown() { # FILE FROM TO: is that the run from its start? The pictures FROM to TO show frames one after the other.
    local at
    at=$(grep -n "^$(part "$1" "$2" "$2")$" straight | head -1 | cut -d: -f1)
    [ "${at:-0}" -gt "$first" ] && [ "$at" -lt $((first + $2)) ] &&
        [ "$(part "$1" "$2" "$3")" = "$(part straight "$at" $((at + $3 - $2)))" ]
}
{ watch; keys 150; } | plays shown
check 'a replay is shown from the start of its run' shown shown 60 160
same 'and nothing is said' '' "$(cat err)"
{ watch; keys 60; keys 1 $T; keys 100 $X; keys 30; } | plays taken
check 'T takes over, for practice' grep -q . taken
same 'which is not kept, and makes no file' 1 "$(demos | wc -l; ls probe-*.demo 2>/dev/null)"
{ watch; keys $((last - first + 60)); } | plays shown
same 'at its end it waits, and a menu stands' 1 "$(tail -20 shown | sort -u | wc -l)"
{ watch; keys 60; keys 1 $ESC; keys 3
    keys 1 $DOWN; keys 2; keys 1 $DOWN; keys 2; keys 1 $Z; keys 40; } | plays shown --seed 5
same 'and back at the title the pictures are those of a power-on' "$(part straight 10 20)" \
    "$(grep -A 10 "^$(part straight 10 10)$" shown | tail -11)"
{ begin; keys 200 $Z; keys 1 $ESC; keys 3
    keys 1 $DOWN; keys 3; keys 1 $Z; keys 4; keys 1 $Z; keys 4; keys 1 $Z; keys 60; } |
    plays shown
same 'who watches in the middle of a run keeps it' '0:04 ship normal 2020 unfinished' "$(list | head -1)"
check 'and can go on with it' test -s data/curtain/resume/probe.demo
rm -f data/curtain/resume/probe.demo

# The game is another: the replay plays on the ROM that it was played on, and only as long as one needs it.
cp -R g old
rm -rf data
{ begin; keys 230 $Z; ends; } | plays out --seed 5
sed -i 's/rng.int(0, 50)/rng.int(0, 20)/' g/main.lua
{ watch; keys 150; } | plays shown
check 'after the game was changed a replay shows the game as it was' shown shown 60 160
same 'without a word' '' "$(cat err)"
same 'the changed game itself would differ' 1 "$("$curtain" verify g "$(newest)" | grep -c 'differs\|differ ')"
roms() { find data/curtain/roms -name '*.rom' | wc -l; }
same 'its ROM is kept' 1 "$(roms)"
{ begin; keys 230 $Z; ends; } | plays out --seed 5
same 'and the new one with its own first run' 2 "$(roms)"
{ open_list; keys 1 $DOWN; keys 2; keys 1 $DELETE; keys 4; keys 1 $DOWN; keys 2; keys 1 $ENTER; keys 9; } | plays out
same 'with its last replay the old one goes' 1 "$(roms)"
kept=$(echo data/curtain/roms/*.rom)
same 'a kept ROM is one that any command takes' '1 holds' "$(verdicts "$kept" | cut -d, -f1)"
cp old/main.lua g/main.lua
rm "$kept"
{ watch; keys 60; } | plays shown
check 'without it the replay is shown on what there is, and says where it is another' \
    grep -q 'Playback diverged from the recording at frame [0-9]*' err

# Saves and scores go by the game's id, so those of the older game are the newer's.
{ begin; keys 240 $Z; ends; enters; } | plays out
echo 'print(score.rows("normal")[1].score)' >>g/main.lua
sed -i 's/title = "Probe"/title = "Probe II"/; s/bullets = 256/bullets = 300/' g/rom.lua
keys 3 | plays out
same 'a changed game has the scores of the one before' 2420 "$(cat err)"
finish

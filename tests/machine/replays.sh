#!/usr/bin/env bash
# replays.sh - the last runs of a game are saved by themselves: which, as what, for how long; the list with its screen;
# watching, from the run's start, also after the game was changed; saving under a name, deleting; rows of the scores.
# The port is a script's (port_keys.c): no window, no clock.
. "$(dirname "$0")/../kept.sh"
export KEYS_WHOLE=1

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
DELETE=76
# A name is typed; letters, which are fire and bomb in play, and a held Enter do nothing else.
enters() { keys 400; echo "$X 'lx"; keys 1 $X; echo "'ey"; keys 6; press $BACKSPACE; keys 2; echo "'o"; keys 6
    keys 30 $ENTER; keys 400; }
play() { # ARGUMENT...: standard input are the keys
    plays out --no-resume "$@"
}
list() { "$curtain" list g --replays | sed -E 's,^[^ ]* [^ ]* ,,'; }
scores() { list | cut -d' ' -f4 | xargs; }
demos() { find $folder -name '*.demo' | sort; }
newest() { "$curtain" list g --replays | head -1 | cut -d' ' -f1; }
roms() { find data/curtain/roms -name '*.rom' | wc -l; }

# ---- which ----

{ begin; keys 200 $Z; ends; } | play --seed 5
same 'a run that was played to its end' '0:04 ship normal 2020 game over' "$(list)"
check 'its recording ends with it' test "$("$curtain" verify g $(demos) --json | jq .frames)" -lt 480
{ begin; keys 250 $Z; } | play --seed 6
same 'one that was left' '0:05 ship normal 2520 unfinished' "$(list | head -1)"
{ begin; keys 40 $Z; } | play
{ begin; keys 20 $Z; ends; } | play
same 'none of three seconds' 2 "$(list | wc -l)"
{ begin; keys 20; keys 3 $C $DOWN; keys 9; } | play
same 'but one that ended in a fault' '0:01 ship normal 20 script error' "$(list | head -1)"
{ begin; keys 200 $Z; keys 30 $BACKSPACE; keys 60 $Z; ends; } | play
same 'one in which time ran back says so' '0:05 ship normal 2320 game over, branched' "$(list | head -1)"
{ begin; keys 240 $Z; ends; enters; begin; keys 200 $Z; ends; } | play
same 'two runs of one power-on' 6 "$(demos | wc -l)"
same 'a row of the scores is in the replay that entered it' \
    '{"table":"normal","name":"LXEO","ship":"","score":2420,"stage":1,"continues":0}' \
    "$("$curtain" list g --replays --json | jq -c '.rows[]')"
keys 400 | play --stage one --lives 3
keys 400 | play --demo "$(newest)"
same 'no practice, and no playback' 6 "$(demos | wc -l)"
check 'they all hold' "$curtain" verify g $(demos)

# ---- how many ----

rm -rf data
settings 'keep_replays = 3'
for seed in 1 2 3 4 5; do { begin; keys $((190 + seed)) $Z; ends; } | play --seed $seed; done
same 'the last three' '1970 1960 1950' "$(scores)"
settings 'keep_replays = 0'
{ begin; keys 200 $Z; ends; } | play
same 'with 0 none is saved, and the others stay' '1970 1960 1950' "$(scores)"
rm data/curtain/curtain.conf

# ---- the screen ----

open_list() { keys 30; keys 1 $ENTER; keys 20; press $DOWN $DOWN $DOWN; keys 2; keys 1 $Z; keys 4; }
{ open_list; keys 1 $Z; keys 4; press $DOWN; keys 2; keys 1 $Z; keys 3; echo "'the be"; echo "'st é"; keys 3
    press $BACKSPACE $BACKSPACE; keys 1; keys 1 $ENTER; keys 9; } | play
same 'saved under a name' '0:04 ship normal 1970 game over "the best"' "$(list | head -1)"
{ open_list; press $DOWN; keys 1; keys 1 $DELETE; keys 4; keys 1 $ENTER; keys 9; } | play
same 'Delete asks, and No comes first' '1970 1960 1950' "$(scores)"
{ open_list; press $DOWN; keys 1; keys 1 $DELETE; keys 4; press $DOWN; keys 1; keys 1 $ENTER; keys 9; } | play
same 'with Yes it is deleted' '1970 1950' "$(scores)"
settings 'keep_replays = 1'
for seed in 6 7; do { begin; keys $((190 + seed)) $Z; ends; } | play --seed $seed; done
same 'a replay with a name is not discarded' '1990 1970' "$(scores)"

# Rows: sorting, importing, then the replays. A replay: watch, name, favourite, export, delete.
rm -rf data
for seed in 3 4; do { begin; keys $((190 + seed)) $Z; ends; } | play --seed $seed; done
action() { keys 1 $Z; keys 4; for _ in $(seq "$1"); do press $DOWN; keys 1; done; keys 1 $Z; keys 9; }
{ open_list; press $DOWN; keys 1; action 2; } | play
same 'a favourite' 'false true' "$("$curtain" list g --replays --json | jq .favourite | xargs)"
settings 'keep_replays = 1'
{ begin; keys 200 $Z; ends; } | play
same 'is never removed automatically' '2020 1950' "$(scores)"
{ open_list; action 3; } | play
same 'an exported replay is a file' 1 "$(find data/curtain/exports -name 'probe-*.demo' | wc -l)"
{ open_list; keys 1 $DELETE; keys 4; press $DOWN; keys 1; keys 1 $ENTER; keys 9; } | play
same 'which stays when the replay is deleted' 1950 "$(scores)"
{ open_list; press $UP; keys 1; action 0; } | play
same 'and can be imported' '2020 1950' "$(scores)"
same 'with what it says of itself' '{"ship":"ship","difficulty":"normal","stage":"one","favourite":true}' \
    "$("$curtain" list g --replays --json | head -1 | jq -c '{ship, difficulty, stage, favourite}')"
{ open_list; press $UP; keys 1; action 0; } | play
same 'but not again' '2020 1950' "$(scores)"
{ open_list; keys 1 $DELETE; keys 4; press $DOWN; keys 1; keys 1 $ENTER; keys 9; } | play
{ keys 40; echo "=$(find data/curtain/exports -name '*.demo')"; keys 30; echo '=g/main.lua.demo'; keys 9; } | play
same 'one that is dropped on the window is imported too' '2020 1950' "$(scores)"
check 'and a file that cannot be imported is reported' grep -q 'curtain: Cannot import g/main.lua.demo: ' err
{ open_list; press $UP $UP; keys 1; press $RIGHT; keys 1; press $DOWN $DOWN; keys 1; keys 1 $DELETE; keys 4
    press $DOWN; keys 1; keys 1 $ENTER; keys 9; } | play
same 'the best score first: that one is deleted' 1950 "$(scores)"

# ---- watching ----

unset KEYS_WHOLE # what a replay's buttons do is written below it
rm -rf data
{ begin; keys 230 $Z; ends; } | plays straight --seed 5 --no-resume
first=$("$curtain" list g --replays --json | jq .first)
watch() { open_list; keys 1 $Z; keys 4; keys 1 $Z; }
from_its_start() { # the pictures 100 to 200 of out are those of the run's first seconds
    local at
    at=$(grep -n "^$(part out 100 100)$" straight | head -1 | cut -d: -f1)
    [ "${at:-0}" -gt "$first" ] && [ "$at" -lt $((first + 60)) ] &&
        [ "$(part out 100 200)" = "$(part straight "$at" $((at + 100)))" ]
}
{ watch; keys 150; } | play
check 'a replay is shown from the start of its run' from_its_start
same 'without a message' '' "$(cat err)"
{ watch; keys 60; keys 1 $T; keys 100 $X; keys 30; } | play
same 'taking over is practice, and not saved' 1 "$(demos | wc -l)"
{ watch; keys 400; } | play
same 'at its end it waits' 1 "$(tail -20 out | sort -u | wc -l)"
{ watch; keys 400; press $Z; keys 100; } | play
check 'Watch Again shows it again' [ "$(tail -60 out | sort -u | wc -l)" -gt 20 ]
{ watch; keys 60; press $ESCAPE; keys 2; press $DOWN; keys 1; press $DOWN; keys 1; keys 1 $Z; keys 4
    press $ESCAPE; keys 40; } | play --seed 5
keys 30 | plays title --seed 5 # without hints on buttons, as runs have been finished
same 'back from its list at the title the pictures are those of a power-on' "$(part title 10 20)" \
    "$(grep -A 10 "^$(part title 10 10)$" out | tail -11)"
{ begin; keys 200 $Z; press $ESCAPE $DOWN $DOWN $DOWN $DOWN; keys 1 $Z; keys 4; keys 1 $Z; keys 4; keys 1 $Z
    keys 60; } | play
same 'who watches in the middle of a run keeps it' '0:04 ship normal 2020 unfinished' "$(list | head -1)"
check 'and can resume it' test -s data/curtain/resume/probe.demo

# From a replay, and from the menu at its end, one button leads to the list, where Delete asks for the replay's end.
delete() { keys 9; press $DELETE; keys 2; press $DOWN; keys 2; keys 1 $Z; keys 9; }
cp -r data data.kept
{ watch; keys 60; keys 1 $X; delete; } | play
same 'Quit leads from a replay to the list' 1 "$(demos | wc -l)"
rm -rf data && cp -r data.kept data
{ watch; keys 400; keys 1 $X; delete; } | play
same 'Back leads from its end to the list' 1 "$(demos | wc -l)"
rm -rf data && cp -r data.kept data
{ watch; keys 60; keys 1 $ENTER; keys 40; } | play
same 'START pauses it' 1 "$(tail -20 out | sort -u | wc -l)"

# After the game was changed, a replay plays on its own ROM, which is stored as long as a replay needs it.
rm -rf data
{ begin; keys 230 $Z; ends; } | play --seed 5
cp -R g old
sed -i 's/rng.int(0, 50)/rng.int(0, 20)/' g/main.lua
{ watch; keys 150; } | play
check 'after the game was changed a replay shows the game as it was' from_its_start
{ begin; keys 230 $Z; ends; } | play --seed 5
same 'a ROM for each version' 2 "$(roms)"
{ open_list; press $DOWN; keys 1; keys 1 $DELETE; keys 4; press $DOWN; keys 1; keys 1 $ENTER; keys 9; } | play
same 'with its last replay the old one is deleted' 1 "$(roms)"
check 'commands take a stored ROM' "$curtain" verify data/curtain/roms/*.rom $(demos)
cp old/main.lua g/main.lua
rm data/curtain/roms/*
{ watch; keys 60; } | play
unwatched() { ! from_its_start && [ ! -s err ]; }
check 'without it the replay cannot be watched' unwatched

# Saves and scores belong to the game's id, so those of the older game are the newer's.
{ begin; keys 240 $Z; ends; enters; } | play
echo 'print(score.rows("normal")[1].score)' >>g/main.lua
keys 3 | play
same 'a changed game has the scores of the one before' 2420 "$(cat err)"
finish

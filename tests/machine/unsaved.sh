#!/usr/bin/env bash
# unsaved.sh - what cannot be written while a game is played is not lost: scores, replays, an unfinished run, a
# recording and settings are tried again each minute and in the end, the player is told once, and the exit code says so.
# Something else where a file or folder should be is what keeps them from being written: that holds for root, too.
. "$(dirname "$0")/../kept.sh"
kept_game <<'LUA'
stage.def("one", function() wait(forever) end)
local n = 0
task.go(function() while true do n = n + 1 if n == 90 then save.set("n", 1) end wait(1) end end)
LUA
nv=data/curtain/probe.nv left=data/curtain/resume/probe.demo
minute() { keys 3700; }
# Waits until the player has seen what is in the way: it says so.
seen() { for _ in $(seq 1200); do grep -qs "$1" err && return; sleep 0.1; done; }
plays() { ./player play g "$@" >pictures 2>err; echo $?; }
list() { "$curtain" list g --replays | wc -l; }

# ---- what is in the way goes away ----

rm -rf data
mkdir -p "$nv"
got=$({ begin; seen probe.nv; rmdir $nv; minute; } | plays)
same 'scores: said once, saved a minute later' \
    "curtain: $XDG_DATA_HOME/curtain/probe.nv: cannot be written (Is a directory)
curtain: all data has been saved 0" "$(cat err) $got"
check 'scores: they are there' test -s $nv

rm -rf data
mkdir -p data/curtain
touch data/curtain/replays
got=$({ begin; keys 200 $Z; ends; seen replays/; rm data/curtain/replays; minute; } | plays)
same 'a replay: saved a minute later' 'curtain: all data has been saved 0' "$(tail -1 err) $got"
same 'a replay: it is there' 1 "$(list)"
check 'a replay: of the run nothing else is left' test ! -e $left

rm -rf data
mkdir -p data/curtain
touch data/curtain/resume
got=$({ begin; seen resume/; rm data/curtain/resume; minute; } | plays)
same 'an unfinished run: saved a minute later' 'curtain: all data has been saved 0' "$(tail -1 err) $got"
check 'an unfinished run: it is there' "$curtain" verify g $left

rm -rf data
touch way
got=$({ begin; seen way/; rm way; minute; keys 60; } | plays --record way/x.demo)
same 'a recording: saved a minute later' 'curtain: all data has been saved 0' "$(tail -1 err) $got"
check 'a recording: it is whole' "$curtain" verify g way/x.demo

# ---- it stays, or goes away at the end alone ----

rm -rf data
mkdir -p "$nv"
got=$({ begin; minute; } | plays)
same 'scores that are lost: said again at the end, exit code 3' \
    "curtain: $XDG_DATA_HOME/curtain/probe.nv: cannot be written (Is a directory)
curtain: not saved: $XDG_DATA_HOME/curtain/probe.nv: cannot be written (Is a directory) 3" "$(cat err) $got"

rm -rf data
mkdir -p "$nv"
got=$({ begin; seen probe.nv; rmdir $nv; keys 60; } | plays)
same 'scores that can be saved at the end: exit code 0' 0 "$got"
check 'they are there' test -s $nv

# ---- a run that was left stays where it is until there is a replay of it ----

rm -rf data
{ begin; keys 400 $Z; } | plays --seed 5 >code
rm -r data/curtain/replays
touch data/curtain/replays
cp $left was.demo
got=$({ keys 3; keys 1 $DOWN; keys 2; keys 1 $ENTER; begin; keys 300; } | plays)
same 'no replay of a run that was left: exit code 3' 3 "$got"
check 'the run is as it was' cmp -s was.demo $left
rm data/curtain/replays
{ keys 3; keys 1 $DOWN; keys 2; keys 1 $ENTER; keys 60; } | plays >code
same 'the next time there is a replay of it' '1 0' "$(list) $(cat code)"
check 'and nothing is left' test ! -e $left
finish

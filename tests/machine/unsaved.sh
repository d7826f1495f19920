#!/usr/bin/env bash
# unsaved.sh - what cannot be written while a game is played is not lost: scores, replays, an unfinished run and a
# recording are tried again each minute and in the end, the player is told once, and the exit code says so. Something
# else where a file or folder should be is what keeps them from being written: that holds for root, too.
. "$(dirname "$0")/../kept.sh"
kept_game <<'LUA'
stage.def("one", function() wait(forever) end)
local n = 0
task.go(function() while true do n = n + 1 if n == 90 then save.set("n", 1) end wait(1) end end)
LUA
nv=data/curtain/probe.nv left=data/curtain/resume/probe.demo
# seen WORDS: until this has been reported
seen() { until grep -qs "$1" err; do sleep 0.1; done; }
list() { "$curtain" list g --replays | wc -l; }

# ---- what is in the way goes away: a minute later everything is saved ----

# saved_later NAME WORDS PATH KEYS [ARGUMENT...]: the file PATH is in the way until WORDS are reported
saved_later() {
    local name=$1 words=$2 path=$3 keys=$4
    shift 4
    rm -rf data
    mkdir -p "$(dirname "$path")"
    touch "$path"
    { begin; eval "$keys"; seen "$words"; rm "$path"; keys 3700; } | plays out "$@"
    same "$name: saved a minute later" '0 curtain: all data has been saved' "$? $(tail -1 err)"
}
saved_later 'a replay' replays/ data/curtain/replays 'keys 200 $Z; ends'
same 'a replay: it is there' 1 "$(list)"
saved_later 'an unfinished run' resume/ data/curtain/resume ''
check 'an unfinished run: it is there' "$curtain" verify g $left
saved_later 'a recording' way/ way '' --record way/x.demo
check 'a recording: it is whole' "$curtain" verify g way/x.demo
rm -rf data
mkdir -p "$nv"
{ begin; seen probe.nv; rmdir $nv; keys 3700; } | plays out
same 'scores: reported once, saved a minute later' \
    "curtain: $XDG_DATA_HOME/curtain/probe.nv: cannot be written (Is a directory)
curtain: all data has been saved" "$(cat err)"
check 'scores: they are there' test -s $nv

# ---- it stays, or goes away at the end alone ----

rm -rf data
mkdir -p "$nv"
{ begin; keys 3700; } | plays out
same 'scores that are lost: reported again at the end, exit code 3' \
    "3 curtain: $XDG_DATA_HOME/curtain/probe.nv: cannot be written (Is a directory)
curtain: not saved: $XDG_DATA_HOME/curtain/probe.nv: cannot be written (Is a directory)" "$? $(cat err)"
rm -rf data
mkdir -p "$nv"
{ begin; seen probe.nv; rmdir $nv; keys 60; } | plays out
same 'scores that can be saved at the end: exit code 0' 0 $?
check 'they are there' test -s $nv

# ---- a run that was left stays where it is until there is a replay of it ----

rm -rf data
{ begin; keys 400 $Z; } | plays out --seed 5
rm -r data/curtain/replays
touch data/curtain/replays
cp $left was.demo
{ keys 3; press $DOWN $ENTER; keys 60; begin; keys 300; } | plays out
same 'no replay of a run that was left: exit code 3' 3 $?
check 'the run is as it was' cmp was.demo $left
rm data/curtain/replays
{ keys 3; press $DOWN $ENTER; keys 60; } | plays out
same 'the next time there is a replay of it' 1 "$(list)"
check 'and no unfinished run' test ! -e $left
finish

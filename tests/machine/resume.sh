#!/usr/bin/env bash
# resume.sh - a run that was left goes on: where it stood, as what it was, asked first; after a kill as well, and after
# the game was changed; its scores; what is not offered. The port is a script's (port_keys.c): no window, no clock.
. "$(dirname "$0")/../kept.sh"
export KEYS_WHOLE=1

# A save each second; a dot that shows frame and chance.
kept_game <<'LUA'
local dot
stage.def("one", function() wait(forever) end)
task.go(function()
  for i = 1, forever do
    if not dot or not dot.alive then dot = sprite.put { sprite = "dot", x = 0, y = 0, screen = true } end
    dot.x, dot.y = 4 + rng.int(0, 50), 20 + i % 150
    if i % 60 == 0 then save.set("seconds", save.get("seconds", 0) + 1) end
    wait(1)
  end
end)
LUA
left=data/curtain/resume/probe.demo nv=data/curtain/probe.nv
again() { rm -rf data && cp -R "$scratch/was" data; } # as it was when the run was left
list() { "$curtain" list g --replays | sed -E 's,^[^ ]* [^ ]* ,,'; }
recorded() { "$curtain" verify "${2:-g}" "$left" --json | jq -c "$1"; }

# ---- where it stood ----

{ begin; keys 300 $Z; } | plays left --seed 5
frames=$(recorded .frames)
same 'a run that was left is saved' '["holds",[3020,0],[]]' "$(recorded '[.verdict, .score, .flags]')"
cp -R data was
{ begin; keys 500 $Z; } | XDG_DATA_HOME=$scratch/other plays straight --seed 5

keys 6 | plays asked
same 'the next start asks, and the game waits' 1 "$(part asked 2 6 | sort -u | wc -l)"
check 'without an answer the run stays' cmp "$left" was/curtain/resume/probe.demo
{ keys 5; keys 1 $ENTER; keys 100; keys 2 $Z; keys 190 $Z; } | plays went
same 'it resumes' "curtain: g: resumed at frame $frames" "$(cat err)"
same 'and waits, paused' 1 "$(part went 60 100 | sort -u | wc -l)"
next=$(part straight $((frames + 3)) $((frames + 3)))
same 'then the pictures are those of a run that nobody left' "$(part straight $((frames + 3)) $((frames + 150)))" \
    "$(grep -A 147 "^$next$" went)"
same 'its demo says that it was resumed' '["holds",["resumed"]]' "$(recorded '[.verdict, .flags]')"
again
{ keys 100; keys 1 $Z; keys 60 $Z; ends; } | plays went --resume
same '--resume asks nothing' "curtain: g: resumed at frame $frames" "$(cat err)"
same 'played to its end it is one replay' '0:07 ship normal 3630 game over, resumed' "$(list)"
check 'and no unfinished run' test ! -e "$left"
check 'and the hints on buttons are off' grep -qx 'hints = no' data/curtain/curtain.conf
again
{ keys 3; press $DOWN $ENTER; keys 60; } | plays out
check 'a new game ends the unfinished run' test ! -e "$left"
same 'which is a replay' '0:06 ship normal 3020 unfinished' "$(list)"
again
{ begin; keys 60; } | plays out --no-resume
same '--no-resume asks nothing, and keeps the replay' '0:06 ship normal 3020 unfinished' "$(list)"
again
settings 'resume = no'
{ begin; keys 300 $Z; } | plays out
check 'resume = no saves none, and asks nothing' test ! -e "$left"

# ---- scores ----

seconds() { # [ADDED]: the save, after it was changed by so much
    python3 -c 'import sys
d = bytearray(open(sys.argv[1], "rb").read())
at = d.index(b"seconds") + 7
d[at] += int(sys.argv[2])
open(sys.argv[1], "wb").write(d)
print(d[at])' $nv "${1:-0}"
}
saves() { # ADDED: the saves are changed by so much after the run was left; it is resumed
    again
    seconds "$1" >none
    cp $nv changed.nv
    { keys 100; keys 1 $Z; keys 130 $Z; } | plays went --resume
}
again
was=$(seconds)
saves 0
same 'saves continue' $((was + 3)) "$(seconds)"
saves -1
same "saves from a second before, after a kill, are the run's own" $((was + 3)) "$(seconds)"
saves 70
check 'saves of another run are not overwritten' cmp $nv changed.nv
check 'which is reported' grep -q \
    "high scores have changed since the run was interrupted, so its scores are not saved" err

# ---- another game ----

cp -R g old
sed -i 's/rng.int(0, 50)/rng.int(0, 20)/' g/main.lua
again
{ keys 100; keys 1 $Z; keys 60 $Z; } | plays went --resume
same 'after the game was changed the run goes on in the game as it was' '["holds",["resumed"]]' \
    "$(recorded '[.verdict, .flags]' old)"
again
{ keys 5; keys 1 $ENTER; keys 60; } | plays out
same 'in a folder that was changed Enter starts a new game' '' "$(cat err; ls $left 2>/dev/null)"
again
rm data/curtain/roms/*
keys 60 | plays out --resume
check 'without its ROM it cannot' grep -q \
    'Cannot resume the run: the game has changed and its old version is not stored' err
check 'and the run is a replay' test -s "$(echo $folder/*.demo)"
rm -rf g && mv old g
again
python3 "$repo/tests/cli/demo_repair.py" "$left" "$left" 16 7 # the core version
keys 60 | plays out --resume
core=$("$OUT/curtain-null" version | sed -n 's/^curtain .*(core \([0-9]*\),.*/\1/p')
check 'nor can a run of another core version' grep -q \
    "Cannot resume the run: recorded with core version 7; this is version $core" err
again
echo rubbish >$left
keys 60 | plays out
same 'a file that is no demo is reported, and the game starts' \
    "curtain: $PWD/$left: not a demo; the unfinished run is lost" "$(cat err)"

# ---- no unfinished run ----

none_left() { # NAME [ARGUMENT...]: a run with keys of standard input leaves none
    local name=$1
    shift
    rm -rf data
    plays out "$@"
    check "$name leaves none" test ! -e $left
}
none_left 'a run that is over' < <(begin; keys 300 $Z; ends; keys 100)
none_left 'practice' --stage one < <(keys 300)
none_left 'a run of a second' < <(begin; keys 60 $Z)
none_left 'a run that was taken back to before it began' < <(begin; keys 250 $Z; keys 300 $BACKSPACE; keys 60)
none_left 'a run that was ended in the menu' < <(
    begin; keys 250 $Z; press $ESCAPE; keys 3; press $UP $UP $ENTER; keys 3; press $DOWN $ENTER; keys 60
)

# ---- two programs at once: the later one owns the file, and the first reports it ----

rm -rf data
mkfifo hands
./player play g --seed 5 <hands >out 2>first &
first=$!
exec 3>hands
{ begin; keys 200 $Z; } >&3
wait_for out 200
{ begin; keys 250 $Z; } | plays second --no-resume --seed 6
cp $left later.demo
{ keys 200 $Z; ends; } >&3
exec 3>&-
wait $first
same 'two at once: the first reports it' \
    "curtain: Progress is no longer being saved: $scratch/$left: another program has changed the file" "$(cat first)"
check 'and the file is the other one'"'"'s' cmp later.demo $left

# ---- a kill, a full disk ----

rm -rf data
./player play g --seed 5 <hands >out 2>err &
killed=$!
exec 3>hands # open, so that the keys have no end
{ begin; keys 330 $Z; echo; } >&3
wait_for out 500
kill -9 $killed
exec 3>&-
wait $killed 2>/dev/null
{ keys 100; keys 1 $Z; } | plays went --resume
check 'after kill -9 at most a second is lost' grep -qE 'resumed at frame (4[2-9]|5)[0-9][0-9]?' err
rm -rf data
{ begin; keys 250 $Z; ends; } | plays out --seed 5
cp -R data before
(
    trap '' XFSZ
    ulimit -f 8 # KiB of a file
    { begin; keys 250 $Z; ends; keys 60; } | plays out
)
same 'a full disk is reported when it happens and at exit' 'curtain: .demo: cannot be written (File too large)
curtain: .demo: cannot be written (File too large)
curtain: not saved: .demo: cannot be written (File too large)' "$(sed 's|/[^ ]*\.demo|.demo|' err)"
check 'replays from before are unchanged' diff -r data/curtain/replays before/curtain/replays
check 'and no file is half written' test -z "$(find data -name '*.tmp')"
finish

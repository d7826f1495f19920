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
plays() { # OUT ARGUMENT...: standard input are the keys
    local out=$1
    shift
    ./player play g "$@" >"$out" 2>err
}
again() { rm -rf data && cp -R "$scratch/was" data; } # as it was when the run was left
list() { "$curtain" list g --replays | sed -E 's,^[^ ]* [^ ]* ,,'; }
told() { "$curtain" verify "${2:-g}" "$left" --json | jq -c "$1"; }

# ---- where it stood ----

{ begin; keys 300 $Z; } | plays left --seed 5
frames=$(told .frames)
same 'who leaves is kept where he stood' '["holds",[3020,0],[]]' "$(told '[.verdict, .score, .flags]')"
cp -R data "$scratch/was"
{ begin; keys 300 $Z; keys 200 $Z; } | XDG_DATA_HOME=$scratch/other plays straight --seed 5

{ keys 6; } | plays asked
same 'the next start asks, and the game stands behind the question' 1 "$(part asked 2 6 | sort -u | wc -l)"
check 'unanswered the run is still there' cmp -s "$left" "was/curtain/resume/probe.demo"
{ keys 5; keys 1 $ENTER; keys 100; keys 2 $Z; keys 190 $Z; } | plays went
same 'going on says so' "curtain: g: resumed at frame $frames" "$(cat err)"
waits() { part went 60 100 | sort -u | wc -l; }
same 'it waits, paused' 1 "$(waits)"
same 'until a button is pressed; then the pictures are those of a run that nobody left' \
    "$(part straight $((frames + 3)) $((frames + 150)))" \
    "$(grep -A 147 "^$(part straight $((frames + 3)) $((frames + 3)))$" went)"
same 'its demo says that it was resumed, and holds' '["holds",["resumed"]]' "$(told '[.verdict, .flags]')"
same 'of the part before it no replay stays besides' 1 "$(list | wc -l)"
again
{ keys 100; keys 1 $Z; keys 60 $Z; ends; } | plays went --resume
same '--resume asks nothing' "curtain: g: resumed at frame $frames" "$(cat err)"
same 'played to its end it is one replay' '0:07 ship normal 3630 game over, resumed' "$(list)"
check 'and nothing is left' test ! -e "$left"
{ keys 60; } | plays out --resume
same 'with nothing left --resume says that' 'curtain: g: --resume: no unfinished run' "$(cat err)"
again
{ keys 3; keys 1 $DOWN; keys 2; keys 1 $ENTER; keys 60; } | plays out
check 'who begins anew is not asked again' test ! -e "$left"
same 'but the run stays among the replays' '0:06 ship normal 3020 unfinished' "$(list)"
again
{ begin; keys 60; } | plays out --no-resume
same '--no-resume asks nothing; when another run has begun the one before is a replay' \
    '0:06 ship normal 3020 unfinished' "$(list)"
again
rm -r $folder
{ keys 3; keys 1 $DOWN; keys 2; keys 1 $ENTER; keys 60; } | plays out
same 'also when there was none of it yet, as after a kill' '0:06 ship - 3020 unfinished' "$(list)"
again
echo 'resume = no' >data/curtain/curtain.conf
{ begin; keys 300 $Z; } | plays out
check 'resume = no keeps none, and asks nothing' test ! -e "$left"

same '--resume goes on with a start that is given already' 'curtain: --resume cannot be combined with --seed' \
    "$(./player play g --resume --seed 5 2>&1 </dev/null)"
same 'and is no --no-resume' 'curtain: --resume cannot be combined with --no-resume' \
    "$(./player play g --resume --no-resume 2>&1 </dev/null)"

again
{ keys 3; keys 1 $ESC; keys 3; begin; keys 230 $Z; keys 1 $ESC; keys 3 # the question is left, another run begins
    keys 1 $DOWN; keys 2; keys 1 $ENTER; keys 3; keys 1 $ENTER; keys 3; keys 1 $ENTER; keys 99 # a replay is watched
    keys 1 $ESC; keys 3; keys 1 $DOWN; keys 2; keys 1 $DOWN; keys 2; keys 1 $ENTER; keys 9 # back to the game
    keys 1 $ENTER; keys 99; } | plays out # which asks
check 'who left a run to watch a replay is asked when he comes back' grep -q 'resumed at frame 4[0-9]*' err

# ---- scores ----

again
seconds() { python3 -c 'import sys; d = open(sys.argv[1], "rb").read(); at = d.index(b"seconds")
print(int.from_bytes(d[at + 7:at + 15], "little"))' $nv; }
was=$(seconds)
{ keys 100; keys 1 $Z; keys 130 $Z; } | plays out --resume
same 'saves go on where they were' $((was + 3)) "$(seconds)"
again
python3 - $nv <<'PY'
import sys
d = bytearray(open(sys.argv[1], "rb").read())
d[d.index(b"seconds") + 7] = 77
open(sys.argv[1], "wb").write(d)
PY
cp $nv foreign
{ keys 100; keys 1 $Z; keys 130 $Z; } | plays out --resume
check 'saves that came between are not lost to those of the run' cmp -s $nv foreign
check 'which is said' grep -q "high scores have changed since the run was interrupted, so its scores are not saved" err
# A kill leaves saves of up to a second before: these are the run's own.
again
python3 - $nv <<'PY'
import sys
d = bytearray(open(sys.argv[1], "rb").read()); at = d.index(b"seconds") + 7
d[at] -= 1
open(sys.argv[1], "wb").write(d)
PY
{ keys 100; keys 1 $Z; keys 130 $Z; } | plays out --resume
same 'saves from a little before are the run'"'"'s own' $((was + 3)) "$(seconds)"

# ---- another game ----

cp -R g old
again
sed -i 's/rng.int(0, 50)/rng.int(0, 20)/' g/main.lua
{ keys 100; keys 1 $Z; keys 60 $Z; } | plays went --resume
same 'after the game was changed the run goes on in the game as it was' '["holds",["resumed"]]' \
    "$(told '[.verdict, .flags]' old)"
again
{ keys 100; keys 1 $Z; ends; keys 60; } | plays out --resume
same 'and ends there as a replay on its kept ROM' '"game over"' "$("$curtain" list g --replays --json | jq .end)"
again
{ keys 5; keys 1 $ENTER; keys 60; } | plays out
check 'in a folder that was changed Enter begins anew' test ! -e "$left"
same '... and says nothing of going on' '' "$(cat err)"
again
{ keys 3; keys 1 $UP; keys 2; keys 1 $ENTER; keys 100; keys 1 $Z; keys 60 $Z; } | plays went
same 'going on is the row above' "curtain: g: resumed at frame $frames" "$(cat err)"
again
"$curtain" pack g -o g.rom
{ keys 5; keys 1 $ENTER; keys 100; keys 1 $Z; keys 60 $Z; } | ./player play g.rom >went 2>err
same 'in a ROM that was changed it goes on' "curtain: g.rom: resumed at frame $frames" \
    "$(cat err)"
rm g.rom
again
rm data/curtain/roms/*
{ keys 60; } | plays out --resume
check 'without its ROM it cannot, which is said' grep -q \
    'Cannot resume the run: the game has changed and its old version is not stored' err
check 'and Saves the unfinished run as a replay.' test -s "$(echo $folder/*.demo)"
again
cp old/main.lua g/main.lua
python3 "$repo/tests/cli/png_make.py" g/art/all.png 16 16 cccccc
{ keys 100; keys 1 $Z; keys 60 $Z; } | plays went --resume
same 'a changed picture is no other game' '["holds",["resumed"]]' "$(told '[.verdict, .flags]')"
rm -rf g && cp -R old g
again
python3 "$repo/tests/cli/demo_repair.py" "$left" "$left" 16 7 # the core version
{ keys 60; } | plays out --resume
check 'a run of another core version does not go on, which is said' grep -q \
    'Cannot resume the run: recorded with core version 7; this is version 9' err
again
echo rubbish >$left
{ keys 60; } | plays out
same 'a file that is none is named by its real path, and the game begins' \
    "curtain: $PWD/$left: not a demo; the unfinished run is lost" "$(cat err)"

# ---- nothing to go on with ----

rm -rf data
{ begin; keys 300 $Z; ends; keys 100; } | plays out
check 'a run that is over leaves none' test ! -e $left
keys 300 | plays out --stage one
check 'practice leaves none' test ! -e $left
{ begin; keys 60 $Z; } | plays out
check 'nor the first seconds of a run' test ! -e $left
{ begin; keys 250 $Z; keys 300 $BACKSPACE; keys 60; } | plays out
check 'nor one that was taken back to before it began' test ! -e $left
# The menu's last row but one.
{ begin; keys 250 $Z; keys 1 $ESC; keys 3; for _ in 1 2; do keys 1 $UP; keys 2; done; keys 1 $ENTER; keys 3
    keys 1 $DOWN; keys 2; keys 1 $ENTER; keys 60; } | plays out
check 'nor one that was ended in the menu' test ! -e $left
same 'which is a replay' '0:05 ship normal 2520 unfinished' "$(list | head -1)"

# ---- two programs at once ----

# The later one has the place; the first says so, once, and lets the later one's file be.
rm -rf data
mkfifo hands
./player play g --seed 5 <hands >out 2>first &
first=$!
exec 3>hands
{ begin; keys 200 $Z; } >&3
until [ "$(wc -l <out)" -ge 200 ] || ! kill -0 $first 2>/dev/null; do sleep 0.05; done
{ begin; keys 250 $Z; } | plays second --no-resume --seed 6
cp $left later.demo
{ keys 200 $Z; ends; } >&3
exec 3>&-
wait $first
same 'two at once: the first says it' \
    "curtain: Progress is no longer being saved: $scratch/$left: another program has changed the file" "$(cat first)"
check '... and the file is the second one'"'"'s' cmp later.demo $left
same '... both are replays, the first also as the second found it' 3 "$(list | wc -l)"

# ---- a kill, a full disk ----

rm -rf data
./player play g --seed 5 <hands >out 2>err &
killed=$!
exec 3>hands # open, so that the keys have no end
{ begin; keys 330 $Z; echo; } >&3
until [ "$(wc -l <out)" -ge 500 ] || ! kill -0 $killed 2>/dev/null; do sleep 0.05; done
kill -9 $killed
exec 3>&-
wait $killed 2>/dev/null
{ keys 100; keys 1 $Z; } | plays went --resume
check 'after kill -9 at most a second is lost' grep -qE 'resumed at frame (4[2-9]|5)[0-9][0-9]?' err
rm -rf data
{ begin; keys 250 $Z; ends; } | plays out --seed 5
cp -R data before
rm -r data/curtain/roms
full() { # MOST: no file may have more KiB
    (
        trap '' XFSZ
        ulimit -f "$1"
        { begin; keys 250 $Z; ends; keys 60; } | plays out
    )
}
full 100
same 'no room for the ROM: said once, and at the end' \
    'curtain: .rom: cannot be written (File too large)
curtain: not saved: .rom: cannot be written (File too large)' "$(sed 's|/[^ ]*\.rom|.rom|' err)"
mkdir -p data/curtain/roms && cp before/curtain/roms/* data/curtain/roms
full 8
same 'no room for the recording either' \
    'curtain: .demo: cannot be written (File too large)
curtain: .demo: cannot be written (File too large)
curtain: not saved: .demo: cannot be written (File too large)' "$(sed 's|/[^ ]*\.demo|.demo|' err)"
check 'what was kept before is as it was' diff -r data/curtain/replays before/curtain/replays
check 'and no half of a file' test -z "$(find data -name '*.tmp')"
rm -rf data
mkdir -p data/curtain && touch data/curtain/replays
{ begin; keys 250 $Z; ends; keys 60; } | plays out
check 'no folder can be made: said once' grep -qE '^curtain: .*: cannot be written \(Not a directory\)' err
same 'and at the end' 2 "$(grep -c . err)"
finish

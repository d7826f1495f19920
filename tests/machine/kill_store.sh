#!/usr/bin/env bash
# kill_store.sh - what is kept of runs is old or new, whenever the program is killed: with -9, 50 times, in the frames
# in which replays, their cards, kept ROMs and the run that is on are written. The moments are pictures that the process
# showed, not times; how far it has come by then is chance.
. "$(dirname "$0")/../kept.sh"
kept_game <<'LUA'
stage.def("one", function() wait(forever) end)
LUA
settings 'keep_replays = 6'
{ begin; keys 200 $Z; keys 60 $C; keys 120; } >script
plays pictures <script
begun=$("$curtain" list g --replays --json | jq .first) over=$("$curtain" list g --replays --json | jq .frames)
same 'a run in '"$over"' frames' '' "$(cat err)"

cat >kill.py <<'END'
"""Plays by the script: so many polls, whose pictures are waited for, then the next ones, in which it is killed after as
many turns of a loop as are told. Prints 1 if it was killed."""
import os, signal, subprocess, sys
at, turns = int(sys.argv[1]), int(sys.argv[2])
lines = open("script", "rb").read().splitlines(True)
run = subprocess.Popen(["./player", "play", "g", "--no-resume"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                       stderr=subprocess.DEVNULL, bufsize=0)
run.stdin.write(b"".join(lines[:at]))
shown, chunk = 0, b"-"
while chunk and shown < at:
    chunk = os.read(run.stdout.fileno(), 4096)
    shown += chunk.count(b"\n")
run.stdin.write(b"".join(lines[at:at + 4]))
for _ in range(turns):
    pass
run.send_signal(signal.SIGKILL)
print(int(run.wait() == -9))
END

# One after another on the same data, each on a changed game in every third round, so that ROMs come and go.
wrong='' killed=0
complain() { wrong+="at $at: $1"$'\n'; }
while read -r at turns; do
    before=$("$curtain" list g --replays | head -6 | wc -l)
    [ $((at % 3)) = 0 ] && echo "-- $at" >>g/main.lua
    killed=$((killed + $(python3 kill.py "$at" "$turns")))
    "$curtain" list g --replays >listed 2>said || complain "the list: $(cat said)"
    [ "$(wc -l <listed)" -ge "$before" ] || complain 'fewer replays than before'
    [ ! -s said ] || complain "the list says: $(cat said)"
    while read -r file _; do # each plays on the ROM that is stored for it, up to its end
        rom=$(find data/curtain/roms -name "probe-$("$curtain" verify g "$file" --json | jq -r .recorded.rom).rom")
        got=$("$curtain" verify "${rom:-none}" "$file" 2>&1)
        case $got in *': holds, '*) ;; *) complain "$got" ;; esac
    done < <(tail -2 listed; head -2 listed)
    if [ -e data/curtain/resume/probe.demo ]; then
        "$curtain" hash g --demo data/curtain/resume/probe.demo --every 1000 >/dev/null 2>said ||
            complain "the unfinished run: $(cat said)"
    fi
done < <(python3 -c 'import random, sys; random.seed(3); begun, over = map(int, sys.argv[1:])
for _ in range(50):  # before a run begins, before it is over, anywhere; up to some milliseconds later
    print(random.choice([begun - 1, over - 1, over - 1, random.randrange(begun, over)]), random.randrange(300000))' \
    "$begun" "$over")
same 'killed 50 times, all that is kept is whole' '' "$wrong"
same 'it was killed each time' 50 $killed
{ cat script; cat script; } | plays pictures --no-resume
same 'and it still saves' '' "$(cat err)"
same 'as many as it should' 6 "$("$curtain" list g --replays | wc -l)"
find data/curtain/roms -name '*.rom' -exec basename {} .rom \; | sed 's/probe-//' | sort >roms
same 'no more ROMs than replays need' "$("$curtain" list g --replays --json | jq -r .rom | sort -u)" "$(cat roms)"
same 'what the kills left half written is swept out' 0 "$(find $folder -name '*.tmp' | wc -l)"
finish

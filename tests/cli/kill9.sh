#!/usr/bin/env bash
# kill9.sh - a recording that is killed with -9 at 50 random moments of a whole run plays up to all but its last 60
# frames. The moments are frames the process printed, not times; what it printed after them, until it was dead, counts.
. "$(dirname "$0")/../tap.sh"
sandbox
rom=$repo/roms/glasstide
"$curtain" pack "$rom" -o game.rom
cp "$rom/demos/run.demo" .
"$curtain" hash game.rom --demo run.demo 2>/dev/null --every 60 >whole
frames=$(python3 "$repo/tests/cli/demo_read.py" run.demo | sed -n 's/^end \([0-9]*\) .*/\1/p')
check "the whole run: $frames frames" [ "$frames" -gt 10000 ]

cat >kill.py <<'END'
"""Records the run, kills the recorder after the frame told, prints the last frame that it printed."""
import fcntl, os, signal, subprocess, sys
program, at, out = sys.argv[1], int(sys.argv[2]), sys.argv[3]
run = subprocess.Popen(["stdbuf", "-oL", program, "hash", "game.rom", "--demo", "run.demo", "--record", out,
                        "--trace", "script"],  # a line a frame that begins with it, and costs less than its hash
                       stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, bufsize=0)
fcntl.fcntl(run.stdout, fcntl.F_SETPIPE_SZ, 4096)  # so that it is not far ahead of what was read
seen = bytearray()

def printed():
    """The last frame of which the whole line is there, or 0; a line of the trace can be long, a chunk end anywhere."""
    return int(seen[seen.rfind(b"\n", 0, max(seen.rfind(b"\n"), 0)) + 1:].split()[0]) if b"\n" in seen else 0

chunk = b"-"
while chunk and printed() < at:
    chunk = os.read(run.stdout.fileno(), 512)
    seen += chunk
run.send_signal(signal.SIGKILL)
while chunk:
    chunk = os.read(run.stdout.fileno(), 65536)
    seen += chunk
print(printed(), run.wait())
END
wrong='' short=0 least=999999 most=0
moments='import random, sys; random.seed(9); print(*(random.randrange(1, int(sys.argv[1]) - 400) for _ in range(50)))'
for at in $(python3 -c "$moments" "$frames"); do
    rm -f cut.demo
    read -r printed code < <(python3 kill.py "$curtain" "$at" cut.demo)
    [ "$code" = -9 ] || wrong+="at $at it ended by itself ($code)"$'\n'
    "$curtain" hash game.rom --demo cut.demo --every 60 >played 2>said # what is cut short ends in a whole second
    got=$(tail -1 played | cut -d' ' -f1)
    grep -q "cut.demo: truncated (no end mark); playing the first $got frames" said ||
        wrong+="at $at: $(cat said)"$'\n'
    [ "${got:-0}" -ge $((printed - 60)) ] || wrong+="at $at: $printed frames were printed, $got play"$'\n'
    head -n $((got / 60 + 1)) whole | cmp -s - played || wrong+="at $at: the $got frames are not those of the run"$'\n'
    short=$((short + (got < frames)))
    least=$((printed < least ? printed : least)) most=$((printed > most ? printed : most))
done
same "killed 50 times, between frames $least and $most" '' "$wrong"
same 'each time before its end' 50 $short

# What it keeps can be recorded on: the cut demo, played and recorded, holds.
"$curtain" hash game.rom --demo cut.demo --record mended.demo --every 1000 >/dev/null 2>&1
got=$("$curtain" verify game.rom mended.demo)
same 'a cut recording, recorded again, holds' "mended.demo: holds, $(tail -1 played | cut -d' ' -f1) frames" "$got"
finish

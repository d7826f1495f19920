#!/usr/bin/env bash
# losses.sh - playing on a host where things go wrong: a recording for which there is no room, a terminal that is
# closed, a score file that is damaged. In SDL's own dummy window.

# Under nohup SIGHUP is ignored, here and in all that is started from here, and a shell cannot undo that.
python3 - "$0" <<'PY' || exec python3 -c 'import os, signal, sys
signal.signal(signal.SIGHUP, signal.SIG_DFL)
os.execv(sys.argv[1], sys.argv[1:])' "$0" "$@"
import signal, sys
sys.exit(signal.getsignal(signal.SIGHUP) == signal.SIG_IGN)
PY
. "$(dirname "$0")/../tap.sh"
sandbox
export SDL_VIDEODRIVER=dummy SDL_AUDIODRIVER=dummy
windowed=$OUT/curtain
scores=$XDG_DATA_HOME/curtain/probe.nv

game g <<'LUA'
task.go(function()
  for i = 1, forever do
    save.set("n", save.get("n", 0) + 1)
    if i == 30 then print("thirty frames") end
    wait(1)
  end
end)
LUA

# plays until its 30th frame, then SIGNAL; what it said is in out and err, its exit code in $got
play_until() { # SIGNAL ARGUMENT...
    local signal=$1 child
    shift
    rm -f out err
    "$windowed" play g "$@" >out 2>err </dev/null &
    child=$!
    while kill -0 $child 2>/dev/null && ! grep -qs 'thirty frames' out err; do sleep 0.05; done
    kill "-$signal" $child 2>/dev/null
    wait $child
    got=$?
}

mknod full c 1 7 2>/dev/null || ln -s /dev/full full # root would lose /dev/full to a program that replaces it
play_until TERM --record full
same 'a recording without room says so, is played, and says so at the end' \
    'curtain: full: cannot be written (No space left on device)
curtain: full: cannot be written (No space left on device) 3' "$(grep curtain err) $got"

saved() { # how often it was counted, at least 30
    "$windowed" hash g --frames 1 >/dev/null && [ -s "$scores" ] && python3 - "$scores" <<'PY'
import sys
image = open(sys.argv[1], "rb").read()
assert len(image) == 16 and image[:8] == b"NV02\1\1\10n" and int.from_bytes(image[8:], "little") >= 30, image[:60]
PY
}
for signal in TERM HUP; do # a shell lets what runs in its background ignore INT
    rm -f "$scores"
    play_until $signal
    same "SIG$signal ends it well" 0 "$got"
    check "SIG$signal: the saves are written" saved
done
rm -rf "$scores"
mkdir -p "$scores"
play_until TERM
same 'scores that cannot be saved: said, and why' "curtain: $scores: cannot be written (Is a directory)" \
    "$(grep -m 1 curtain: err)"
same 'and at the end, with exit code 3' \
    "curtain: not saved: $scores: cannot be written (Is a directory) 3" "$(grep curtain: err | tail -1) $got"
rmdir "$scores"

mkdir -p "$(dirname "$scores")"
damaged() { # NAME BYTES
    head -c "$2" /dev/zero | tr '\0' '\377' >"$scores"
    cp "$scores" was
    play_until TERM
    same "$1: said" \
        "curtain: $scores is damaged; renamed to $XDG_DATA_HOME/curtain/$3, and the score table starts empty" \
        "$(grep curtain: err)"
    check "$1: kept" cmp -s was "$XDG_DATA_HOME/curtain/$3"
    check "$1: begun anew" saved
}
damaged 'a damaged score file' 500 probe.nv.damaged
damaged 'an empty one' 0 probe.nv.damaged-2

# A score file of before: 256 saves and 16 tables, all of which come along.
cp "$repo/tests/machine/nvram-1.nv" "$scores"
play_until TERM
same 'a score file of core version 4: nothing is said' '' "$(grep curtain: err)"
taken_over() {
    python3 - "$scores" "$repo/tests/machine/nvram-1.nv" <<'PY'
import sys
image, old = (open(name, "rb").read() for name in sys.argv[1:])
assert image[:4] == b"NV02" and old[:4] == b"NV01"
at, names = 4, []
while at < len(image):
    kind, n, m = image[at:at + 3]
    names.append((kind == 5, image[at + 3:at + 3 + n]))
    at += 3 + n + m
assert at == len(image)
was = [(False, old[4 + 96 * i:][:32].rstrip(b"\0")) for i in range(256)]
was += [(True, old[4 + 96 * 256 + 272 * i:][:32].rstrip(b"\0")) for i in range(16)]
assert names == was + [(False, b"n")], names
PY
}
check 'it is taken over whole, and goes on' taken_over
finish

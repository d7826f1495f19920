#!/usr/bin/env bash
# rerecord.sh - `verify --rerecord`: demos of another core version or build are played to their end and written anew,
# with all of their start; what became of prints, score, moments and length is told, as far as a demo lets it be known;
# what is not this run any more, or cannot be written, is left alone.
. "$(dirname "$0")/../tap.sh"
sandbox
core=$("$curtain" version | sed -n "s,.*(core \([0-9]*\).*,\1,p")
reader=$repo/tests/cli/demo_read.py

# A run with points for frames, moments, and a death; sed changes its script.
points() { # [SED]...
    cat >scored.lua <<'LUA'
local late, points, stop, deaths = 0, 10, 0, 1
player.def("ship", { sprite = "dot", hit = { circle = 1 }, registers = { power = 2 } })
bullet.def("orb", { sprite = "dot", hit = { circle = 4 } })
enemy.def("queen", { sprite = "dot", hit = "none" })
boss.def("queen", { title = "Queen", kind = "queen", x = 32, y = 20,
  phases = { { id = "bloom", hp = 100, time = 270, run = function() end } } })
stage.def("one", function()
  stage.at(50) stage.mark("middle")
  stage.at(90 + late) stage.mark("far")
  stage.at(100 + late) boss.fight("queen")
end)
task.go(function()
  for frame = 1, 1000 do
    local p = player.get(1)
    if frame % 20 == 0 and p then score.add(points) end
    if frame == 310 and deaths > 0 then bullet.fire { kind = "orb", x = p.x, y = p.y, speed = 0 } end
    if frame == 320 then bullet.clear() end
    if frame == stop then error("the end", 0) end
    wait(1)
  end
end)
boot.run { stages = { "one" }, players = { "ship" } }
LUA
    for s in "$@"; do sed -i "$s" scored.lua; done
    game g <scored.lua
}
local_is() { points "s/^local late, points, stop, deaths = .*/local late, points, stop, deaths = $1/"; }
run_of() { # NAME FRAMES [OPTION]...
    "$curtain" hash g --stage one:middle --seed 5 --difficulty hard --dip ships=3 --frames "$2" --every 1000 \
        --record "$1.demo" "${@:3}" >/dev/null 2>"$1.said"
}
practised=(--lives 7 --register power=3)
# FROM as of core version 1; here: of this one. forged: another last row; no-points: no moments with points; a number:
# its flags.
aged() { # FROM TO [here] [forged] [no-points] [FLAGS]
    python3 - "$@" <<'PY'
import struct, sys, zlib
source, target, *how = sys.argv[1:]
data, crc, at = open(source, "rb").read(), 0, 8
out = data[:8]

def add(kind, payload):
    global out, crc
    record = kind + b"\0\0\0" + struct.pack("<I", len(payload)) + payload
    crc = zlib.crc32(record, crc)
    out += record + struct.pack("<I", crc)

while at < len(data):
    n, = struct.unpack_from("<I", data, at + 4)
    kind, payload = data[at:at + 1], data[at + 8:at + 8 + n]
    at += 12 + n
    if kind == b"H":
        payload = payload if "here" in how else struct.pack("<I", 1) + payload[4:]
    if kind == b"M" and payload[4] == 12 and "no-points" in how:
        continue
    if kind == b"S" and "forged" in how and struct.unpack_from("<I", payload)[0] > 0:
        payload = payload[:-1] + bytes([payload[-1] ^ 1])
    if kind == b"E" and how and how[-1].isdigit():
        add(b"F", struct.pack("<I", int(how[-1])))
    add(kind, payload)
open(target, "wb").write(out)
PY
}
doubt=" (recorded with core version 1; this is version $core)"
says() { # NAME "CODE LINE" COMMAND...
    local got
    got=$("${@:3}" 2>&1)
    same "$1" "$2" "$? $got"
}
again() { # NAME CODE DEMO LINE [OPTION]
    says "$1" "$2 $3.demo: $4" "$curtain" verify g --rerecord "$3.demo" ${5:-}
}
as_they_were() { for demo in "$@"; do cp "$demo.was" "$demo.demo"; done; }
verified() { # NAME DEMO FRAMES
    says "$1: what was written holds" "0 $2.demo: holds, $3 frames" "$curtain" verify g "$2.demo"
}

# ---- all alike ----

points
run_of new 400 "${practised[@]}"
same 'the run has no fault' '' "$(cat new.said)"
aged new.demo old.was
aged new.demo flags.was 5
as_they_were old flags
again 'an older core, all alike' 0 old "rerecorded: holds, 400 frames$doubt"
check 'it is as one recorded here' cmp old.demo new.demo
same 'a recording tells what everybody had in the end' 'moment 400 listed points 1 200,moment 400 listed points 2 0,' \
    "$(python3 "$reader" new.demo | sed -n '/listed points/p' | tr '\n' ',')"
again 'branched and assisted' 0 flags "rerecorded: holds, 400 frames$doubt"
same 'they stay so' 'flags 5' "$(python3 "$reader" flags.demo | grep flags)"

# ---- what changed ----

local_is '3, 11, 0, 0'
aged new.demo unscored.was no-points
as_they_were old unscored
late='markers: mark far 41 -> 44, boss queen 51 -> 54, phase bloom 111 -> 114'
late="$late, death of player 1 310 -> never and 1 more"
again 'points and moments' 1 old \
    "rerecorded: frame 1: script, tasks differ; score 200 -> 220; $late; length 400 unchanged$doubt"
again 'no recorded score' 1 unscored "rerecorded: frame 1: script, tasks differ; \
recorded score unknown -> 220 (known up to frame 19: 0); $late; length 400 unchanged$doubt"
verified 'points and moments' old 400
python3 "$reader" old.demo | sed -n '/^format/,/^nvram/p' | grep -v '^core\|^game\|^rom' >is
python3 "$reader" new.demo | sed -n '/^format/,/^nvram/p' | grep -v '^core\|^game\|^rom' >was
check 'seed, switches, difficulty, practice start, saves and flags are as they were' cmp was is
check 'they are those it was recorded with' grep -qx 'registers power=3' is
pads() { python3 "$reader" "$1" | grep ^pads; }
same 'so are the pads' "$(pads new.demo)" "$(pads old.demo)"
as_they_were old
again 'verbose: all moments' 1 old \
    "rerecorded: frame 1: script, tasks differ; score 200 -> 220; $late; length 400 unchanged$doubt
  mark far 41 -> 44
  boss queen 51 -> 54
  phase bloom 111 -> 114
  death of player 1 310 -> never
  phase not beaten bloom 381 -> 384" -v
local_is '0, 10, 0, 2'
sed -i 's/frame == 320/frame == 310 + 60 * deaths/' g/main.lua # the same again, told otherwise
as_they_were old
again 'hashes alone' 0 old \
    "rerecorded: frame 320: script, bullets differ; score 200 unchanged; markers unchanged; length 400 unchanged$doubt"

build=' (recorded with another game version)'
cp new.demo other.demo
again 'another build of this core version' 0 other \
    "rerecorded: frame 320: script, bullets differ; score 200 unchanged; markers unchanged; length 400 unchanged$build"

# ---- faults ----

local_is '0, 10, 200, 0'
run_of fault 400
aged fault.demo ends.was
as_they_were ends
again 'the fault it was recorded with' 0 ends \
    "rerecorded: holds, 200 frames, ends in the recorded fault$doubt"
as_they_were old
cut='not rerecorded: the rest of the run would be lost'
again 'a fault before its end' 2 old \
    "frame 200: fault that is not in the demo: main.lua:18: the end; length 400 -> 200; $cut$doubt"
check 'it is left alone' cmp old.demo old.was
local_is '0, 10, 0, 0'
as_they_were ends
gone='the recorded fault does not occur'
again 'a fault that does not come' 1 ends \
    "rerecorded: frame 200: $gone; score 100 unchanged; markers unchanged; length 200 unchanged$doubt"

# ---- what is not this run ----

local_is '0, 11, 0, 0'
aged new.demo touched.was 2
as_they_were touched
outside='the board was changed from outside, which a demo does not record'
again 'touched from outside' 2 touched \
    "frame 20: script, player, fix differ; not rerecorded: $outside$doubt"
check 'touched: left alone' cmp touched.demo touched.was
points
aged new.demo forged.was here forged
as_they_were forged
again 'of this very build, and differs' 2 forged \
    'frame 120: camera differs; not rerecorded: it was recorded with this build'
check 'forged: left alone' cmp forged.demo forged.was
head -c -30 old.was >short.demo
cp short.demo short.was
says 'cut short' '2 curtain: short.demo: truncated: 400 frames and no end mark' "$curtain" verify g \
    --rerecord short.demo
check 'short: left alone' cmp short.demo short.was

# ---- many ----

as_they_were old
cp old.was more.demo
printf '%s\n' old.demo short.demo more.demo | "$curtain" verify g --rerecord - >out 2>said
status=$? good="rerecorded: holds, 400 frames$doubt"
same 'names from standard input' \
    "2 old.demo: $good|short.demo: truncated: 400 frames and no end mark|more.demo: $good|" \
    "$status $(tr '\n' '|' <out)"
# ---- older demos play ----

as_they_were old
"$curtain" render g --demo old.demo --frames 400 -o old >/dev/null 2>old.said
code=$?
same 'render plays an older demo' \
    "0 curtain: old.demo: recorded with core version 1; this is version $core; playback may diverge" \
    "$code $(cat old.said)"
finish

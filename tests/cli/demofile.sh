#!/usr/bin/env bash
# demofile.sh - docs/reference/demo-format.md is true: a reader made from it alone reads every demo, agrees with what
# Curtain computes, and refuses what Curtain refuses; the demo taken apart on the page is the one in the repository.
. "$(dirname "$0")/../tap.sh"
program=$OUT/curtain-null

# The dumps on the page: each line is the bytes of the demo at the offset before them.
dumped() { # PAGE
    python3 - "$1" <<'END'
import re, sys
text = open(sys.argv[1], encoding="utf-8").read()
dumps = re.findall(r"<!-- dump of (\S+) -->\n```\n(.*?)```\n<!-- end -->", text, re.S)
assert len(dumps) == 2
for name, dump in dumps:
    data = open(name, "rb").read()
    for at, shown in re.findall(r"^([0-9a-f]{4})  (.{1,36})", dump, re.M):
        is_there = data.startswith(bytes.fromhex(shown), int(at, 16))
        assert is_there, "%s has other bytes than %s at %s" % (name, shown, at)
END
}
check 'the demos taken apart on the page' dumped docs/reference/demo-format.md
sed 's/^0004  04/0004  03/' docs/reference/demo-format.md >"$scratch/demos.md"
detects 'a byte that is not so' 'has other bytes than 03' dumped "$scratch/demos.md"

# What the reader finds against what Curtain computes: rows and prints are the hashes of every frame, the pads are what
# the board's input held (opposites held at once are neither), and the header is what verify says.
agrees() { # ROM DEMO
    "$program" hash "$1" --demo "$2" --parts 2>/dev/null >"$scratch/parts" || return 1
    "$program" hash "$1" --demo "$2" --trace input 2>/dev/null >"$scratch/input" || return 1
    "$program" verify "$1" "$2" -v >"$scratch/verify" || { cat "$scratch/verify" && return 1; }
    python3 - "$2" "$scratch" <<'END'
import re, sys
sys.path.insert(0, "tests/cli")
from demo_read import read
d, at = read(open(sys.argv[1], "rb").read()), sys.argv[2]
said = open(at + "/verify").read()
hashes = []
for line in open(at + "/parts"):
    frame, whole, *parts = line.split()
    parts = [p.split("=") for p in parts]
    absent = [n for n, h in parts if n not in d["parts"] and int(h, 16) == 0]  # that came after the recording
    assert [n for n, _ in parts if n not in absent] == d["parts"] and int(frame) == len(hashes)
    hashes.append([int(h, 16) for n, h in parts if n not in absent])
assert len(hashes) == len(d["pads"]) + 1, "frames"
for i, row in enumerate(d["rows"]):
    now = hashes[min(60 * i, len(d["pads"]))]
    assert row == (now if d["whole"][i] else [h & 0xffff for h in now]), "row %d" % i
script = d["parts"].index("script")
assert not d["sparse"] or not d["prints"]
for f, prints in enumerate(d["prints"]):
    for i, p in enumerate(prints):
        assert p == hashes[f + 1][i] & 0xffff or (d["format"] == 2 and i != script), "print of frame %d" % (f + 1)
assert d["sparse"] or len(d["prints"]) == len(d["pads"])
held, resets = {}, set()
for line in open(at + "/input"):
    m = re.match(r"(\d+) input ([01]) - held=([0-9a-f]{4})", line)
    if m:
        held[int(m[1]), int(m[2])] = int(m[3], 16)
for f, pads in enumerate(d["pads"]):
    for p, v in enumerate(pads):
        for both in (3, 12):
            v &= ~both if v & both == both else -1
        if held.get((f + 1, p), 0) != v:
            assert (f + 1, 0) not in held and (f + 1, 1) not in held, "pads of frame %d" % (f + 1)
            resets.add(f + 1)
assert len(resets) <= 3, "frames whose pads the board forgot, as board.reset does: %s" % sorted(resets)
for want in ("holds, %d frames" % len(d["pads"]),
             "format %(format)d, core version %(core)d, Lua %(lua)s, game %(game)016x, ROM %(rom)016x" % d,
             "seed %d, difficulty %d, from %s" % (d["seed"], d["difficulty"], d["mark"] or "power-on"),
             "%d parts, %d rows, %d markers" % (len(d["parts"]), len(d["rows"]), len(d["moments"]))):
    assert want in said, want
assert d["end"] == 0
END
}
core_of() { python3 tests/cli/demo_read.py "$1" | sed -n 's/^core //p'; }
core=$("$program" version | sed -n "s,.*(core \([0-9]*\).*,\1,p")
for demo in roms/*/demos/*.demo; do check "the page's reader agrees about $demo" agrees "${demo%/demos/*}" "$demo"; done
for demo in tests/demos/*.demo; do # those of this core version: what an older one recorded may differ
    [ "$(core_of "$demo")" != "$core" ] || check "the page's reader agrees about $demo" agrees "${demo%-*}.rom" "$demo"
done
"$program" hash tests/demos/frozen.rom --seed 5 --frames 3700 --every 4000 --record "$scratch/sparse.demo" \
    --press fire@0:3700:7,2.left@100:3000:11 --prints seconds >/dev/null
check "the page's reader agrees about one with prints of seconds" agrees tests/demos/frozen.rom "$scratch/sparse.demo"

# Changed bytes, checksums made good: both refuse, or neither does.
cat >"$scratch/lies.py" <<'END'
import random, re, subprocess, sys
sys.path.insert(0, "tests/cli")
from demo_read import read, Bad
from demo_repair import repair
program, demo, rom, at, changes = *sys.argv[1:5], int(sys.argv[5])
good = open(demo, "rb").read()
refusals = re.compile("damaged|not a demo|demo format|truncated header|bytes after its end|"
                      "longer than|larger than")

random.seed(len(good))
refused = 0
for i in range(changes):
    data = bytearray(good)
    for _ in range(random.choice((1, 1, 1, 2, 3))):
        byte = random.choice((random.randrange(len(data)), random.randrange(min(len(data), 700))))
        data[byte] = random.choice((0, 1, 2, 59, 60, 61, 127, 128, 255, random.randrange(256)))
    repair(data)
    open(at, "wb").write(data)
    try:
        read(bytes(data))
        mine = ""
    except Bad as why:
        mine = str(why) or "refused"
    run = subprocess.run([program, "hash", rom, "--demo", at, "--frames", "0"], capture_output=True, text=True)
    theirs = run.stderr if run.returncode == 2 and refusals.search(run.stderr) else ""
    if bool(mine) != bool(theirs):
        sys.exit("change %d: the page says \"%s\", Curtain \"%s\"" % (i, mine, run.stderr.strip()))
    refused += bool(mine)
if not changes / 5 < refused < changes:
    sys.exit("%d of %d were refused" % (refused, changes))
END
for demo in tests/demos/*.demo; do # the most to one of each format, and to those of now
    changes=50
    case $demo in *"$core"-* | */frozen-*) changes=300 ;; esac
    check "$changes changes to $demo are refused by both or neither" python3 "$scratch/lies.py" "$program" "$demo" \
        "${demo%-*}.rom" "$scratch/lie.demo" "$changes"
done
finish

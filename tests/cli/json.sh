#!/usr/bin/env bash
# json.sh - `verify --json`: an object a demo, on a line, that Python's json reads; what stands in it; names that
# are no text. Score and moments are the replay's, whatever the file claims.
. "$(dirname "$0")/../tap.sh"
sandbox
game g <<'LUA'
player.def("ship", { sprite = "dot", hit = { circle = 2 }, lives = 1, safe = 9, run = function(p)
  while true do
    if pad.down("fire", p) then score.add(10, p) end
    if pad.down("special", p) then error 'a "quoted" \\ end' end
    wait(1)
  end
end })
stage.def("one", function() wait(100) stage.mark "late" wait(100) end)
boot.run { stages = { "one" }, players = { "ship" } }
LUA
begin=start@30:31,fire@60:61,fire@100:101,fire@160:161
"$curtain" hash g --frames 800 --every 800 --seed 18446744073709551615 --press "$begin,fire@200:220" --record run.demo \
    >/dev/null 2>&1
"$curtain" hash g --frames 60 --every 60 --record title.demo >/dev/null 2>&1
"$curtain" hash g --frames 400 --every 400 --press "$begin,special@300" --record fault.demo >/dev/null 2>&1

tell() { "$curtain" verify g "$@" --json; } # DEMO...
field() { python3 -c 'import json, sys
d = json.loads(sys.stdin.readline())
for key in sys.argv[1].split("."): d = d[key]
print(json.dumps(d))' "$1"; }
of() { tell "$1" | field "$2"; } # DEMO KEY

tell run.demo >line
same 'one line' 1 "$(wc -l <line)"
same 'ASCII alone' '' "$(LC_ALL=C tr -d '\n\40-\176' <line)"
same 'verdict' '"holds"' "$(of run.demo verdict)"
same 'seconds' 13.333 "$(of run.demo seconds)"
same 'a seed that no double holds' '"18446744073709551615"' "$(of run.demo start.seed)"
points=$(of run.demo score)
check "score: $points" grep -qE '^\[[1-9][0-9]*, 0\]$' <<<"$points"
same 'difficulty, which was chosen in a menu' '"normal"' "$(of run.demo difficulty)"
same 'how it ended' '"clear" 1' "$(of run.demo ended) $(of run.demo stages)"
kinds() { python3 -c 'import json, sys
print(*(m["kind"] + ":" + m["name"] for m in json.loads(sys.stdin.readline())["moments"]))'; }
same 'moments' 'game:ship difficulty:normal stage:one mark:late clear:one over:clear' "$(kinds <line)"
same 'no doubt' null "$(of run.demo doubt)"
same 'the ROM it was recorded on, and this one' "$(of run.demo recorded)" "$(of run.demo replayed)"
same 'its hash is the one that list prints' "\"$("$curtain" list g | sed -n 's/^rom //p')\"" \
    "$(of run.demo replayed.rom)"
same 'a demo without a game' '[0, 0] null null 0' \
    "$(of title.demo score) $(of title.demo ship) $(of title.demo ended) $(of title.demo players)"
same 'a fault' '"main.lua:4: a \"quoted\" \\ end" "holds"' \
    "$(of fault.demo fault | sed 's/ end.*/ end"/') $(of fault.demo verdict)"

# The points and moments that a file claims are not told.
python3 - run.demo forged.demo <<'PY'
import struct, sys, zlib
d, at, crc, out = open(sys.argv[1], "rb").read(), 8, 0, bytearray()
out += d[:8]
while at < len(d):
    kind, n = d[at:at + 4], struct.unpack("<I", d[at + 4:at + 8])[0]
    body = d[at + 8:at + 8 + n].replace(b"mark", b"mork").replace(b"late", b"lite").replace(b"points 1 ", b"points 1 9")
    if kind == b"F\0\0\0":
        body = b""
    body = body[:5] + bytes([len(body) - 6]) + body[6:] if kind == b"M\0\0\0" and b"points 1" in body else body
    record = kind + struct.pack("<I", len(body)) + body
    crc = zlib.crc32(record, crc)
    out += record + struct.pack("<I", crc)
    at += 12 + n
open(sys.argv[2], "wb").write(out)
PY
same 'a forged file still holds' '"holds"' "$(of forged.demo verdict)"
same 'with the score of its replay' "$points" "$(of forged.demo score)"
same 'and its moments' "$(kinds <line)" "$(tell forged.demo | kinds)"

# ---- what does not hold, what cannot be read ----

sed -i 's/score.add(10/score.add(20/' g/main.lua
tell run.demo >line
got=$?
same 'differs: exit code 1' 1 $got
same 'where' '"differs"' "$(field verdict <line)"
same 'parts' '["script", "player"]' "$(field difference.parts <line)"
same 'no score is reported' 0 "$(grep -c '"score"\|"moments"' line)"
same 'the doubt' '"recorded with another game version"' "$(field doubt <line)"
sed -i 's/score.add(20/score.add(10/' g/main.lua
echo rubbish >"$(printf 'a"b\\c\x01\xff\xc3\xa4\xf0\x9f\x8e\xb6.demo')"
tell a* >line 2>err
got=$?
same 'refused: exit code 2' 2 $got
same 'nothing on stderr' '' "$(cat err)"
same 'a name with everything in it' '"a\"b\\c\u0001\ufffd\u00e4\ud83c\udfb6.demo"' "$(field file <line)"
same 'refused' '"refused"' "$(field verdict <line)"

# ---- many ----

printf '%s\n' run.demo none.demo title.demo fault.demo | "$curtain" verify g - --json >lines 2>err
got=$?
same 'a list of names: the worst code' 2 $got
same 'a line each' '"holds" "refused" "holds" "holds"' \
    "$(while read -r l; do field verdict <<<"$l"; done <lines | xargs -d '\n')"
finish

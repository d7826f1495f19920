#!/usr/bin/env bash
# compressed.sh - packed games are compressed: smaller, the same game, read wherever a ROM is; another program reads and
# writes the same format; what is damaged, or would fill a memory, is refused.
. "$(dirname "$0")/../tap.sh"
sandbox
cp -r "$repo/roms/glasstide" glasstide
"$curtain" pack glasstide -o small.rom && "$curtain" pack glasstide --plain -o plain.rom || not_ok 'it is packed'
small=$(stat -c %s small.rom) plain=$(stat -c %s plain.rom) gzip=$(gzip -9nc plain.rom | wc -c)
echo "# Glass Tide: $plain bytes plain, $small compressed; gzip -9 makes $gzip of it"
check 'it is clearly smaller than what gzip makes' [ $((small * 5)) -lt $((gzip * 4)) ]
same 'a compressed one says so, a plain one does not' 'CURTAINZ CURTAIN' \
    "$(head -c 8 small.rom) $(head -c 7 plain.rom)"
same 'the same lumps and hashes' "$("$curtain" list plain.rom)" "$("$curtain" list small.rom)"
same 'the same run' "$("$curtain" hash plain.rom --frames 120)" "$("$curtain" hash small.rom --frames 120)"

# ---- another program: Python's liblzma ----

cat >other.py <<'PY'
import lzma, struct, sys, zlib
what, source, target = sys.argv[1:]
data = open(source, "rb").read()
if what == "read":
    size, crc = struct.unpack_from("<I4xI", data, 16)
    stream = bytes([0]) + struct.pack("<IQ", 1 << 28, size) + data[32:]
    out = lzma.decompress(stream, lzma.FORMAT_ALONE)
    assert zlib.crc32(out) == crc
else:
    filters = [{"id": lzma.FILTER_LZMA1, "lc": 0, "lp": 0, "pb": 0, "dict_size": 1 << 25, "nice_len": 273}]
    stream = lzma.compress(data, lzma.FORMAT_RAW, filters=filters)
    out = struct.pack("<IIIQ", len(data), 32 + len(stream), zlib.crc32(data), 0)[:16] + stream
    out = b"CURTAINZ" + struct.pack("<II", 1, zlib.crc32(out)) + out
open(target, "wb").write(out)
PY
check 'Python reads it' python3 other.py read small.rom read.rom
check 'as it was' cmp plain.rom read.rom
check 'Python writes one' python3 other.py write plain.rom written.rom
echo "# with all of liblzma's trying: $(stat -c %s written.rom)"
same 'which is read' "$("$curtain" list plain.rom)" "$("$curtain" list written.rom)"

# ---- refused ----

mkdir g && echo 'return { id = "g", screen = { w = 64, h = 64 }, board = { bullets = 64, lua_kib = 256 } }' >g/rom.lua
for n in $(seq 60); do echo "local function f$n(x) return x + $n end"; done >g/main.lua
"$curtain" pack g -o g.rom || not_ok 'the small game is packed'
size=$(stat -c %s g.rom)
head -c 100 g.rom >cut.rom
head -c 20 g.rom >shorter.rom
cp g.rom spoilt.rom && printf '\xff\xff' | dd of=spoilt.rom bs=1 seek=$((size / 2)) conv=notrunc 2>/dev/null
spoil() { # FROM TO AT U32: that word is another, and the checksum is good again
    python3 - "$@" <<'PY'
import struct, sys, zlib
data = bytearray(open(sys.argv[1], "rb").read())
struct.pack_into("<I", data, int(sys.argv[3]), int(sys.argv[4]))
struct.pack_into("<I", data, 12, zlib.crc32(data[16:]))
open(sys.argv[2], "wb").write(data)
PY
}
spoil g.rom bomb.rom 16 4294967295
spoil g.rom wide.rom 16 $((size * 1000 + 2000))
spoil g.rom short.rom 16 100
spoil g.rom format.rom 8 9
too_much="bytes when decompressed: expected 1 to 268435456, and at most 1000 times the file's size"
while read -r name why; do
    why=${why//TOO/$too_much}
    input_error "$name.rom" "$name.rom: $why" unpack "$name.rom" unpacked
done <<EOL
cut 100 bytes long, but its header says $size
shorter too short for a compressed ROM (20 bytes)
spoilt damaged: the checksum does not match
bomb $size bytes long, but its header says 4294967295 TOO
wide $size bytes long, but its header says $((size * 1000 + 2000)) TOO
short damaged: decompressed data has the wrong checksum
format unknown compression format 9 (this program reads format 1)
EOL
check 'and nothing is written' test ! -e unpacked
python3 other.py write g.rom twice.rom
refuse "compressed twice" "twice.rom: not a Curtain ROM" "$curtain" list twice.rom
finish

#!/usr/bin/env bash
# fonts.sh - a game in Japanese, with a BDF font made of one of Debian's packages: what is packed of it, every pixel of
# what is drawn against the font's own bits, read by nothing of Curtain's, and a font that is not by Unicode; a TrueType
# font, and what rom.lua must say of it. test_ttf.c has its pixels.
. "$(dirname "$0")/../tap.sh"
sandbox

pcf=/usr/share/fonts/X11/misc/f12.pcf.gz
if [ ! -e $pcf ] || ! command -v pcf2bdf >/dev/null; then
    echo "ok 1 # SKIP there is no $pcf (package xfonts-efont-unicode), or no pcf2bdf: make deps installs both"
    echo "1..1"
    exit 0
fi
mkdir -p g/art g/lang
zcat $pcf | pcf2bdf -o g/art/jp.bdf 2>/dev/null
cat >g/rom.lua <<'LUA'
return { id = "g", screen = { w = 160, h = 64 }, board = { lines = 4, lua_kib = 512 },
  fonts = { jp = { file = "art/jp.bdf", also = "島" } } }
LUA
cat >g/main.lua <<'LUA'
text.line { x = 3, y = 5, text = "弾幕へ、ようこそ", font = "jp" } -- not 潮
text.line { x = 3, y = 25, text = text.lang("gate"), font = "jp" }
LUA
printf 'gate = 門\n' >g/lang/ja.txt

check 'check finds nothing, and plays it' grep -q '^g: no problems: 1 script' <("$curtain" check g)
"$curtain" pack g --plain -o g.rom && "$curtain" render g.rom --frames 1 --lang ja -o out >/dev/null

# Prints each glyph's code of a packed font.
cat >codes.py <<'PY'
import struct, sys
rom = open(sys.argv[1], "rb").read()
count, = struct.unpack_from("<I", rom, 16)
for i in range(count):
    name, at, size, _ = struct.unpack_from("<4I", rom, 32 + 16 * i)
    if rom[name:rom.index(b"\0", name)] == b"fonts/jp":
        n, = struct.unpack_from("<I", rom, at + 4)
        print("".join(chr(struct.unpack_from("<I", rom, at + 8 + 16 * k)[0]) for k in range(n)))
PY
same 'only what is shown is packed' "\\、うこそへよ島幕弾門" "$(python3 codes.py g.rom | tr -d '\n')"

# The rows of a character: the font's bits, and the picture's pixels.
cat >compare.py <<'PY'
import subprocess, sys
font, reader, picture = sys.argv[1:4]
glyphs, ascent, code = {}, 0, None
lines = iter(open(font, encoding="latin-1").read().split("\n"))
for line in lines:
    w = line.split()
    if w[:1] == ["FONT_ASCENT"]:
        ascent = int(w[1])
    elif w[:1] == ["ENCODING"]:
        code = int(w[1])
    elif w[:1] == ["DWIDTH"]:
        step = int(w[1])
    elif w[:1] == ["BBX"]:
        box = list(map(int, w[1:5]))
    elif w[:1] == ["BITMAP"]:
        rows = [next(lines) for _ in range(box[1])]
        glyphs[code] = (step, box, [[int(r, 16) >> (4 * len(r) - 1 - x) & 1 for x in range(box[0])] for r in rows])
want = [[0] * 160 for _ in range(64)]
for x, y, text in (3, 5, "弾幕へ、ようこそ"), (3, 25, "門"):
    for c in text:
        step, (bw, bh, bx, by), rows = glyphs[ord(c)]
        for r in range(bh):
            for k in range(bw):
                want[y + ascent - by - bh + r][x + bx + k] |= rows[r][k]
        x += step
raw = subprocess.run([sys.executable, reader, picture], stdout=subprocess.PIPE, check=True).stdout
head, raw = raw.split(b"\n", 1)
w, h, kind = map(int, head.split())
pixels = raw[768:] if kind == 3 else raw[::3]
got = [[int(pixels[y * w + x] != pixels[-1]) for x in range(w)] for y in range(h)]
for y in range(h):
    if got[y] != want[y]:
        sys.exit("row %d: got %s" % (y, "".join(".#"[v] for v in got[y])))
print(sum(map(sum, got)), "pixels")
PY
check 'each pixel of the Japanese lines is the font'"'"'s' \
    python3 compare.py g/art/jp.bdf "$repo/tests/cli/png_read.py" out/000001.png
echo 'text.line { x = 3, y = 45, text = "潮😀", font = "jp" }' >>g/main.lua
"$curtain" check g >found
same 'a character that it lacks' \
    'main.lua:3: no font in the game has a glyph for "😀", U+1F600: a box is drawn instead' "$(grep glyph found)"
sed -i 's/^CHARSET_REGISTRY.*/CHARSET_REGISTRY "JISX0208.1983"/' g/art/jp.bdf
"$curtain" pack g -o g.rom 2>why
same 'a font that is not by Unicode' \
    "curtain: g: art/jp.bdf: line 20: unsupported character set JISX0208.1983-1; expected ISO10646-1 (Unicode), \
US-ASCII, KOI8-R, FontSpecific, or ISO8859-1 to 5, 7, 9, 10, 13 to 16" "$(cat why)"

cp "$repo/tests/fuzz/seeds/fuzz_ttf/segments.ttf" g/art/t.ttf # has the space, A, B and C
echo 'text.line { x = 3, y = 5, text = "CC", font = "jp" }' >g/main.lua
fonts() { # NAME WANT FONT: what pack says about the font
    sed -i "s|fonts = .*|fonts = { jp = { $3 } } }|" g/rom.lua
    "$curtain" pack g --plain -o g.rom >/dev/null 2>why
    same "$1" "$2" "$(cat why)"
}
fonts 'a TrueType font' '' 'file = "art/t.ttf", size = 8'
same '... has all of ASCII that it draws' ' ABC' "$(python3 codes.py g.rom | tr -d '\n')"
fonts '... needs a size' 'curtain: g: rom.lua: fonts.jp: a .ttf file needs `size`, its height in px' \
    'file = "art/t.ttf"'
fonts '... in px' 'curtain: g: rom.lua: fonts.jp.size: expected a whole number from 1 to 64, got 65' \
    'file = "art/t.ttf", size = 65'
fonts '... and has no cells' 'curtain: g: rom.lua: fonts.jp: `cell` is for pictures, got "art/t.ttf"' \
    'file = "art/t.ttf", size = 8, cell = { 8, 8 }, chars = "A"'
fonts 'another font has no size' 'curtain: g: rom.lua: fonts.jp: `size` is for .ttf files, got "art/jp.bdf"' \
    'file = "art/jp.bdf", size = 8'
head -c 200 g/art/t.ttf >g/art/cut.ttf
fonts 'a damaged one' 'curtain: g: art/cut.ttf: head: missing or damaged' 'file = "art/cut.ttf", size = 8'
finish

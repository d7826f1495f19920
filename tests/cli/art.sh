#!/usr/bin/env bash
# art.sh - pictures: .ase files become what they look like, slices hit shapes, malformed ones a sentence; sheets matched
# by index; pixels that vanish; `curtain art`, `curtain palette`.
. "$(dirname "$0")/../tap.sh"
sandbox

make_ase() { python3 "$repo/tests/cli/ase_make.py" "$@"; }
lump() { "$curtain" list "$1" | sed -n "s,^$2 ,,p"; }

# ---- .ase: what another program put together, pixel for pixel ----

make_ase games
for game in games/*; do
    name=$(basename "$game")
    for lump in gfx/a gfx/a_50; do
        [ $lump = gfx/a ] || grep -q sizes "$game/rom.lua" || continue
        a=$(lump "$game" $lump) b=$(lump "$game" "${lump/a/b}")
        same "$name: $lump is the merged picture" "${b:-none}" "$a"
    done
done

# ---- the example: what tools/moth.py draws, in a palette that curtain palette made ----

cp -r "$repo/examples/moth" moth
cp "$repo/roms/glasstide/art/palette.png" moth/art/palette.png
python3 "$repo/tools/moth.py" moth/art
same "its palette" "moth/art/palette.png: 15 colours in bank 11" \
    "$("$curtain" palette moth/art/moth.hex --bank 11 -o moth/art/palette.png)"
check "... is that of the example" cmp moth/art/palette.png "$repo/examples/moth/art/palette.png"
check "its colours too" cmp moth/art/moth.hex "$repo/examples/moth/art/moth.hex"
same "so are its sprites and shapes" "$("$curtain" list "$repo/examples/moth")" "$("$curtain" list moth)"
check "and nothing is to be said" "$curtain" check moth
cp moth/art/moth.ase moth/art/draft.aseprite
refuse "one that is not in use" "art/draft.aseprite: not listed in rom.lua" "$curtain" check moth

# ---- canyon: what tools/canyon.py draws, with the shooter's bullets and ship ----

cp -r "$repo/examples/canyon" canyon
rm canyon/art/* canyon/maps/*
cp "$repo"/examples/shooter/art/{bullets,shots,sparks,font,kite}.png canyon/art
python3 "$repo/tools/canyon.py" canyon
"$curtain" pack canyon -o drawn.rom && "$curtain" pack "$repo/examples/canyon" -o canyon.rom
check "its pictures and maps" cmp drawn.rom canyon.rom

# ---- .ase: one sentence for each malformed one ----

mkdir -p spoilt/art
cat >spoilt/rom.lua <<'LUA'
return { id = "s", match = "index", sheets = { a = { file = "art/a.ase" } }, sprites = { a = { sheet = "a" } } }
LUA
: >spoilt/main.lua
spoilt() { # HOW SENTENCE
    python3 "$repo/tests/cli/art_spoil.py" "$1" spoilt/art/a.ase
    refuse "$1" "curtain: spoilt: art/a.ase: $2" "$curtain" pack spoilt -o spoilt.rom
    same "$1: one line" 1 "$(wc -l <.said)"
}
while IFS='|' read -r how sentence; do spoilt "$how" "$sentence"; done <<'HOWS'
text|not an Aseprite file
header|truncated Aseprite file
bits|the Aseprite file has 24 bits per pixel, expected 8, 16 or 32
frames|the Aseprite file has 0 frames, expected 1 to 4096
frame_magic|damaged Aseprite file: frame 1 has no header
cut|truncated Aseprite file
chunk_small|damaged Aseprite file: chunk 1 in frame 1 has the wrong size
layer_kind|damaged Aseprite file: unknown layer type 1
cel_layer|damaged Aseprite file: frame 1 has a cel in layer 8, but the last layer is 1
cel_kind|frame 1, layer "ink": unknown cel type
cel_size|frame 1, layer "ink": a cel of 0x2 pixels is too small
cel_huge|frame 1, layer "ink": a cel of 65535x65535 pixels is too large
cel_zlib|frame 1, layer "ink": damaged pixels
cel_twice|damaged Aseprite file: frame 1 has two cels in layer "ink"
link|frame 1, layer "ink": its cel is linked to frame 1, which has no cel in this layer
index|sprite "a": frame 1: layer "ink": index 9, but the palette has 3 colours
palette|the Aseprite file has a palette of 0 colours, expected 1 to 65536
tilemap|layer "glow" is a tilemap: convert it to a normal layer
group|group "all" has its own opacity or blend mode: set them on its layers
soft_light|layer "glow": blend mode "soft light" is not supported: merge the layer with the one below
tag|tag "fly" covers frames 1 to 5, but the file ends at frame 1
blended|sprite "a": match = "index" needs opaque layers in normal mode
long|sprite "a": its frames have different durations and need 363 pictures, expected at most 256
five|sprite "a": more than 4 slices named "hit"
two_boxes|sprite "a": slice "box two": too many shapes: expected one box, one capsule, or circles
mixed|sprite "a": slice "capsule": too many shapes: expected one box, one capsule, or circles
box_off|sprite "a": slice "box": its centre is 1,1 px from the origin; a box must be centred on the origin
capsule_off|sprite "a": slice "capsule": its centre is 0,-1.5 px from the origin; a capsule must be centred on
far|sprite "a": slice "hit" is far outside the picture
HOWS
python3 "$repo/tests/cli/art_spoil.py" hidden_tilemap spoilt/art/a.ase
check "what is not shown may be anything" "$curtain" pack spoilt -o spoilt.rom

# ---- slices: what hits ----

python3 - "$repo/tests/cli" <<'PY'
import os, sys
sys.path.insert(0, sys.argv[1])
from ase_file import Ase, Cel

def sprite(name, w, h, *slices):
    ase = Ase(w, h, mode="indexed", palette=[(0, 0, 0), (255, 255, 255)])
    ase.layer("ink")
    for shade in (1, 1, 0):
        ase.frame(Cel(0, [[shade] * w for _ in range(h)]))
    ase.tag("early", 0, 0)
    ase.tag("late", 2, 2)
    for words in slices:
        ase.slice(words[0], *words[1], pivot=len(words[1][0]) > 5, patch=name == "orb")
    os.makedirs("hits/art", exist_ok=True)
    open("hits/art/%s.ase" % name, "wb").write(ase.whole())

sprite("orb", 12, 12, ("hit", [(0, 3, 3, 6, 6), (2, 4, 4, 4, 4)]), ("shade", [(0, 0, 0, 9, 9)]))
sprite("odd", 15, 15, ("hit", [(0, 5, 6, 5, 3)]))
sprite("wing", 20, 16, ("hit", [(0, 2, 2, 4, 4)]), ("Hit", [(0, 0, 0, 9, 9)]), ("hit right", [(0, 14, 3, 4, 5)]),
       ("hitch", [(0, 0, 0, 9, 9)]), ("foot", [(1, 0, 0, 1, 1, 3, 4)]))
sprite("foe", 20, 30, ("box", [(0, 4, 8, 12, 18, 6, 9)]))
sprite("bar", 16, 8, ("capsule", [(0, 1, 2, 14, 4)]))
sprite("post", 8, 16, ("capsule", [(0, 2, 1, 4, 14)]))
sprite("gone", 8, 8, ("hit", [(0, 2, 2, 4, 4), (2, 0, 0, 0, 0)]))
PY
cat >hits/rom.lua <<'LUA'
return { id = "h", match = "index",
  sheets = { orb = { file = "art/orb.ase" }, odd = { file = "art/odd.ase" }, wing = { file = "art/wing.ase" },
    foe = { file = "art/foe.ase" }, bar = { file = "art/bar.ase" }, post = { file = "art/post.ase" },
    gone = { file = "art/gone.ase" } },
  sprites = { orb = { sheet = "orb", tag = "early", sizes = { 50, 300 } }, late = { sheet = "orb", tag = "late" },
    odd = { sheet = "odd" }, wing = { sheet = "wing", rotations = 8 }, foe = { sheet = "foe" },
    bar = { sheet = "bar", rotations = 16 }, post = { sheet = "post" }, gone = { sheet = "gone", tag = "late" },
    part = { sheet = "foe", x = 4, y = 8, w = 12, h = 18 } } }
LUA
cat >hits/main.lua <<'LUA'
bullet.def("orb", { sprite = "orb", hit = { sprite = "orb" } })
bullet.def("small", { sprite = "orb_50", hit = { sprite = "orb_50" } })
bullet.def("large", { sprite = "orb_300", hit = { sprite = "orb_300" } })
bullet.def("late", { sprite = "late", hit = { sprite = "late" } })
bullet.def("odd", { sprite = "odd", hit = { sprite = "odd" } })
bullet.def("bar", { sprite = "bar", hit = { sprite = "bar" }, turns = true })
shot.def("wing", { sprite = "wing", hit = { sprite = "wing" }, turns = true })
enemy.def("foe", { sprite = "foe", hit = { sprite = "foe" } })
enemy.def("part", { sprite = "part", hit = { sprite = "part" } })
enemy.def("post", { sprite = "post", hit = { sprite = "post" } })
player.def("ship", { sprite = "orb", hit = { sprite = "orb" } })
LUA
art_of() { "$curtain" art hits | sed -n "s/^$1: //p"; }
same "a circle" "12x12, bank 0, origin 6,6; bullet orb: circle 3; player ship: circle 3" "$(art_of orb)"
same "at three times the size" "36x36, bank 0, origin 18,18; bullet large: circle 9" "$(art_of orb_300)"
same "as it is in the tag's frame" "12x12, bank 0, origin 6,6; bullet late: circle 2" "$(art_of late)"
same "odd sides: about the middle" "15x15, bank 0, origin 7,7, 3 frames, every = 6; bullet odd: circle 1.5" \
    "$(art_of odd)"
same "a box, about a pivot" "20x30, bank 0, origin 10,17, 3 frames, every = 6; enemy foe: box 12 x 18" "$(art_of foe)"
same "in a part of the canvas" \
    "12x18, bank 0, origin 6,9, 3 frames, every = 6; enemy part: box 12 x 18" "$(art_of part)"
check "a capsule" grep -q 'bullet bar: capsule 10, 2$' <<<"$(art_of bar)"
check "circles" grep -q 'shot wing: 2 circles$' <<<"$(art_of wing)"
same "hidden: there is none" "8x8, bank 0, origin 4,4" "$(art_of gone)"
"$curtain" unpack hits parts
same "the circles' places" "8 2 131072 0 -393216 -262144 131072 0 393216 -163840" \
    "$(python3 -c 'import struct; print(*struct.unpack_from("<10i", open("parts/lumps/hit/wing", "rb").read()))')"

cp -r hits written

# The shapes are in the game hash, the pixels are not.
game_hash() { "$curtain" list "$1" | sed -n 's/^game //p'; }
before=$(game_hash hits)
python3 - <<'PY'
import struct
data = bytearray(open("hits/art/orb.ase", "rb").read())
at = data.index(struct.pack("<iiII", 3, 3, 6, 6))
open("moved.ase", "wb").write(data[:at] + struct.pack("<iiII", 2, 2, 8, 8) + data[at + 16:])
PY
cp hits/art/orb.ase orb.ase
cp moved.ase hits/art/orb.ase
check "another slice is another game" [ "$(game_hash hits)" != "$before" ]
cp orb.ase hits/art/orb.ase
python3 - "$repo/tests/cli" <<'PY'
import sys
sys.path.insert(0, sys.argv[1])
from ase_file import Ase, Cel
ase = Ase(8, 16, mode="indexed", palette=[(0, 0, 0), (9, 9, 9), (99, 9, 9)])
ase.layer("other")
ase.frame(Cel(0, [[2] * 8 for _ in range(16)]))
ase.slice("capsule", (0, 2, 1, 4, 14))
open("hits/art/post.ase", "wb").write(ase.whole())
PY
same "other pixels are not" "$before" "$(game_hash hits)"
says_of() { # NAME SENTENCE SCRIPT
    echo "$3" >hits/main.lua
    refuse "$1" "$2" "$curtain" hash hits --frames 1
}
says_of "a sprite without one" 'bullet.def: hit.sprite: sprite "gone" has no hit shape' \
    'bullet.def("a", { sprite = "orb", hit = { sprite = "gone" } })'
says_of "a ship's box" 'one circle at the player'"'"'s position, got a different hit shape from "foe"' \
    'player.def("a", { sprite = "orb", hit = { sprite = "foe" } })'
says_of "a bullet's upright capsule" 'the capsule of "post" is vertical' \
    'bullet.def("a", { sprite = "orb", hit = { sprite = "post" } })'

# ---- rom.lua and .ase ----

says_rom() { # NAME SENTENCE SPRITE
    sed "s/gone = { sheet = \"gone\", tag = \"late\" }/gone = { $3 }/" written/rom.lua >hits/rom.lua
    refuse "$1" "$2" "$curtain" pack hits -o hits.rom
}
says_rom "a tag that is not there" 'sprite "gone": no tag "fly"; the file has "early", "late"' \
    'sheet = "gone", tag = "fly"'
says_rom "outside" 'sprite "gone": 4x8 at 6,0 is outside the canvas of 8x8 pixels' 'sheet = "gone", x = 6, w = 4'
sed 's/art\/gone.ase/art\/gone.png/' written/rom.lua >hits/rom.lua
refuse "a tag of a PNG" 'rom.lua: sprites.gone.tag: only .ase and .aseprite files have tags' \
    "$curtain" pack hits -o hits.rom

# ---- sheets matched by index ----

mkdir -p retint/art
: >retint/main.lua
cat >retint/rom.lua <<'LUA'
return { id = "r", palette = "art/palette.png", sheets = { all = { file = "art/all.png", bank = 3 } },
  sprites = { dot = { sheet = "all", w = 4, h = 4 } } }
LUA
indexed() { # FILE W H PALETTE-SIZE INDEX...: a picture of palette indices, its colours a grey ramp that nobody uses
    python3 - "$@" <<'PY'
import struct, sys, zlib
name, w, h, n, *pixels = [sys.argv[1]] + [int(v) for v in sys.argv[2:]]
chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
rows = b"".join(b"\0" + bytes(pixels[y * w:y * w + w]) for y in range(h))
open(name, "wb").write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", w, h, 8, 3, 0, 0, 0))
                       + chunk(b"PLTE", b"".join(bytes([i ^ 85] * 3) for i in range(n))) + chunk(b"tRNS", b"\0")
                       + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
PY
}
python3 "$repo/tests/cli/png_make.py" retint/art/palette.png 16 16 102030 1 3 ff0000 15 3 00ff00
indexed retint/art/all.png 4 4 16 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15
refuse "colours that are not there: the choices" "art/all.png: pixel 1,0: colour #545454 is not in bank 3 (use \
--nearest for the nearest colour, or match = \"index\" in rom.lua to use the indices" "$curtain" pack retint -o r.rom
fits="pixel 1,0: colour #545454 is not in bank 3; 15 such pixels in total (the picture's indices fit the bank; \
to use them, set match"
refuse "check says which one fits" "$fits" "$curtain" check retint
shades() { "$curtain" unpack retint out && python3 -c 'd = open("out/lumps/gfx/dot", "rb").read()[24:]
print(*[d[y * 8 + x] for y in range(4) for x in range(4)])'; rm -rf out; }
sed -i 's/bank = 3/bank = 3, match = "index"/' retint/rom.lua
same "by index" "0 49 50 51 52 53 54 55 56 57 58 59 60 61 62 63" "$(shades)"
before=$(lump retint gfx/dot)
python3 "$repo/tests/cli/png_make.py" retint/art/palette.png 16 16 010203 1 3 0000ff
same "another palette changes no sheet" "$before" "$(lump retint gfx/dot)"
indexed retint/art/all.png 4 4 64 0 49 50 51 52 53 54 55 56 57 58 59 60 61 62 63
same "by index, of the game's whole palette" "0 49 50 51 52 53 54 55 56 57 58 59 60 61 62 63" "$(shades)"
indexed retint/art/all.png 4 4 64 0 49 50 51 52 53 36 55 56 57 58 59 60 61 62 63
refuse "of another bank" 'art/all.png: pixel 2,1: index 36 is in bank 2, expected bank 3 (48 to 63) or 0 to 15' \
    "$curtain" pack retint -o r.rom
python3 "$repo/tests/cli/png_make.py" retint/art/all.png 4 4 ff0000
refuse "a picture of colours" 'art/all.png: match = "index" needs an indexed picture; this one is RGB or greyscale' \
    "$curtain" pack retint -o r.rom

# ---- a sheet drawn in another palette ----

mkdir -p two/art
: >two/main.lua
python3 "$repo/tests/cli/png_make.py" two/art/palette.png 16 16 102030 1 3 ff0000
python3 "$repo/tests/cli/png_make.py" two/art/night.png 16 16 102030 5 3 0000ff
python3 "$repo/tests/cli/png_make.py" two/art/all.png 4 4 0000ff
drawn_in() { # what the sheet says of its palette
    cat >two/rom.lua <<LUA
return { id = "t", palette = "art/palette.png", palettes = { night = "art/night.png" },
  sheets = { all = { file = "art/all.png", bank = 3$1 } }, sprites = { dot = { sheet = "all", w = 4, h = 4 } } }
LUA
}
shade() { "$curtain" unpack two out && python3 -c 'print(open("out/lumps/gfx/dot", "rb").read()[24])'; rm -rf out; }
strange='art/all.png: pixel 0,0: colour #0000ff is not in bank 3'
drawn_in ''
refuse "the first palette has no such colour" "$strange" "$curtain" pack two -o r.rom
refuse "which check says" "$strange" "$curtain" check two
drawn_in ', palette = "night"'
same "its own has it" 53 "$(shade)"

# ---- pixels that vanish ----

faint() { # FILE ALPHA...: white pixels, each of an alpha in hexadecimal
    local file=$1
    shift
    {
        printf 'P7\nWIDTH %d\nHEIGHT 1\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n' $#
        for alpha; do printf '%b' "\xff\xff\xff\x$alpha"; done
    } | convert pam:- "png32:$file"
}
mkdir -p faint/art
echo 'bullet.def("dot", { sprite = "dot", hit = { circle = 0.5 } })' >faint/main.lua
cat >faint/rom.lua <<'LUA'
return { id = "f", sheets = { all = { file = "art/all.png" } }, sprites = { dot = { sheet = "all", w = 4, h = 1 } } }
LUA
faint faint/art/all.png ff 00 40 7f 09 09
told='art/all.png: pixel 2,0: 25 % opaque; pixels below 50 % become transparent; 2 such pixels in total'
refuse "check counts them" "$told" "$curtain" check faint
same "pack says so, and packs" "curtain: $told 0" "$("$curtain" pack faint -o f.rom 2>&1 >/dev/null) $?"
faint faint/art/all.png ff 00 80 c8
check "half and more is whole" "$curtain" check faint
same "... and nothing is said" " 0" "$("$curtain" pack faint -o f.rom 2>&1 >/dev/null) $?"

# ---- curtain art --atlas ----

cp written/main.lua hits/main.lua
cp written/rom.lua hits/rom.lua
check "the atlas" "$curtain" art hits --atlas atlas.png
colour_at() { python3 - "$@" <<'PY'
import sys
sys.path.insert(0, sys.argv[1] + "/tests/golden")
import png
w, h, rows = png.read("atlas.png")
want = bytes.fromhex(sys.argv[2])
print(sum(rows[y][3 * x:3 * x + 3] == want for y in range(h) for x in range(w)) > int(sys.argv[3]))
PY
}
for colour in "5fe3ff 20" "ff6a7a 100" "7dff8a 40" "ffd24a 100" "f2f2ee 500"; do
    same "it has pixels of #${colour% *}" True "$(colour_at "$repo" $colour)"
done
# All rows of its sprites one below the other were 23,062 pixels.
check "the atlas of a large game" "$curtain" art "$repo/roms/glasstide" --atlas large.png
same "... fits into a PNG" 1 "$(identify -format '%[fx:h < 16384]' large.png)"
echo 'return {}' >faint/rom.lua
refuse "no sprites" "--atlas: this game has no sprites" "$curtain" art faint --atlas atlas.png

# ---- curtain palette ----

printf '#FF0044\r\n00ff88\n\n123456\n' >three.hex
printf 'GIMP Palette\nName: three\nColumns: 4\n# by nobody\n' >three.gpl
printf '255   0  68\tred\n  0 255 136\n 18 52 86 dark  blue\n' >>three.gpl
same "a .hex" "p.png: 3 colours in bank 3" "$("$curtain" palette three.hex --bank 3 -o p.png)"
same "a .gpl" "q.png: 3 colours in bank 3" "$("$curtain" palette three.gpl --bank 3 -o q.png)"
check "are the same" cmp p.png q.png
"$curtain" palette p.png --bank 3 -o back.hex
same "and back" "ff0044 00ff88 123456 000000" "$(head -n 4 back.hex | tr '\n' ' ' | sed 's/ $//')"
"$curtain" palette p.png --bank 5 -o five.gpl
same "a bank over another" "q.png: 15 colours in bank 3" "$("$curtain" palette five.gpl --bank 3 -o q.png)"
"$curtain" palette q.png --bank 3 -o three_now.gpl
check "it is the other now" cmp <(tail -n 15 three_now.gpl) <(tail -n 15 five.gpl)
"$curtain" palette q.png --bank 5 -o five_now.gpl
check "the others stay" cmp five_now.gpl five.gpl
seq 100000 100019 >twenty.hex
same "more than a bank" "p.png: 20 colours in banks 4 to 5" "$("$curtain" palette twenty.hex --bank 4 -o p.png)"
"$curtain" palette p.png --bank 5 -o five.hex
same "... go on in the next" "100015 100019 000000" "$(sed -n '1p;5p;6p' five.hex | paste -sd ' ')"
cp p.png two/art/palette.png
check "a game takes it" "$curtain" pack two -o r.rom
says_palette() { refuse "$1" "$2" "$curtain" palette "${@:3}"; }
says_palette "too many" "twenty.hex: 20 colours starting in bank 15 would end in bank 16; the last bank is 15" \
    twenty.hex --bank 15 -o p.png
says_palette "no bank" "palette: expected --bank N, 0 to 15" three.hex -o p.png
printf 'ff0044\nff004\n' >bad.hex
says_palette "a short colour" 'bad.hex:2: expected a colour of six hexadecimal digits, got "ff004"' \
    bad.hex --bank 1 -o p.png
printf 'GIMP Palette\n1 2 256\n' >bad.gpl
says_palette "a large number" 'bad.gpl:2: expected red, green and blue from 0 to 255, got "1 2 256"' \
    bad.gpl --bank 1 -o p.png
cp faint/art/all.png small.png
says_palette "a palette that is none" 'small.png: 4x1 pixels, expected 16x16' three.hex --bank 1 -o small.png
check "and it is as it was" cmp small.png faint/art/all.png
finish

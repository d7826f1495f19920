#!/usr/bin/env python3
"""ase_make.py DIR: games that have a sprite twice, once from an .ase and once from a PNG on which this program has put
what it must become.

The layers are merged here a second time, with the blend modes in fractions, as books have them, and Aseprite's
rounding; each game's palette has just the colours that come of it. DIR/NAME has sprites `a` and `b`, which are to
become the same lump.
"""
import os
import random
import struct
import sys
import zlib
from fractions import Fraction as F

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from ase_file import Ase, Cel, GROUP, RAW  # noqa: E402

MODES = {
    "normal": (0, lambda b, s: s),
    "multiply": (1, lambda b, s: b * s),
    "screen": (2, lambda b, s: b + s - b * s),
    "overlay": (3, lambda b, s: MODES["hard_light"][1](s, b)),
    "darken": (4, min),
    "lighten": (5, max),
    "dodge": (6, lambda b, s: F(0) if b == 0 else F(1) if s == 1 else min(F(1), b / (1 - s))),
    "burn": (7, lambda b, s: F(1) if b == 1 else F(0) if s == 0 else 1 - min(F(1), (1 - b) / s)),
    "hard_light": (8, lambda b, s: 2 * b * s if s < F(128, 255) else b + (2 * s - 1) - b * (2 * s - 1)),
    "difference": (10, lambda b, s: abs(b - s)),
    "exclusion": (11, lambda b, s: b + s - 2 * F(nearest(b * s * 255), 255)),
    "addition": (16, lambda b, s: min(F(1), b + s)),
    "subtract": (17, lambda b, s: max(F(0), b - s)),
    "divide": (18, lambda b, s: F(0) if b == 0 else F(1) if s == 0 else min(F(1), b / s)),
}
BY_NUMBER = {number: mix for number, mix in MODES.values()}


def nearest(x):
    return int(x + F(1, 2)) if x >= 0 else -int(-x + F(1, 2))


def normal(under, colour):
    """The colour on another one, R G B A each from 0 to 255. Of an opacity of `whole` the colour has a / whole."""
    if under[3] == 0:
        return colour
    a = colour[3]
    whole = a + under[3] - nearest(F(under[3] * a, 255))
    return tuple(b + int(F((s - b) * a, whole)) for b, s in zip(under[:3], colour[:3])) + (whole,)


def over(under, colour, mode, opacity):
    """The same in a blend mode. Where the one below is not opaque, the blended result and the plain one are mixed."""
    colour = colour[:3] + (nearest(F(colour[3] * opacity, 255)),)
    plain = normal(under, colour)
    if mode == 0 or under[3] == 0:
        return plain
    mixed = tuple(nearest(BY_NUMBER[mode](F(b, 255), F(s, 255)) * 255) for b, s in zip(under[:3], colour[:3]))
    blended = normal(under, mixed + colour[3:])
    for part in (under[3], nearest(F(under[3] * colour[3], 255))):
        plain = tuple(p + nearest(F((b - p) * part, 255)) for p, b in zip(plain[:3], blended[:3])) + plain[3:]
    return plain


def colour_of(ase, layer, pixel):
    if ase.mode == "rgba":
        return pixel
    if ase.mode == "grey":
        return (pixel[0],) * 3 + (pixel[1],)
    if pixel == ase.clear and not layer.background:
        return (0, 0, 0, 0)
    return tuple(ase.palette[pixel]) + (255,)


def shown(ase, i):
    """Is the layer visible, and each group round it?"""
    level = ase.layers[i].level
    good = ase.layers[i].visible and not ase.layers[i].reference
    for layer in reversed(ase.layers[:i]):
        if layer.kind == GROUP and layer.level < level:
            good, level = good and layer.visible, layer.level
    return good


def merged(ase, frame):
    picture = [[(0, 0, 0, 0)] * ase.w for _ in range(ase.h)]
    cels = [c for c in ase.frames[frame][1] if shown(ase, c.layer)]
    for cel in sorted(cels, key=lambda c: (c.layer + c.z, c.z)):
        layer, at = ase.layers[cel.layer], cel
        while at.pixels is None:
            at = next(c for c in ase.frames[at.link][1] if c.layer == cel.layer)
        for y, row in enumerate(at.pixels):
            for x, pixel in enumerate(row):
                if 0 <= x + cel.x < ase.w and 0 <= y + cel.y < ase.h:
                    opacity = nearest(F(cel.opacity * (layer.opacity if ase.flags & 1 else 255), 255))
                    to = picture[y + cel.y]
                    to[x + cel.x] = over(to[x + cel.x], colour_of(ase, layer, pixel), layer.blend, opacity)
    return [[p if p[3] >= 128 else (0, 0, 0, 0) for p in row] for row in picture]


def order(ase, tag):
    first, last, way = next(t[1:] for t in ase.tags if t[0] == tag) if tag else (0, len(ase.frames) - 1, 0)
    frames = list(range(first, last + 1))
    if way in (1, 3):
        frames.reverse()
    return frames + (frames[-2:0:-1] if way in (2, 3) else [])


def png_chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def png(path, rows):
    raw = b"".join(b"\0" + b"".join(bytes(p) for p in row) for row in rows)
    with open(path, "wb") as f:
        head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 6, 0, 0, 0)
        f.write(b"\x89PNG\r\n\x1a\n" + png_chunk(b"IHDR", head)
                + png_chunk(b"IDAT", zlib.compress(raw)) + png_chunk(b"IEND", b""))


def game(where, ase, a="", b="", tag="", frames=None):
    """a, b: what rom.lua says of the two sprites. frames: the strip, if it is not each of the tag's once."""
    frames = order(ase, tag) if frames is None else frames
    pictures = {i: merged(ase, i) for i in set(frames)}
    strip = [[p for i in frames for p in pictures[i][y]] for y in range(ase.h)]
    colours = sorted({p[:3] for row in strip for p in row if p[3]})
    assert len(colours) <= 15, (where, len(colours))
    os.makedirs(where + "/art")
    png(where + "/art/b.png", [[p[:3] + (255,) if p[3] else (0, 0, 0, 0) for p in row] for row in strip])
    bank = [(0, 0, 0, 255)] + [c + (255,) for c in colours] + [(1, 2, 3, 255)] * (15 - len(colours))
    png(where + "/art/palette.png", [bank] * 16)
    with open(where + "/art/a.ase", "wb") as f:
        f.write(ase.whole())
    with open(where + "/main.lua", "w") as f:
        f.write("")
    with open(where + "/rom.lua", "w") as f:
        f.write('return { id = "g", palette = "art/palette.png",\n'
                '  sheets = { a = { file = "art/a.ase" }, b = { file = "art/b.png" } },\n'
                '  sprites = { a = { sheet = "a"%s%s },\n    b = { sheet = "b", w = %d, h = %d, frames = %d%s } } }\n'
                % (', tag = "%s"' % tag if tag else "", a, ase.w, ase.h, len(frames), b))


def blot(seed, w, h, colours, holes=0.3):
    """A picture of a few colours in squares, with holes of the first."""
    dice = random.Random(seed)
    cells = [[colours[0] if dice.random() < holes else dice.choice(colours[1:]) for _ in range(w)] for _ in range(h)]
    return [[cells[y // 2][x // 2] for x in range(w)] for y in range(h)]


CLEAR, RED, BLUE, GOLD = (0, 0, 0, 0), (200, 30, 40, 255), (20, 60, 220, 255), (250, 200, 80, 255)
INK = [(0, 0, 0), (250, 250, 240), (200, 40, 60), (30, 60, 160), (90, 200, 120)]


def blends(out):
    for name, (number, _) in MODES.items():
        ase = Ase(8, 8)
        ase.layer("under")
        ase.layer("over", blend=number)
        ase.frame(Cel(0, blot(1, 8, 8, [CLEAR, RED, (90, 160, 60, 255)])),
                  Cel(1, blot(2, 8, 8, [CLEAR, BLUE, GOLD]), x=1))
        game(out + "/blend_" + name, ase, "", ", every = 6")
        ase = Ase(8, 8)  # all of it half transparent
        ase.layer("under", opacity=170)
        ase.layer("over", blend=number, opacity=100)
        ase.frame(Cel(0, blot(1, 8, 8, [(0, 0, 0, 180), RED, (90, 160, 60, 255)])),
                  Cel(1, blot(2, 8, 8, [CLEAR, BLUE[:3] + (200,), GOLD]), x=1))
        game(out + "/half_" + name, ase, "", ", every = 6")


def layers(out):
    ase = Ase(9, 7)  # opacity of layers and cels, over one another and over nothing; z; what is hidden
    ase.layer("under")
    ase.layer("half", opacity=160)
    ase.layer("hidden", visible=False)
    ase.layer("closed", visible=False, kind=GROUP)
    ase.layer("in it", level=1)
    ase.layer("open", kind=GROUP)
    ase.layer("in that", level=1)
    ase.layer("traced", reference=True)
    whole = [[GOLD] * 9 for _ in range(7)]
    ase.frame(Cel(0, blot(3, 6, 5, [CLEAR, RED]), x=2, y=-1, z=7, kind=RAW), Cel(1, blot(4, 9, 7, [CLEAR, BLUE])),
              Cel(2, whole), Cel(4, whole), Cel(7, whole), Cel(6, blot(5, 4, 4, [CLEAR, GOLD]), x=7, y=5, opacity=200))
    game(out + "/layers", ase, "", ", every = 6")
    ase = Ase(6, 6, flags=0)  # without the flag a layer's opacity says nothing
    ase.layer("one", opacity=9)
    ase.frame(Cel(0, blot(6, 6, 6, [CLEAR, RED])))
    game(out + "/no_opacity", ase, "", ", every = 6")


def modes(out):
    ase = Ase(8, 6, mode="grey")
    ase.layer("grey")
    ase.frame(Cel(0, blot(7, 8, 6, [(0, 0), (90, 255), (200, 255), (30, 100)])))
    game(out + "/grey", ase, "", ", every = 6")
    for name, named in (("indexed", {}), ("clear", {"clear": 3}), ("old", {"old_palette": True}),
                        ("long", {"palette": INK + [(9, 9, 9)] * 300})):
        ase = Ase(8, 6, mode="indexed", **{"palette": INK, **named})
        ase.layer("ground", background=name == "clear")
        ase.layer("ink")
        ase.frame(Cel(0, blot(8, 8, 6, [0, 1, 2, 3])), Cel(1, blot(9, 5, 5, [0, 3, 4]), x=-2, y=3))
        game(out + "/" + name, ase, "", ", every = 6")


def tagged(out):
    ase = Ase(6, 6, mode="indexed", palette=INK)
    ase.layer("ink")
    for i in range(5):
        link = i == 3
        ase.frame(Cel(0, None if link else blot(20 + i, 6, 6, [0, 1, 2, 3]), x=1 if link else 0, link=1, kind=2 - link),
                  ms=(100, 50, 50, 150, 33)[i])
    for i, way in enumerate(("forward", "reverse", "pingpong", "pingpongreverse")):
        ase.tag(way, 0, 3, i)
        game(out + "/tag_" + way, ase, ", every = 4", ", every = 4", way)
    ase.tag("two", 1, 2, 2)
    game(out + "/tag_two", ase, "", ", every = 3", "two")
    ase.tag("uneven", 1, 3, 0)
    game(out + "/tag_uneven", ase, "", ", every = 3", "uneven", [1, 2, 3, 3, 3])
    game(out + "/tag_none", ase, ", every = 5", ", every = 5")
    game(out + "/tag_made", ase, ", every = 5, rotations = 8, sizes = { 50 }",
         ", every = 5, rotations = 8, sizes = { 50 }", "forward")
    ase.slice("foot", (0, 1, 1, 3, 3, 1, 3), pivot=True)
    game(out + "/pivot", ase, ", every = 5", ", every = 5, origin = { 2, 4 }", "forward")
    game(out + "/given", ase, ", every = 5, origin = { 0, 1 }", ", every = 5, origin = { 0, 1 }", "forward")


def main(out):
    for make in (blends, layers, modes, tagged):
        make(out)


if __name__ == "__main__":
    main(sys.argv[1])

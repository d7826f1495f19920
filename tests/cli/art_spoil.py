#!/usr/bin/env python3
"""art_spoil.py HOW FILE: writes an .ase that is malformed, or that no game can have, in the way of that name."""
import os
import struct
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from ase_file import Ase, Cel, GROUP, RAW, TILEMAP, TILES, chunk  # noqa: E402

INK = [(0, 0, 0), (250, 250, 240), (200, 40, 60)]
DOT = [[1, 1], [1, 2]]


def plain(**named):
    ase = Ase(4, 4, mode="indexed", palette=INK, **named)
    ase.layer("ink")
    ase.frame(Cel(0, DOT))
    return ase


def put(data, at, form, *values):
    return data[:at] + struct.pack(form, *values) + data[at + struct.calcsize(form):]


def first_chunk(data, kind):
    at = 128 + 16
    while struct.unpack_from("<H", data, at + 4)[0] != kind:
        at += struct.unpack_from("<I", data, at)[0]
    return at


def group(**named):
    ase = Ase(4, 4, mode="indexed", palette=INK, flags=3)
    ase.layer("all", kind=GROUP, **named)
    ase.layer("ink", level=1)
    ase.frame(Cel(1, DOT))
    return ase.whole()


def layer(**named):
    ase = Ase(4, 4)
    ase.layer("glow", **named)
    ase.frame(Cel(0, [[(1, 2, 3, 255)]]))
    return ase.whole()


def cel(c, frames=1):
    ase = plain()
    ase.frames = ase.frames * (frames - 1)
    ase.frame(c)
    return ase.whole()


def sliced(*slices, pivot=False):
    ase = plain()
    for name, x, y, w, h, *more in slices:
        ase.slice(name, (0, x, y, w, h, *more), pivot=pivot)
    return ase.whole()


def tag(first, last):
    ase = plain()
    ase.tag("fly", first, last)
    return ase.whole()


def palette(size):
    data = plain().whole()
    return put(data, first_chunk(data, 0x2019) + 6, "<I", size)


def blended():
    ase = plain()
    ase.layer("glow", opacity=100)
    ase.frame(Cel(0, DOT), Cel(1, DOT))
    return ase.whole()


def long_frames():
    ase = plain()
    ase.frames = [(ms, [Cel(0, DOT)]) for ms in [1000, 1017] * 3]
    return ase.whole()


def chunk_of(kind, more):
    """A first chunk of a kind, some bytes longer or shorter than it says."""
    data = plain().whole()
    at = first_chunk(data, kind)
    return put(data, at, "<I", struct.unpack_from("<I", data, at)[0] + more)


W = plain().whole()
HOWS = {
    "text": lambda: b"no picture at all",
    "empty": lambda: b"",
    "header": lambda: W[:90],
    "bits": lambda: put(W, 12, "<H", 24),
    "frames": lambda: put(W, 6, "<H", 0),
    "more_frames": lambda: put(W, 6, "<H", 2),
    "size": lambda: put(W, 8, "<H", 5000),
    "frame_magic": lambda: put(W, 132, "<H", 1),
    "cut": lambda: W[:-9],
    "chunk_small": lambda: put(W, 144, "<I", 5),
    "chunk_large": lambda: put(W, 144, "<I", 1 << 30),
    "chunk_short": lambda: W[:128] + struct.pack("<IHHHHI", 16 + 8, 0xF1FA, 1, 1, 0, 1) + chunk(0x2004, b"\0\0"),
    "layer_kind": lambda: put(W, first_chunk(W, 0x2004) + 8, "<H", 9),
    "layer_level": lambda: put(W, first_chunk(W, 0x2004) + 10, "<H", 3),
    "cel_layer": lambda: put(W, first_chunk(W, 0x2005) + 6, "<H", 7),
    "cel_kind": lambda: put(W, first_chunk(W, 0x2005) + 13, "<H", 4),
    "cel_size": lambda: put(W, first_chunk(W, 0x2005) + 22, "<H", 0),
    "cel_huge": lambda: put(W, first_chunk(W, 0x2005) + 22, "<HH", 65535, 65535),
    "cel_zlib": lambda: put(W, first_chunk(W, 0x2005) + 26, "<I", 0),
    "cel_less": lambda: put(W, first_chunk(W, 0x2005) + 22, "<H", 3),
    "cel_raw": lambda: put(cel(Cel(0, DOT, kind=RAW)), first_chunk(W, 0x2005) + 22, "<H", 30),
    "cel_twice": lambda: twice(),
    "link": lambda: cel(Cel(0, None, link=0)),
    "link_none": lambda: cel(Cel(0, None, link=5), 2),
    "index": lambda: cel(Cel(0, [[9]])),
    "palette": lambda: palette(0),
    "palette_large": lambda: palette(65537),
    "tilemap": lambda: layer(kind=TILEMAP),
    "group": lambda: group(opacity=90),
    "group_blend": lambda: group(blend=1),
    "soft_light": lambda: layer(blend=9),
    "hue": lambda: layer(blend=12),
    "blend": lambda: layer(blend=99),
    "tag": lambda: tag(0, 4),
    "tag_back": lambda: put(tag(0, 0), first_chunk(tag(0, 0), 0x2018) + 16, "<H", 3),
    "blended": blended,
    "long": long_frames,
    "five": lambda: sliced(*[("hit %d" % i, i % 3, 0, 1, 1) for i in range(5)]),
    "two_boxes": lambda: sliced(("box", 1, 1, 2, 2), ("box two", 1, 1, 2, 2)),
    "mixed": lambda: sliced(("hit", 1, 1, 2, 2), ("capsule", 0, 1, 4, 2)),
    "box_off": lambda: sliced(("box", 2, 2, 2, 2)),
    "capsule_off": lambda: sliced(("capsule", 0, 0, 4, 1)),
    "far": lambda: sliced(("hit", -2000000, 0, 2, 2)),
    "hidden_tilemap": lambda: hidden(),
}


def twice():
    ase = plain()
    ase.frames = [(100, [Cel(0, DOT), Cel(0, DOT)])]
    return ase.whole()


def hidden():
    """What is not shown may be anything."""
    ase = plain()
    ase.layer("tiles", kind=TILEMAP, visible=False)
    ase.layer("light", blend=9, visible=False)
    ase.frames = [(100, [Cel(0, DOT), Cel(1, DOT, kind=TILES), Cel(2, DOT)])]
    return ase.whole()


if __name__ == "__main__":
    with open(sys.argv[2], "wb") as f:
        f.write(HOWS[sys.argv[1]]())

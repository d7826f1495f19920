#!/usr/bin/env python3
"""art_spoil.py HOW FILE: writes an .ase that is malformed, or that no game can have, in the way of that name."""
import os
import struct
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from ase_file import Ase, Cel, GROUP, TILEMAP, TILES  # noqa: E402

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


def group():
    ase = Ase(4, 4, mode="indexed", palette=INK, flags=3)
    ase.layer("all", kind=GROUP, opacity=90)
    ase.layer("ink", level=1)
    ase.frame(Cel(1, DOT))
    return ase.whole()


def layer(**named):
    ase = Ase(4, 4)
    ase.layer("glow", **named)
    ase.frame(Cel(0, [[(1, 2, 3, 255)]]))
    return ase.whole()


def cel(c):
    ase = plain()
    ase.frames = []
    ase.frame(c)
    return ase.whole()


def sliced(*slices, pivot=False):
    ase = plain()
    for name, x, y, w, h, *more in slices:
        ase.slice(name, (0, x, y, w, h, *more), pivot=pivot)
    return ase.whole()


def tag():
    ase = plain()
    ase.tag("fly", 0, 4)
    return ase.whole()


def blended():
    ase = plain()
    ase.layer("glow", opacity=100)
    ase.frame(Cel(0, DOT), Cel(1, DOT))
    return ase.whole()


def long_frames():
    ase = plain()
    ase.frames = [(ms, [Cel(0, DOT)]) for ms in [1000, 1017] * 3]
    return ase.whole()


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


W = plain().whole()
HOWS = {
    "text": lambda: b"no picture at all",
    "header": lambda: W[:90],
    "bits": lambda: put(W, 12, "<H", 24),
    "frames": lambda: put(W, 6, "<H", 0),
    "frame_magic": lambda: put(W, 132, "<H", 1),
    "cut": lambda: W[:-9],
    "chunk_small": lambda: put(W, 144, "<I", 5),
    "layer_kind": lambda: put(W, first_chunk(W, 0x2004) + 8, "<H", 9),
    "cel_layer": lambda: put(W, first_chunk(W, 0x2005) + 6, "<H", 7),
    "cel_kind": lambda: put(W, first_chunk(W, 0x2005) + 13, "<H", 4),
    "cel_size": lambda: put(W, first_chunk(W, 0x2005) + 22, "<H", 0),
    "cel_huge": lambda: put(W, first_chunk(W, 0x2005) + 22, "<HH", 65535, 65535),
    "cel_zlib": lambda: put(W, first_chunk(W, 0x2005) + 26, "<I", 0),
    "cel_twice": twice,
    "link": lambda: cel(Cel(0, None, link=0)),
    "index": lambda: cel(Cel(0, [[9]])),
    "palette": lambda: put(W, first_chunk(W, 0x2019) + 6, "<I", 0),
    "tilemap": lambda: layer(kind=TILEMAP),
    "group": group,
    "soft_light": lambda: layer(blend=9),
    "tag": tag,
    "blended": blended,
    "long": long_frames,
    "five": lambda: sliced(*[("hit %d" % i, i % 3, 0, 1, 1) for i in range(5)]),
    "two_boxes": lambda: sliced(("box", 1, 1, 2, 2), ("box two", 1, 1, 2, 2)),
    "mixed": lambda: sliced(("hit", 1, 1, 2, 2), ("capsule", 0, 1, 4, 2)),
    "box_off": lambda: sliced(("box", 2, 2, 2, 2)),
    "capsule_off": lambda: sliced(("capsule", 0, 0, 4, 1)),
    "far": lambda: sliced(("hit", -2000000, 0, 2, 2)),
    "hidden_tilemap": hidden,
}


if __name__ == "__main__":
    with open(sys.argv[2], "wb") as f:
        f.write(HOWS[sys.argv[1]]())

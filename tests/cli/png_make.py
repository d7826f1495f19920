#!/usr/bin/env python3
"""png_make.py [--KIND] FILE W H COLOUR [X Y COLOUR]...: a PNG of one colour (rrggbb), and single pixels of others.

KIND is rgb (that is without one), rgba, rgba16 (16 bits a channel) or indexed."""
import struct
import sys
import zlib

KINDS = {"rgb": (8, 2), "rgba": (8, 6), "rgba16": (16, 6), "indexed": (8, 3)}  # bits and colour type


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def pixel(kind, colour, palette):
    if kind == "indexed":
        return bytes([palette.index(colour)])
    whole = colour + (b"" if kind == "rgb" else b"\xff")
    return bytes(b for b in whole for _ in range(2)) if kind == "rgba16" else whole


def main(kind, path, w, h, colour, *dots):
    w, h = int(w), int(h)
    rows = [[bytes.fromhex(colour)] * w for _ in range(h)]
    for x, y, other in zip(dots[0::3], dots[1::3], dots[2::3]):
        rows[int(y)][int(x)] = bytes.fromhex(other)
    palette = sorted({colour for row in rows for colour in row})
    raw = b"".join(b"\0" + b"".join(pixel(kind, colour, palette) for colour in row) for row in rows)
    with open(path, "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", w, h, *KINDS[kind], 0, 0, 0)))
        if kind == "indexed":
            f.write(chunk(b"PLTE", b"".join(palette)))
        f.write(chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b""))


words = sys.argv[1:]
main(words.pop(0)[2:] if words[0].startswith("--") else "rgb", *words)

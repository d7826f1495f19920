#!/usr/bin/env python3
"""png_make.py FILE W H COLOUR [X Y COLOUR]...: a PNG of one colour (rrggbb), and single pixels of others."""
import struct
import sys
import zlib


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def main(path, w, h, colour, *dots):
    w, h = int(w), int(h)
    rows = [[bytes.fromhex(colour)] * w for _ in range(h)]
    for x, y, other in zip(dots[0::3], dots[1::3], dots[2::3]):
        rows[int(y)][int(x)] = bytes.fromhex(other)
    raw = b"".join(b"\0" + b"".join(row) for row in rows)
    with open(path, "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", w, h, 8, 2, 0, 0, 0)))
        f.write(chunk(b"IDAT", zlib.compress(raw)) + chunk(b"IEND", b""))


main(*sys.argv[1:])

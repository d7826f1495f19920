#!/usr/bin/env python3
"""pictures.py - frames (PNG or PPM) side by side on one PNG, every pixel a square of the same whole size: pictures.py
SCALE OUT IN..."""
import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "tests", "golden"))
import png  # noqa: E402

GAP, GREY = 8, 0x28


def read(name):
    if not name.endswith(".ppm"):
        return png.read(name)
    head, rest = open(name, "rb").read().split(b"\n", 1)
    w, h = (int(n) for n in head.split()[1:3])
    return w, h, [rest[3 * w * y:3 * w * (y + 1)] for y in range(h)]


def main(scale, out, names):
    pictures = [read(name) for name in names]
    high = max(h for _, h, _ in pictures) * scale
    lines = [bytearray() for _ in range(high)]
    for i, (w, h, rows) in enumerate(pictures):
        for y, line in enumerate(lines):
            if i:
                line.extend([GREY] * 3 * GAP)
            row = rows[y // scale] if y // scale < h else bytes([GREY] * 3 * w)
            for x in range(w):
                line.extend(bytes(row[3 * x:3 * x + 3]) * scale)
    png.write(out, len(lines[0]) // 3, high, [bytes(line) for line in lines])


main(int(sys.argv[1]), sys.argv[2], sys.argv[3:])

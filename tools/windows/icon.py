#!/usr/bin/env python3
"""icon.py - makes a Windows icon of PNG pictures.

    tools/windows/icon.py OUT.ico share/icons/*.png

Sizes that no picture has are made of the smallest picture that is a multiple of them, each pixel the mean of a square.
Up to 64 pixels an image is a bitmap, which every version of Windows reads; a larger one stays PNG."""
import struct
import sys
import zlib

SIZES = (16, 24, 32, 48, 64, 128, 256)
LARGEST_BITMAP = 64


def paeth(a, b, c):
    p = a + b - c
    pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
    return a if pa <= pb and pa <= pc else b if pb <= pc else c


def read_png(data):
    """Returns the width and the rows of a square picture of 8-bit RGBA, not interlaced."""
    if data[:8] != b"\x89PNG\r\n\x1a\n":
        raise ValueError("not a PNG")
    packed, at = b"", 8
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        chunk = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", chunk)
            if (depth, colour, interlaced) != (8, 6, 0) or width != height:
                raise ValueError("expected a square of 8-bit RGBA, not interlaced")
        elif kind == b"IDAT":
            packed += chunk
        at += 12 + size
    raw, pitch, rows = zlib.decompress(packed), 4 * width, []
    above = bytearray(pitch)
    for y in range(height):
        line = raw[y * (pitch + 1):(y + 1) * (pitch + 1)]
        how, row = line[0], bytearray(line[1:])
        for i in range(pitch):
            left = row[i - 4] if i >= 4 else 0
            corner = above[i - 4] if i >= 4 else 0
            add = (0, left, above[i], (left + above[i]) // 2, paeth(left, above[i], corner))[how]
            row[i] = (row[i] + add) & 255
        rows.append(row)
        above = row
    return width, rows


def shrink(rows, by):
    """The mean of squares of by * by pixels, colours weighted by how opaque they are."""
    out = []
    for y in range(0, len(rows), by):
        row = bytearray()
        for x in range(0, len(rows), by):
            pixels = [rows[y + j][4 * (x + i):4 * (x + i) + 4] for j in range(by) for i in range(by)]
            alpha = sum(p[3] for p in pixels)
            for c in range(3):
                row.append((sum(p[c] * p[3] for p in pixels) + alpha // 2) // alpha if alpha else 0)
            row.append((alpha + by * by // 2) // (by * by))
        out.append(row)
    return out


def bitmap(rows):
    """A device-independent bitmap of 32 bits, rows from the bottom, and the mask that Windows wants below it."""
    n = len(rows)
    head = struct.pack("<IiiHHIIiiII", 40, n, 2 * n, 1, 32, 0, 0, 0, 0, 0, 0)
    colours, mask = bytearray(), bytearray()
    for row in reversed(rows):
        bits = bytearray((n + 31) // 32 * 4)
        for x in range(n):
            r, g, b, a = row[4 * x:4 * x + 4]
            colours += bytes((b, g, r, a))
            if a < 128:
                bits[x // 8] |= 128 >> x % 8
        mask += bits
    return head + bytes(colours) + bytes(mask)


def main(out, names):
    files, pictures = {}, {}
    for name in names:
        with open(name, "rb") as f:
            data = f.read()
        size, rows = read_png(data)
        files[size], pictures[size] = data, rows
    images = []
    for size in SIZES:
        of = min((n for n in pictures if n % size == 0), default=None)
        if of is None:
            continue
        if size > LARGEST_BITMAP:
            if size in files:
                images.append((size, files[size]))
            continue
        images.append((size, bitmap(shrink(pictures[of], of // size))))
    directory, bodies = struct.pack("<HHH", 0, 1, len(images)), b""
    start = 6 + 16 * len(images)
    for size, body in images:
        directory += struct.pack("<BBBBHHII", size & 255, size & 255, 0, 0, 1, 32, len(body), start + len(bodies))
        bodies += body
    with open(out, "wb") as f:
        f.write(directory + bodies)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])

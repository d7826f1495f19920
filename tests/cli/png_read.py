#!/usr/bin/env python3
"""png_read.py FILE.png: the picture as raw bytes on standard output, read by nothing of Curtain's.

"W H KIND\\n" (KIND 3: palette, 2: RGB), the palette's 768 bytes if it has one, then the pixels row by row. Every
chunk's CRC is checked, and that the pixels are as many as they should be. Filters are undone; 8 bits a sample, not
interlaced.
"""
import struct
import sys
import zlib


def chunks(data):
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "signature"
    at = 8
    while at < len(data):
        (size,) = struct.unpack(">I", data[at : at + 4])
        kind, body = data[at + 4 : at + 8], data[at + 8 : at + 8 + size]
        (crc,) = struct.unpack(">I", data[at + 8 + size : at + 12 + size])
        assert zlib.crc32(kind + body) == crc, "CRC of %r" % kind
        yield kind, body
        at += 12 + size


def paeth(a, b, c):
    p = a + b - c
    nearest = min(abs(p - a), abs(p - b), abs(p - c))
    return a if abs(p - a) == nearest else b if abs(p - b) == nearest else c


def unfilter(kind, row, above, step):
    out = bytearray(row)
    for i in range(len(out)):
        left = out[i - step] if i >= step else 0
        up = above[i]
        corner = above[i - step] if i >= step else 0
        add = {0: 0, 1: left, 2: up, 3: (left + up) // 2, 4: paeth(left, up, corner)}[kind]
        out[i] = (out[i] + add) & 255
    return out


def main(path):
    with open(path, "rb") as f:
        parts = list(chunks(f.read()))
    assert parts[0][0] == b"IHDR" and parts[-1] == (b"IEND", b""), "order of chunks"
    w, h, bits, kind, packing, filters, interlaced = struct.unpack(">IIBBBBB", parts[0][1])
    assert (bits, packing, filters, interlaced) == (8, 0, 0, 0) and kind in (2, 3), "header"
    raw = zlib.decompress(b"".join(body for name, body in parts if name == b"IDAT"))
    step = 1 if kind == 3 else 3
    stride = w * step + 1
    assert len(raw) == stride * h, "%d bytes of pixels, expected %d" % (len(raw), stride * h)
    out, above = sys.stdout.buffer, bytes(stride - 1)
    out.write(b"%d %d %d\n" % (w, h, kind))
    if kind == 3:
        (palette,) = [body for name, body in parts if name == b"PLTE"]
        assert len(palette) == 768, "palette"
        out.write(palette)
    for y in range(h):
        above = unfilter(raw[y * stride], raw[y * stride + 1 : (y + 1) * stride], above, step)
        out.write(above)


main(sys.argv[1])

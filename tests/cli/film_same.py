#!/usr/bin/env python3
"""film_same.py FILM DIR FIRST LAST [SCALE [SPEED]]: is the film, read by nothing of Curtain's, the frames FIRST to LAST
that `curtain render` wrote into DIR, to the last pixel and at the right times? SPEED is N or 1/N.

GIF (what is read is written from the GIF89a specification) and y4m, told by how the file begins. Prints
"KIND PICTURES OWN SMALLER": how many pictures it has, how many of them bring a palette, and how many are smaller than
the whole.
"""
import os
import struct
import sys
import zlib


def lzw(data, size):
    """The indices in the data of a GIF's picture whose code size is `size`."""
    clear, stop = 1 << size, (1 << size) + 1
    out, table, bits, held, n, before = [], [], size + 1, 0, 0, None
    for byte in data:
        held |= byte << n
        n += 8
        while n >= bits:
            code, held, n = held & (1 << bits) - 1, held >> bits, n - bits
            if code == clear:
                table = [bytes([i]) for i in range(clear)] + [b"", b""]
                bits, before = size + 1, None
                continue
            if code == stop:
                return b"".join(out)
            assert code < len(table) or code == len(table) and before, "code %d of %d" % (code, len(table))
            now = table[code] if code < len(table) else before + before[:1]
            out.append(now)
            if before is not None and len(table) < 4096:
                table.append(before + now[:1])
                if len(table) == 1 << bits and bits < 12:
                    bits += 1
            before = now
    raise AssertionError("no end code")


class Screen:
    """What is shown: pixels of three bytes."""

    def __init__(self, w, h):
        self.w, self.h, self.rows = w, h, [bytearray(3 * w) for _ in range(h)]

    def put(self, x, y, w, h, pixels, see=None):
        assert w > 0 and h > 0 and x + w <= self.w and y + h <= self.h, "a picture outside of the screen"
        for row in range(h):
            line = pixels[row * w : (row + 1) * w]
            if see is None:
                self.rows[y + row][3 * x : 3 * (x + w)] = b"".join(line)
                continue
            for i, pixel in enumerate(line):
                if pixel is not see:
                    self.rows[y + row][3 * (x + i) : 3 * (x + i) + 3] = pixel

    def all(self):
        return b"".join(self.rows)


def palette_of(data, n):
    return [data[3 * i : 3 * i + 3] for i in range(n)]


def read_gif(d):
    """Yields (hundredths, screen, own palette?, whole?) a picture."""
    w, h, flags = struct.unpack_from("<HHB", d, 6)
    assert d[:6] == b"GIF89a" and flags & 0x87 == 0x87, "header"
    everywhere, at, screen, control, loops = palette_of(d[13:], 256), 13 + 768, Screen(w, h), None, False

    def blocks(at):
        parts = []
        while d[at]:
            parts.append(d[at + 1 : at + 1 + d[at]])
            assert len(parts[-1]) == d[at], "a block is cut short"
            at += 1 + d[at]
        return b"".join(parts), at + 1

    while d[at] != 0x3B:
        if d[at] == 0x21:
            kind = d[at + 1]
            body, at = blocks(at + 2)
            loops |= kind == 0xFF and body == b"NETSCAPE2.0\1\0\0"
            control = struct.unpack("<BHB", body) if kind == 0xF9 else control
            continue
        assert d[at] == 0x2C and control, "a block of kind %d" % d[at]
        x, y, pw, ph, flags = struct.unpack_from("<HHHHB", d, at + 1)
        at += 10
        assert flags & 0x40 == 0 and control[0] & 0x1C == 4, "interlaced, or taken away"
        own = flags & 0x80
        palette = palette_of(d[at:], 2 << (flags & 7)) if own else everywhere
        at += 3 * (2 << (flags & 7)) if own else 0
        size = d[at]
        data, at = blocks(at + 1)
        indices = lzw(data, size)
        assert len(indices) == pw * ph, "%d pixels of %d" % (len(indices), pw * ph)
        see = object() if control[0] & 1 else None
        colours = [see if see and i == control[2] else c for i, c in enumerate(palette)]
        screen.put(x, y, pw, ph, [colours[i] for i in indices], see)
        yield control[1], screen, bool(own), (pw, ph) == (w, h)
        control = None
    assert at + 1 == len(d) and loops, "the end"


def chunks(d):
    assert d[:8] == b"\x89PNG\r\n\x1a\n", "signature"
    at = 8
    while at < len(d):
        (size,) = struct.unpack_from(">I", d, at)
        kind, body = d[at + 4 : at + 8], d[at + 8 : at + 8 + size]
        assert zlib.crc32(kind + body) == struct.unpack_from(">I", d, at + 8 + size)[0], "CRC of %r" % kind
        yield kind, body
        at += 12 + size


def png_pixels(packed, w, h, palette):
    raw, step = zlib.decompress(packed), 1 if palette else 3
    assert len(raw) == (w * step + 1) * h, "%d bytes of pixels" % len(raw)
    rows = [raw[y * (w * step + 1) :][: w * step + 1] for y in range(h)]
    assert not any(row[0] for row in rows), "a filter"
    if palette:
        return [palette[i] for row in rows for i in row[1:]]
    return [row[1 + 3 * x : 4 + 3 * x] for row in rows for x in range(w)]


def read_png(d):
    """The screen of a PNG file."""
    parts = list(chunks(d))
    assert parts[0][0] == b"IHDR" and parts[-1] == (b"IEND", b""), "order of chunks"
    w, h, bits, kind, *rest = struct.unpack(">IIBBBBB", parts[0][1])
    assert bits == 8 and kind in (2, 3) and rest == [0, 0, 0], "header"
    palette = next((palette_of(body, len(body) // 3) for name, body in parts if name == b"PLTE"), None)
    screen = Screen(w, h)
    screen.put(0, 0, w, h, png_pixels(b"".join(body for name, body in parts if name == b"IDAT"), w, h, palette))
    return screen


def nearest(rgb):
    """The codes of BT.601, from its own constants."""
    r, g, b = (v / 255 for v in rgb)
    y = 0.299 * r + 0.587 * g + 0.114 * b
    return 16 + 219 * y, 128 + 112 * (b - y) / 0.886, 128 + 112 * (r - y) / 0.701


def same_y4m(d, wanted):
    """Compares each picture with the next wanted one; returns how many there are."""
    head, _, d = d.partition(b"\n")
    words, n, at, known = head.split(), 0, 0, {}
    assert words[0] == b"YUV4MPEG2" and b"F60:1" in words and b"C444" in words, head
    w, h = (int(next(x for x in words if x[:1] == side)[1:]) for side in (b"W", b"H"))
    while at < len(d):
        want = next(wanted)
        assert d[at : at + 6] == b"FRAME\n", "FRAME"
        planes = [d[at + 6 + i * w * h : at + 6 + (i + 1) * w * h] for i in range(3)]
        assert len(want) == 3 * w * h and len(planes[2]) == w * h, "size"
        for i, code in enumerate(zip(*planes)):
            rgb = want[3 * i : 3 * i + 3]
            if rgb not in known:
                assert all(abs(a - b) < 0.502 for a, b in zip(code, nearest(rgb))), (rgb, code)
                known[rgb] = code
            assert known[rgb] == code, "a colour has two codes"
        at += 6 + 3 * w * h
        n += 1
    assert len(set(known.values())) * 4 > len(known), "hardly a colour"
    return n


def main(path, folder, first, last, scale="1", speed="1"):
    first, last, scale = int(first), int(last), int(scale)
    faster, slower = (1, int(speed[2:])) if speed.startswith("1/") else (int(speed), 1)
    with open(path, "rb") as f:
        d = f.read()
    kept = {}

    def frame(n):
        if n not in kept:
            with open(os.path.join(folder, "%06d.png" % n), "rb") as f:
                screen = read_png(f.read())
            kept.clear()
            wide = [b"".join(row[3 * x : 3 * x + 3] * scale for x in range(screen.w)) for row in screen.rows]
            kept[n] = b"".join(row for row in wide for _ in range(scale))
        return kept[n]

    def pictures(rate):
        k = 0
        while k * 60 * faster // (rate * slower) <= last - first:
            yield frame(first + k * 60 * faster // (rate * slower))
            k += 1

    if d[:9] == b"YUV4MPEG2":
        wanted = pictures(60)
        n = same_y4m(d, wanted)
        assert next(wanted, None) is None, "pictures are missing"
        print("y4m", n, 0, 0)
        return
    count, own, smaller, step = 0, 0, 0, 2
    wanted, before, long = pictures(50), None, False
    for delay, screen, has_own, whole in read_gif(d):
        assert delay > 0 and delay % step == 0, "a delay of %d" % delay
        now = screen.all()
        assert now != before or long, "a picture like the one before"
        long, before = delay >= 65534, now
        for _ in range(delay // step):
            assert next(wanted, None) == now, "picture %d is not the frame" % count
        count, own, smaller = count + 1, own + has_own, smaller + (not whole)
    assert next(wanted, None) is None, "it ends too early"
    print("gif", count, own, smaller)


main(*sys.argv[1:])

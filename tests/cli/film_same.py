#!/usr/bin/env python3
"""film_same.py FILM DIR FIRST LAST [SCALE [SPEED]]: is the film the frames FIRST to LAST that `curtain render` wrote
into DIR, to the last pixel and at the right times? SPEED is N or 1/N.

ImageMagick decodes GIFs; y4m is read here. Prints "KIND PICTURES SMALLER": how many pictures it has, and how many of
them are smaller than the whole.
"""
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "golden"))
import png


def read_gif(path):
    """(hundredths, pixels, smaller than the whole?) of each picture."""
    said = subprocess.run(["identify", "-format", "%T %w %h %W %H\n", path], stdout=subprocess.PIPE, check=True).stdout
    parts = [list(map(int, line.split())) for line in said.decode().splitlines()]
    raw = subprocess.run(["convert", path, "-coalesce", "-depth", "8", "rgb:-"], stdout=subprocess.PIPE,
                         check=True).stdout
    size = 3 * parts[0][3] * parts[0][4]
    assert len(raw) == size * len(parts), "%d bytes of %d pictures" % (len(raw), len(parts))
    for i, (delay, w, h, all_w, all_h) in enumerate(parts):
        yield delay, raw[i * size:(i + 1) * size], (w, h) != (all_w, all_h)


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
        assert d[at:at + 6] == b"FRAME\n", "FRAME"
        planes = [d[at + 6 + i * w * h:at + 6 + (i + 1) * w * h] for i in range(3)]
        assert len(want) == 3 * w * h and len(planes[2]) == w * h, "size"
        for i, code in enumerate(zip(*planes)):
            rgb = want[3 * i:3 * i + 3]
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
    kept = {}

    def frame(n):
        if n not in kept:
            w, _, rows = png.read(os.path.join(folder, "%06d.png" % n))
            kept.clear()
            wide = [b"".join(row[3 * x:3 * x + 3] * scale for x in range(w)) for row in rows]
            kept[n] = b"".join(row for row in wide for _ in range(scale))
        return kept[n]

    def pictures(rate):
        k = 0
        while k * 60 * faster // (rate * slower) <= last - first:
            yield frame(first + k * 60 * faster // (rate * slower))
            k += 1

    with open(path, "rb") as f:
        d = f.read()
    if d[:9] == b"YUV4MPEG2":
        wanted = pictures(60)
        n = same_y4m(d, wanted)
        assert next(wanted, None) is None, "pictures are missing"
        print("y4m", n, 0)
        return
    assert b"NETSCAPE2.0\3\1\0\0\0" in d, "it does not repeat"
    count, smaller, wanted, before, long = 0, 0, pictures(50), None, False
    for delay, now, is_smaller in read_gif(path):
        assert delay > 0 and delay % 2 == 0, "a delay of %d" % delay
        assert now != before or long, "a picture like the one before"
        long, before = delay >= 65534, now
        for _ in range(delay // 2):
            assert next(wanted, None) == now, "picture %d is not the frame" % count
        count, smaller = count + 1, smaller + is_smaller
    assert next(wanted, None) is None, "it ends too early"
    print("gif", count, smaller)


main(*sys.argv[1:])

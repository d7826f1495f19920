#!/usr/bin/env python3
"""canyon.py DIR: draws examples/canyon/art and examples/canyon/maps: the sea, the clouds, the cliffs at both edges of
the field, and the enemies. All noise is periodic, so that the maps repeat."""
import math
import os
import struct
import sys
import zlib

SIDE = 16  # px, of a tile
# Banks of 16 colours.
SEA = ("04060e 0a1c3c 0e2a54 12386a 174a80 1f6094 2c7aa6 44969f "
       "6cb2a0 e0c890 c8a868 4c8a4c 347040 24583a 1a4432 d8f4f4")
CLOUDS = ("04060e 24406c 30507c 40628c 54789e 6c90b0 86a8c4 a0bed4 "
          "b8d0e2 ccdfec dce9f4 e8f1f9 f0f6fc f6fafe fbfdff ffffff")
CLIFFS = ("04060e 180c14 2c161c 442226 5c3030 784038 945444 b06a50 "
          "c88460 dca074 f0c090 1c2c20 2c4828 40683a 5c8c4a 84b460")
METAL = ("04060e 0e0c14 1f2430 343e4e 4c5a6c 67788c 8798ac aabaca "
         "d0dae5 f4f8fc 5c1420 a82430 e85038 ffa040 ffe08a ffffff")
BULLETS = """
04060e 10162e 1f284c 2d3a6a 3c4c88 4f62a0 6177b7 748dcf 86a2e6 98b3ee abc3f7 bdd4ff d1e2ff e4efff f2f7ff ffffff
04060e 2c0410 4d0719 6d0a23 8e0d2c a71431 c01b35 d9213a f2283e f63f4a fb5756 ff6e62 ff9a8d ffc6b8 ffe3dc ffffff
04060e 2c0e04 4f1b04 712904 943604 ad4807 c6590a df6b0d f87c10 fa8d21 fd9f33 ffb044 ffc97a ffe2b0 fff1d8 ffffff
04060e 241a02 443403 644e05 846806 9e800b b7980f d1b014 eac818 f1d32d f8dd43 ffe858 ffef8a fff6bc fffbde ffffff
04060e 042210 063b1d 085329 0a6c36 108540 169e49 1cb753 22d05c 3edc69 5ae875 76f482 a2faa5 ceffc8 e7ffe4 ffffff
04060e 032028 043745 054f61 06667e 0a7d96 0d93ad 11aac5 14c0dc 2fcfe4 49ddec 64ecf4 97f4fa cafcff e5feff ffffff
04060e 0c0c3e 151964 1f258a 2832b0 3141c4 3a4fd8 435eeb 4c6cff 6081ff 7495ff 88aaff adc4ff d2deff e9efff ffffff
04060e 26062e 440b4b 620f69 801486 9a1f9d b42ab4 ce35cb e840e2 f059e7 f771eb ff8af0 ffaff5 ffd4fa ffeafd ffffff
04060e 140c1c 54486a 867891 b8a8b8 dcd0d2 fff8ec 7c1428 d82c38 ff7a68 5c3818 b88032 f0c868 ffb040 ffd8a0 ffffff
""".strip().splitlines()  # banks 0 to 8, as in examples/shooter
BANKS = dict(enumerate(BULLETS)) | {11: METAL, 13: SEA, 14: CLOUDS, 15: CLIFFS}
DITHER = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]]


def hashed(x, y, seed):
    """A number from 0 to 1 for a point of a grid."""
    v = (x * 374761393 + y * 668265263 + seed * 2246822519) & 0xffffffff
    v = ((v ^ v >> 13) * 1274126177) & 0xffffffff
    return ((v ^ v >> 16) & 0xffffff) / 0x1000000


def noise(x, y, w, h, cell, seed):
    """Smooth noise from 0 to 1 with a value every `cell` px, which repeats after w and h px."""
    cols, rows = w // cell, h // cell
    i, j = int(x // cell), int(y // cell)
    u, v = x / cell - i, y / cell - j
    u, v = u * u * (3 - 2 * u), v * v * (3 - 2 * v)
    a, b = hashed(i % cols, j % rows, seed), hashed((i + 1) % cols, j % rows, seed)
    c, d = hashed(i % cols, (j + 1) % rows, seed), hashed((i + 1) % cols, (j + 1) % rows, seed)
    return (a + (b - a) * u) * (1 - v) + (c + (d - c) * u) * v


def hills(x, y, w, h, seed, cells=(64, 32, 16, 8)):
    """Noise with details: each finer one half as strong."""
    total = weight = 0
    for k, cell in enumerate(cells):
        total += noise(x, y, w, h, cell, seed + k) / 2 ** k
        weight += 1 / 2 ** k
    return total / weight


def dithered(shade, x, y):
    """A shade with a fraction, as a pattern of the two next to it."""
    return int(math.floor(shade + (DITHER[y % 4][x % 4] + 0.5) / 16))


def sea(w, h):
    """Islands in a sea that is brighter where it is shallow."""
    steps = [(0.60, 9), (0.615, 10), (0.66, 11), (0.72, 12), (0.78, 13), (9, 14)]
    rows = []
    for y in range(h):
        row = []
        for x in range(w):
            z = hills(x, y, w, h, 1)
            if z < 0.585:
                wave = noise(x, y * 2, w, h * 2, 8, 9) - 0.5
                shade = dithered(2.0 + 6 * max(0, (z - 0.3) / 0.285) ** 1.6 + 0.9 * wave, x, y)
                row.append(15 if 0.574 < z and noise(x, y, w, h, 4, 11) > 0.55 else max(1, min(8, shade)))
            else:
                lit = hills(x + 2, y + 2, w, h, 1) - z  # towards the light at the top left
                shade = next(s for limit, s in steps if z < limit)
                if shade >= 11:
                    shade += lit > 0.006 and 1 or lit < -0.006 and -1 or 0
                row.append(max(9, min(14, shade)))
        rows.append(row)
    return rows


def clouds(w, h):
    """Banks of cloud, lit from the top left; 0 between them."""
    rows = []
    for y in range(h):
        row = []
        for x in range(w):
            z = hills(x, y, w, h, 31)
            light = hills(x - 5, y - 5, w, h, 31)
            shade = 3 + (z - 0.6) * 26 + (z - light) * 34
            row.append(max(2, min(11, dithered(shade, x, y))) if z > 0.6 + 0.02 * hashed(x, y, 5) else 0)
        rows.append(row)
    return rows


def cliff_edge(y, h, seed):
    """How far a cliff reaches into the field, px."""
    layers = enumerate(((24, 64), (12, 16), (4, 4)))
    return 28 + sum(size * noise(0, y, 64, h, cell, seed + k) for k, (size, cell) in layers)


def rock(x, y, h, depth, seed):
    """A shade of the rock at a depth in px from the edge: bright at the top, with ledges and cracks."""
    z = hills(x, y, 256, h, seed, (16, 8, 4))
    lit = hills(x - 1, y - 2, 256, h, seed, (16, 8, 4)) - z
    ledge = (depth + 9 * z) % 9 < 2
    return 2.2 + 6 * min(1, depth / 22) + 3 * (z - 0.5) - 26 * lit - 2.2 * ledge


def forest(x, y, h, seed):
    """A shade of the trees: crowns lit from the top left."""
    z = noise(x, y, 256, h, 8, seed) + 0.5 * noise(x, y, 256, h, 4, seed + 1)
    lit = noise(x - 2, y - 2, 256, h, 8, seed) + 0.5 * noise(x - 2, y - 2, 256, h, 4, seed + 1) - z
    return 12.2 + 1.6 * z - 4 * lit


def cliffs(w, h):
    """The left cliff, then the right one, each w px wide: trees at the top, rock that falls to the water."""
    rows = []
    for y in range(h):
        row = []
        for side in range(2):
            edge = cliff_edge(y, h, 51 + 7 * side)
            top = 12 + 14 * noise(0, y, 64, h, 16, 91 + side) + 5 * noise(0, y, 64, h, 4, 93 + side)
            line = []
            for x in range(w):
                depth, at = edge - x, (x + 128 if side == 0 else 64 - x)
                if depth < 0:
                    line.append(1 if depth > -3 and (x + y) % 2 else 0)  # its shadow on the water
                elif depth > top:
                    line.append(max(11, min(15, dithered(forest(at, y, h, 71), x, y))))
                else:
                    line.append(max(1, min(10, dithered(rock(at, y, h, depth, 61) - side, x, y))))
            row += line if side == 0 else line[::-1]
        rows.append(row)
    return rows


# ---- the enemies, in METAL: 1 to 9 metal from dark to light, 10 to 12 red, 13 to 15 light ----

def canvas(w, h):
    return [[0] * w for _ in range(h)]


def outline(rows):
    """Puts shade 1 around what is drawn."""
    h, w = len(rows), len(rows[0])
    solid = {(x, y) for y in range(h) for x in range(w) if rows[y][x]}
    for x, y in {(x + dx, y + dy) for x, y in solid for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1))} - solid:
        if 0 <= x < w and 0 <= y < h:
            rows[y][x] = 1
    return rows


def ball(rows, cx, cy, rx, ry, low, high):
    """An ellipsoid lit from the top left, in the shades from low to high."""
    for y in range(len(rows)):
        for x in range(len(rows[0])):
            u, v = (x + 0.5 - cx) / rx, (y + 0.5 - cy) / ry
            if u * u + v * v <= 1:
                light = 0.62 - 0.42 * u - 0.34 * v - 0.30 * (u * u + v * v)
                rows[y][x] = max(low, min(high, dithered(low + light * (high - low + 1), x, y)))


def rect(rows, x0, y0, x1, y1, shade):
    for y in range(y0, y1):
        for x in range(x0, x1):
            rows[y][x] = shade


def drone(frame):
    """Four rotors around a hull with an eye."""
    rows = canvas(28, 28)
    for k in range(4):
        x, y = (7, 21)[k % 2], (7, 21)[k // 2]
        for t in range(0, 80):
            r = t / 10
            rect_x, rect_y = 14 + (x - 14) * r / 8, 14 + (y - 14) * r / 8
            rows[int(rect_y)][int(rect_x)] = 4
            rows[int(rect_y)][int(rect_x) - 1] = 3
    ball(rows, 14, 14, 6.5, 6.5, 3, 9)
    outline(rows)
    for k in range(4):
        x, y = (7, 21)[k % 2], (7, 21)[k // 2]
        turn = (frame * math.pi / 4 + k * 0.7)
        for py in range(28):
            for px in range(28):
                dx, dy = px + 0.5 - x, py + 0.5 - y
                d = math.hypot(dx, dy)
                blade = abs(math.sin(math.atan2(dy, dx) - turn)) < 0.34
                if d < 6.3 and (d > 5.3 or (blade and d < 5.3)):
                    rows[py][px] = (8 if dx + dy < 0 else 6) if blade else 5
                elif d < 1.2:
                    rows[py][px] = 2
    for dy in range(-2, 3):
        for dx in range(-2, 3):
            if dx * dx + dy * dy < 6:
                rows[14 + dy][14 + dx] = 15 if (dx, dy) == (-1, -1) else 12 if abs(dx) + abs(dy) > 2 else 13 + frame % 2
    return rows


def airship(frame):
    """A long hull from above, with engines at its sides and fins at its tail."""
    w, h = 52, 76
    rows = canvas(w, h)
    for side in (-1, 1):
        x = 26 + side * 18
        for y in range(30, 47):  # engines
            for dx in range(-3, 4):
                rows[y][x + dx] = 7 if dx < -1 else 5 if dx < 2 else 3
        rect(rows, min(26, x), 36, max(26, x), 40, 4)
        for k in range(14):  # fins
            x = 26 + side * (8 + k)
            rect(rows, x, 6 + k // 3, x + 1, 16 - k // 4, 11 if k < 11 else 10)
    ball(rows, 26, 38, 13.5, 35, 3, 9)
    outline(rows)
    for y in range(6, 71):
        half = 13.5 * math.sqrt(max(0, 1 - ((y + 0.5 - 38) / 35) ** 2))
        for x in range(int(26 - half) + 1, int(26 + half)):
            u = (x + 0.5 - 26) / max(half, 1)
            if abs(abs(u) - 0.45) < 0.6 / max(half, 1):
                rows[y][x] = max(2, rows[y][x] - 2)  # seams along the hull
            if y % 16 in (5, 6) and 14 < y < 66:
                rows[y][x] = (12, 11, 10)[min(2, int((u + 1) * 1.5))]  # red bands
    for side in (-1, 1):  # propellers
        x = 26 + side * 18
        for dx in range(-5, 6):
            if (dx + frame * 2) % 4 < 2:
                rows[47][x + dx] = 8
    for y in range(50, 60):  # the gondola's windows
        for dx in range(-3, 4):
            rows[y][26 + dx] = 1 if y in (50, 59) or abs(dx) == 3 else 14 if (y // 2 + frame) % 2 else 13
    return rows


def turret(frame):
    """A gun dome on a round base with bolts; its eye opens and closes."""
    rows = canvas(30, 30)
    ball(rows, 15, 15, 13.5, 13.5, 2, 6)
    outline(rows)
    for k in range(8):
        x, y = int(15 + 11 * math.cos(k * math.pi / 4 + 0.39)), int(15 + 11 * math.sin(k * math.pi / 4 + 0.39))
        rows[y][x] = 8
        rows[y][x - 1] = 2
    dome = canvas(30, 30)
    ball(dome, 15, 15, 8.5, 8.5, 4, 9)
    outline(dome)
    for y in range(30):
        for x in range(30):
            rows[y][x] = dome[y][x] or rows[y][x]
    r = (1.6, 2.4, 3.2, 2.4)[frame]
    for y in range(30):
        for x in range(30):
            d = math.hypot(x + 0.5 - 15, y + 0.5 - 15)
            if d < r + 1.6:
                rows[y][x] = 10 if d > r else 12 if d > r - 1 else 14
    return rows


def barrel():
    """The gun of a dome at the picture's middle, pointing to the right."""
    rows = canvas(30, 30)
    for x in range(18, 29):
        for y in range(12, 18):
            rows[y][x] = 10 if x > 26 else (9, 8, 7, 6, 4, 3)[y - 12]
    outline(rows)
    return rows


def sheet(*strips):
    """Strips of frames, one below the other."""
    w = max(sum(len(f[0]) for f in strip) for strip in strips)
    rows = []
    for strip in strips:
        for y in range(len(strip[0])):
            row = [p for f in strip for p in f[y]]
            rows.append(row + [0] * (w - len(row)))
    return rows


# ---- files ----

def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write_png(path, rows, colours):
    """A picture whose pixels are entries of `colours`; of a bank, 0 is transparent."""
    used = b"".join(bytes.fromhex(c) for c in colours)
    raw = b"".join(b"\0" + bytes(row) for row in rows)
    clear = chunk(b"tRNS", b"\0") if len(colours) == 16 else b""
    with open(path, "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n" +
                chunk(b"IHDR", struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 3, 0, 0, 0)) +
                chunk(b"PLTE", used) + clear + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b""))


def write_map(path, cells):
    with open(path, "w") as f:
        f.writelines(",".join(str(c) for c in row) + "\n" for row in cells)


def write_tiles(out, name, rows, columns=None):
    """The picture's tiles and the map that shows it. columns: the map's column of each column of tiles."""
    cols, lines = len(rows[0]) // SIDE, len(rows) // SIDE
    columns = columns or list(range(cols))
    cells = [[0] * (max(columns) + 1) for _ in range(lines)]
    for j in range(lines):
        for i in range(cols):
            tile = [rows[j * SIDE + y][i * SIDE + x] for y in range(SIDE) for x in range(SIDE)]
            cells[j][columns[i]] = j * cols + i + 1 if any(tile) else 0
    write_map(os.path.join(out, "maps", name + ".csv"), cells)


def main(out):
    art = os.path.join(out, "art")
    colours = {bank: text.split() for bank, text in BANKS.items()}
    pictures = {"sea": (sea(256, 512), 13), "clouds": (clouds(256, 512), 14), "cliffs": (cliffs(64, 512), 15),
                "foes": (sheet([drone(i) for i in range(4)], [airship(i) for i in range(2)],
                               [turret(i) for i in range(4)] + [barrel()]), 11)}
    for name, (rows, bank) in pictures.items():
        write_png(os.path.join(art, name + ".png"), rows, colours[bank])
    unused = ["04060e"] * 16
    entries = [c for bank in range(16) for c in colours.get(bank, unused)]
    write_png(os.path.join(art, "palette.png"), [list(range(16 * y, 16 * y + 16)) for y in range(16)], entries)
    write_tiles(out, "sea", pictures["sea"][0])
    write_tiles(out, "clouds", pictures["clouds"][0])
    write_tiles(out, "cliffs", pictures["cliffs"][0], [0, 1, 2, 3, 26, 27, 28, 29])


if __name__ == "__main__":
    main(sys.argv[1])

"""Compares two PNG pictures, pixel by pixel: png.py EXPECTED GOT DIFFERENCE

Exit code 0: the same size and colours. Else it says where they differ and writes the picture DIFFERENCE: what is the
same dark and grey, what differs bright. Reads what curtain writes: 8 bits a sample, not interlaced."""
import struct
import sys
import zlib

CHANNELS = {0: 1, 2: 3, 3: 1, 6: 4}


def chunks(data):
    at = 8
    while at + 12 <= len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        yield kind, data[at + 8:at + 8 + size]
        at += 12 + size


def unfilter(raw, h, pitch, bpp):
    """The lines of the picture, the five filters of PNG undone."""
    lines, above = [], bytearray(pitch)
    for y in range(h):
        kind, line = raw[y * (pitch + 1)], bytearray(raw[y * (pitch + 1) + 1:(y + 1) * (pitch + 1)])
        for x in range(pitch if kind else 0):
            a, b, c = (line[x - bpp], above[x], above[x - bpp]) if x >= bpp else (0, above[x], 0)
            if kind == 4:
                p = a + b - c
                order = sorted((abs(p - v), i) for i, v in enumerate((a, b, c)))
                guess = (a, b, c)[order[0][1]]
            else:
                guess = (a, b, (a + b) // 2)[kind - 1]
            line[x] = (line[x] + guess) & 255
        lines.append(line)
        above = line
    return lines


def read(path):
    """(width, height, [bytes of r g b a line])"""
    with open(path, "rb") as f:
        data = f.read()
    packed, palette = b"", b""
    for kind, body in chunks(data):
        if kind == b"IHDR":
            w, h, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", body)
        elif kind == b"PLTE":
            palette = body
        elif kind == b"IDAT":
            packed += body
    if depth != 8 or interlaced:
        raise ValueError(path + ": not 8 bits a sample, or interlaced")
    n = CHANNELS[colour]
    lines = unfilter(zlib.decompress(packed), h, w * n, n)
    if colour == 3:
        table = [palette[3 * i:3 * i + 3] for i in range(256)]
        lines = [b"".join([table[i] for i in line]) for line in lines]
    elif colour == 0:
        lines = [bytes(v for v in line for _ in range(3)) for line in lines]
    elif colour == 6:
        lines = [bytes(v for i, v in enumerate(line) if i % 4 < 3) for line in lines]
    return w, h, [bytes(line) for line in lines]


def write(path, w, h, lines):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    head = struct.pack(">IIBBBBB", w, h, 8, 2, 0, 0, 0)
    body = zlib.compress(b"".join(b"\0" + line for line in lines), 9)
    with open(path, "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", body) + chunk(b"IEND", b""))


def compare(expected, got, difference):
    w, h, want = read(expected)
    w2, h2, have = read(got)
    if (w, h) != (w2, h2):
        print("%dx%d, expected %dx%d" % (w2, h2, w, h))
        return 1
    count, first, out = 0, None, []
    for y in range(h):
        row = bytearray(v // 4 for v in want[y])
        if want[y] != have[y]:
            for x in range(0, 3 * w, 3):
                if want[y][x:x + 3] != have[y][x:x + 3]:
                    count += 1
                    first = first or "pixel %d, %d is %s, expected %s" % (
                        x // 3, y, have[y][x:x + 3].hex(), want[y][x:x + 3].hex())
                    row[x:x + 3] = b"\xff\x40\xff"
        out.append(bytes(row))
    if count:
        print("%d of %d pixels differ; %s" % (count, w * h, first))
        write(difference, w, h, out)
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(compare(*sys.argv[1:4]))

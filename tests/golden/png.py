"""Compares two PNG pictures, pixel by pixel: png.py EXPECTED GOT DIFFERENCE

Exit code 0: the same size and colours. Else it says where they differ and writes the picture DIFFERENCE: what is the
same dark and grey, what differs bright. ImageMagick reads and writes the files."""
import subprocess
import sys


def read(path):
    """(width, height, [bytes of r g b a line])"""
    command = ["convert", path, "-alpha", "off", "-depth", "8", "ppm:-"]
    head, size, _, pixels = subprocess.run(command, check=True, capture_output=True).stdout.split(b"\n", 3)
    assert head == b"P6", path
    w, h = map(int, size.split())
    return w, h, [pixels[3 * w * y:3 * w * (y + 1)] for y in range(h)]


def write(path, w, h, lines, kind="png24"):
    """kind: png24, or png for the smallest file"""
    picture = b"P6\n%d %d\n255\n" % (w, h) + b"".join(lines)
    subprocess.run(["convert", "ppm:-", "-strip", "-define", "png:compression-level=9", kind + ":" + path], check=True,
                   input=picture)


def compare(expected, got, difference):
    w, h, want = read(expected)
    w2, h2, have = read(got)
    if (w, h) != (w2, h2):
        print("%dx%d, expected %dx%d" % (w2, h2, w, h))
        return 1
    count, first, out = 0, None, []
    for y in range(h):
        row = bytearray(v // 4 for v in want[y])
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

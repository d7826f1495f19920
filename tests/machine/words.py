"""words.py FILE.ppm TEXT...: exit 0 when each text stands on the picture in the program's own font
(src/player/overlay/canvas.c), light on its dark paper; else the first that does not is printed."""
import os
import re
import sys

CANVAS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "src", "player", "overlay", "canvas.c")
PAPER = bytes((0x10, 0x18, 0x28))


def font():
    table = re.search(r"glyphs\[95\] = \{(.*?)\};", open(CANVAS).read(), re.S).group(1)
    rows = [int(g, 8) for g in re.findall(r"\b0[0-7]{6}\b", table)]
    assert len(rows) == 95
    return rows


def shape(text, glyphs):
    """Its pixels, row by row, gaps between letters included."""
    rows = []
    for y in range(6):
        row = []
        for c in text:
            bits = glyphs[ord(c) - 32] >> (3 * (5 - y)) & 7
            row += [bool(bits & 4), bool(bits & 2), bool(bits & 1), False]
        rows.append(row[:-1])
    return rows


def seen(pixels, w, h, rows):
    width = len(rows[0])
    lines = ["".join("1" if inked else "0" for inked in row) for row in rows]
    picture = ["".join(pixels[y * w:(y + 1) * w]) for y in range(h)]
    for y in range(h - 5):
        x = picture[y].find(lines[0])
        while x >= 0:
            if all(picture[y + i][x:x + width] == lines[i] for i in range(6)):
                return True
            x = picture[y].find(lines[0], x + 1)
    return False


def main():
    data = open(sys.argv[1], "rb").read()
    head = re.match(rb"P6\s+(?:#.*\n)*(\d+)\s+(\d+)\s+255\s", data)
    w, h, rest = int(head.group(1)), int(head.group(2)), data[head.end():]
    pixels = ["0" if rest[3 * i:3 * i + 3] == PAPER else "1" for i in range(w * h)]
    glyphs = font()
    for text in sys.argv[2:]:
        if not seen(pixels, w, h, shape(text, glyphs)):
            print(text)
            return 1
    return 0


sys.exit(main())

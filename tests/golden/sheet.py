"""A contact sheet: sheet.py SHEET.png DIR NAMES FAILED [--update]

NAMES are the names of the PPM pictures in DIR, one per line, all of one size. The sheet shows them in rows of ten.
Without --update, the sheet is compared with the pictures: prints the names of those that differ and writes the
expected and the actual picture and their difference to FAILED. Exit code 1: some differ."""
import os
import sys
import png

COLUMNS = 10


def read_ppm(path):
    with open(path, "rb") as file:
        (magic, w, h, _), pixels = file.readline().split(), file.read()
    assert magic == b"P6", path
    w, h = int(w), int(h)
    return w, h, [pixels[3 * w * y:3 * w * (y + 1)] for y in range(h)]


def compose(pictures):
    w, h, _ = pictures[0]
    rows = []
    for first in range(0, len(pictures), COLUMNS):
        row = pictures[first:first + COLUMNS]
        rest = bytes(3 * w * (COLUMNS - len(row)))
        rows += [b"".join(lines[y] for _, _, lines in row) + rest for y in range(h)]
    return COLUMNS * w, len(rows), rows


def compare(sheet, names, pictures, failed):
    have_w, have_h, lines = png.read(sheet)
    w, h, _ = pictures[0]
    if (have_w, have_h) != compose(pictures)[:2]:
        print("the sheet is %dx%d, expected %dx%d" % ((have_w, have_h) + compose(pictures)[:2]))
        return 1
    differ = []
    for i, (name, got) in enumerate(zip(names, pictures)):
        x, y = i % COLUMNS * w, i // COLUMNS * h
        want = [line[3 * x:3 * (x + w)] for line in lines[y:y + h]]
        if want == got[2]:
            continue
        differ.append(name)
        stem = os.path.join(failed, os.path.basename(sheet)[:-4] + "-" + name)
        os.makedirs(failed, exist_ok=True)
        png.write(stem + ".expected.png", w, h, want)
        png.write(stem + ".got.png", w, h, got[2])
        png.compare(stem + ".expected.png", stem + ".got.png", stem + ".difference.png")
    if differ:
        print("%d of %d pictures differ: %s" % (len(differ), len(names), " ".join(differ)))
        print("see %s" % os.path.join(failed, os.path.basename(sheet)[:-4] + "-*.png"))
    return 1 if differ else 0


def main(sheet, directory, names, failed, update=None):
    names = open(names).read().split()
    pictures = [read_ppm(os.path.join(directory, name + ".ppm")) for name in names]
    if update:
        return png.write(sheet, *compose(pictures), kind="png")
    return compare(sheet, names, pictures, failed)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

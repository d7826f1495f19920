#!/usr/bin/env python3
"""moth.py DIR: draws examples/moth/art/moth.ase, a sprite of layers, tags and slices, and the colours of its bank.

The moth is two pairs of wings, each an ellipse with rings and an eye, and a body; the wings close and open. Editors
open the file as any other: it is here to be changed."""
import math
import os
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests", "cli"))
from ase_file import Ase, Cel  # noqa: E402

W, H, MIDDLE = 32, 28, 15.5
COLOURS = ["1a1026", "3a1c4a", "5c2a6e", "8a3f8f", "b95fa0", "e08fb0", "f7c9c4", "fff3e0",  # wings, from dark to light
           "6b3a1e", "a8652c", "e0a54a", "ffe08a", "1d3d5c", "3f8fb0", "a8f0e8"]            # body; eyes on the wings
RIM, DARK, DEEP, MID, ROSE, PALE, LIGHT, WHITE, BODY, FUR, GOLD, GLOW, POND, LAKE, SHINE = range(1, 16)


def ellipse(x, y, cx, cy, rx, ry, turn):
    """How far out of the middle a point is: 1 is the rim."""
    c, s = math.cos(turn), math.sin(turn)
    dx, dy = x - cx, y - cy
    return math.hypot((dx * c + dy * s) / rx, (dy * c - dx * s) / ry)


def wing(d, bands):
    return next((shade for limit, shade in bands if d < limit), 0)


def wings(opened):
    """One frame of the wings; opened: 1 wide, 0 shut."""
    rows = []
    for y in range(H):
        row = []
        for x in range(W):
            out = abs(x - MIDDLE) / (0.35 + 0.65 * opened)  # drawn as if open, then folded
            lower = ellipse(out, y, 6.5, 18.5, 6.6, 5.4, 0.7)
            upper = ellipse(out, y, 8.2, 9.0, 8.6, 6.0, -0.55)
            shade = wing(lower, [(.22, GLOW), (.36, GOLD), (.5, BODY), (.72, ROSE), (.86, MID), (1, RIM)])
            on_top = wing(upper, [(.16, SHINE), (.27, LAKE), (.38, POND), (.48, LIGHT), (.62, PALE), (.76, ROSE),
                                  (.88, DEEP), (1, RIM)])
            row.append(on_top or shade)
        rows.append(row)
    return rows


def body(glow):
    rows = [[0] * W for _ in range(H)]
    for y in range(7, 24):
        wide = 2.4 if y < 12 else 2.9 - (y - 12) * 0.17
        for x in range(W):
            off = abs(x - MIDDLE)
            if off < wide:
                stripe = y > 13 and y % 3 == 0
                rows[y][x] = RIM if off > wide - 0.9 else BODY if stripe else GLOW if glow else GOLD if off < 1 else FUR
    for i in range(6):  # feelers
        for side in (-1, 1):
            rows[6 - i][int(MIDDLE + 0.5 + side * (1.6 + i * 0.75) - (side < 0))] = GLOW if i == 5 else FUR
    for side in (-1, 1):  # eyes
        rows[8][int(MIDDLE + 0.5 + side * 1.2)] = WHITE
    return rows


def main(out):
    palette = [(0, 0, 0)] + [tuple(bytes.fromhex(c)) for c in COLOURS]
    ase = Ase(W, H, mode="indexed", palette=palette)
    ase.layer("wings")
    ase.layer("body")
    ase.layer("notes", visible=False)
    for i, opened in enumerate((1, 0.72, 0.35, 0.72)):
        ase.frame(Cel(0, wings(opened)), Cel(1, body(False) if i == 0 else None, link=0), ms=100)
    for i in (0, 1):
        ase.frame(Cel(0, wings(0.5 + i * 0.4)), Cel(1, body(True)), ms=50)
    ase.tag("fly", 0, 3)
    ase.tag("hurt", 4, 5)
    ase.slice("box", (0, 8, 6, 16, 17, 8, 8), pivot=True)
    with open(os.path.join(out, "moth.ase"), "wb") as f:
        f.write(ase.whole())
    with open(os.path.join(out, "moth.hex"), "w") as f:
        f.write("".join(c + "\n" for c in COLOURS))


main(sys.argv[1])

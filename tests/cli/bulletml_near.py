"""Compares two traces of bullets (curtain hash --trace bullets), of a document and of its Lua: every bullet of the
first that is seen has one of the second within so many px, in each frame that both have, but for one in fifty (what
comes and goes a frame sooner has no other there); and they are about as many.

    bulletml_near.py DOCUMENT.txt LUA.txt PX"""
import math
import re
import sys

ONE = re.compile(r"(\d+) bullets \d+ \S+ x=\S+\((-?\d+)\) y=\S+\((-?\d+)\)")


def read(name):
    frames = {}
    with open(name, encoding="utf-8") as lines:
        for line in lines:
            found = ONE.match(line)
            if found:
                frame, x, y = (int(v) for v in found.groups())
                frames.setdefault(frame, []).append((x / 65536, y / 65536))
    return frames


def main():
    want, got, most = read(sys.argv[1]), read(sys.argv[2]), float(sys.argv[3])
    n, far, counts = 0, 0, [0, 0]
    for frame in want:
        others = got.get(frame, [])
        counts[0] += len(want[frame])
        counts[1] += len(others)
        for x, y in want[frame]:
            if 0 <= x <= 240 and 0 <= y <= 320:
                far += min((math.dist((x, y), o) for o in others), default=999.0) > most
                n += 1
    if n < 100 or far > n / 50 or abs(counts[0] - counts[1]) > counts[0] / 20:
        print(f"{n} bullets seen, {counts[0]} and {counts[1]} in all, {far} too far off")
        sys.exit(1)


main()

#!/usr/bin/env python3
"""Writes a demo in format 2, which today's programs only read: `demo_old.py NEW OLD`. What format 2 has no room for
(the rest of a practice start, prints but script's, moments, parts after the 32nd) is left out."""
import struct
import sys
import zlib
from demo_read import read


def text(s):
    return struct.pack("<B", len(s)) + s.encode("ascii")


def plain(data):
    """nvram without runs."""
    return b"".join(struct.pack("<B", len(data[i:i + 128]) - 1) + data[i:i + 128] for i in range(0, len(data), 128))


def header(d):
    out = struct.pack("<IQQ", d["core"], d["game"], d["rom"]) + text(d["id"]) + text(d["lua"])
    out += struct.pack("<Q16ii", d["seed"], *d["dip"], d["difficulty"]) + text(d["mark"])
    out += struct.pack("<B", len(d["parts"])) + b"".join(map(text, d["parts"]))
    return out + struct.pack("<I", len(d["nvram"])) + plain(d["nvram"])


def second(d, first, n, row):
    script = d["parts"].index("script")
    runs = []
    for pads in d["pads"][first:first + n]:
        if runs and runs[-1][1:] == pads:
            runs[-1] = (runs[-1][0] + 1, *pads)
        else:
            runs.append((1, *pads))
    out = struct.pack("<IBBBB", first, n, len(runs), row is not None, 0)
    out += b"".join(struct.pack("<HHH", *run) for run in runs)
    out += b"".join(struct.pack("<H", d["prints"][f][script]) for f in range(first, first + n - 1))
    return out + struct.pack("<%dQ" % len(row or []), *(row or []))


def records(d):
    yield b"H", header(d)
    if d["flags"]:
        yield b"F", struct.pack("<I", d["flags"])
    done = 0
    for i, row in enumerate(d["rows"]):
        frame = min(60 * i, len(d["pads"]))
        yield b"S", second(d, done, frame - done, row)
        done = frame
    if done < len(d["pads"]):
        yield b"S", second(d, done, len(d["pads"]) - done, None)
    if d["end"] is not None:
        yield b"E", struct.pack("<II", len(d["pads"]), d["end"])


MOST = 32  # parts that format 2 has room for


demo, crc, out = read(open(sys.argv[1], "rb").read()), 0, b"CDEM" + struct.pack("<I", 2)
demo["parts"], demo["rows"] = demo["parts"][:MOST], [row[:MOST] for row in demo["rows"]]
for kind, payload in records(demo):
    record = kind + b"\0\0\0" + struct.pack("<I", len(payload)) + payload
    crc = zlib.crc32(record, crc)
    out += record + struct.pack("<I", crc)
open(sys.argv[2], "wb").write(out)

#!/usr/bin/env python3
"""Reads a demo as docs/reference/demo-format.md describes it, and nothing else of Curtain; prints all that is in it, a
line each.

    demo_read.py DEMO            or, as a module: demo = read(bytes)

Refuses (exit 2) what the page says a reader must refuse, as far as one file alone can show it."""
import re
import struct
import sys
import zlib

CODES = 54  # bits 10 to 15 of a pad: 0 to 53
MOST = {b"H": 1122304, b"S": 8904, b"M": 42, b"F": 4, b"E": 520}  # bytes of a payload
KINDS = ["stage", "point", "wave", "boss", "phase", "death", "clear", "won", "lost", "start", "ship", "register",
         "listed", "game", "over", "row", "difficulty", "mission"]


class Bad(Exception):
    pass


def need(holds, why):
    if not holds:
        raise Bad(why)


class Bytes:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, n):
        need(self.at + n <= len(self.data), "too short")
        self.at += n
        return self.data[self.at - n:self.at]

    def num(self, code):
        return struct.unpack("<" + code, self.take(struct.calcsize(code)))[0]

    def text(self, most):
        raw = self.take(self.num("B"))
        need(len(raw) <= most and all(32 <= c <= 126 for c in raw), "a string")
        return raw.decode("ascii")


def nvram(packed, size, most):
    out, b = bytearray(), Bytes(packed)
    while b.at < len(packed):
        c = b.num("B")
        out += b.take(c + 1) if c < 128 else b.take(1) * (c - 125)
    need(len(out) == size <= most, "nvram")
    return bytes(out)


def header(b, form):
    d = {"format": form, "core": b.num("I"), "game": b.num("Q"), "rom": b.num("Q"), "id": b.text(31), "lua": b.text(15)}
    d.update(seed=b.num("Q"), dip=[b.num("i") for _ in range(16)], difficulty=b.num("i"), mark=b.text(63))
    need(-1 <= d["difficulty"] < 8 and re.fullmatch("[a-z0-9_]+", d["id"]), "difficulty or id")
    d.update(lives=0, invincible=0, registers=[])
    if form > 2:
        d["lives"], d["invincible"], n = b.num("i"), b.num("B"), b.num("B")
        need(0 <= d["lives"] <= 99 and d["invincible"] < 2 and n <= 16, "practice")
        d["registers"] = [(b.text(31), b.num("i")) for _ in range(n)]
    d["lang"] = b.text(15) if form > 3 else ""
    flags = b.num("B") if form > 4 else 0
    need(flags < 4, "header flags")
    d["sparse"], d["large_hud"] = flags & 1, flags >> 1
    d["parts"] = [b.text(15) for _ in range(b.num("B"))]
    need(1 <= len(d["parts"]) <= (64 if form > 3 else 32) and "script" in d["parts"], "parts")
    size = b.num("I")
    d["nvram"] = nvram(b.take(len(b.data) - b.at), size, 1 << 20 if form > 3 else 32768)
    d.update(pads=[], prints=[], rows=[], whole=[], moments=[], flags=0, end=None, open=True)
    return d


def second(b, d):
    first, n, runs, hashed, zero = b.num("I"), b.num("B"), b.num("B"), b.num("B"), b.num("B")
    start = first == 0 and n == 0 and not d["rows"]
    need(d["open"] and first == len(d["pads"]) and hashed < 3 and zero == 0, "order")
    need(hashed if start else 1 <= n <= 60 and d["rows"], "number of frames")
    if d["sparse"]:
        sparse(b, d, first, n, runs, hashed)
    else:
        need(hashed < 2, "order")
        dense(b, d, first, n, runs, hashed)
    d["open"] = bool(hashed) and (start or n == 60)
    d["hashed"] = bool(hashed)


def sparse(b, d, first, n, runs, hashed):
    """Runs of pads that say what is new, and prints of the last frame alone; each minute's row is whole."""
    pads = list(d["pads"][-1]) if d["pads"] else [0, 0]
    for _ in range(runs):
        head = b.num("B")
        for player in range(2):
            if head & 64 << player:
                pads[player] = b.num("H")
        need(max(pads) < CODES << 10, "pads")
        d["pads"] += [tuple(pads)] * ((head & 63) + 1)
    need(len(d["pads"]) == first + n, "runs")
    whole = n < 60 or (first + n) % 3600 == 0
    need(not hashed or hashed == (1 if whole else 2), "order")
    if hashed == 2:
        before, mask = d["rows"][-1], int.from_bytes(b.take((len(d["parts"]) + 7) // 8), "little")
        need(mask >> len(d["parts"]) == 0, "mask")
        d["rows"].append([b.num("H") if mask >> i & 1 else h & 0xffff for i, h in enumerate(before)])
    elif hashed:
        d["rows"].append([b.num("Q") for _ in d["parts"]])
    if hashed:
        d["whole"].append(hashed == 1)


def dense(b, d, first, n, runs, hashed):
    for _ in range(runs):
        run, one, two = b.num("H"), b.num("H"), b.num("H")
        need(run >= 1 and max(one, two) < CODES << 10, "pads")
        d["pads"] += [(one, two)] * run
    need(len(d["pads"]) == first + n, "runs")
    for _ in range(n - 1):
        before = d["prints"][-1] if d["prints"] else [h & 0xffff for h in d["rows"][0]]
        if d["format"] > 2:
            mask = int.from_bytes(b.take((len(d["parts"]) + 7) // 8 if d["format"] > 3 else 4), "little")
        else:
            mask = 1 << d["parts"].index("script")
        need(mask >> len(d["parts"]) == 0, "mask")
        d["prints"].append([b.num("H") if mask >> i & 1 else p for i, p in enumerate(before)])
    if hashed:
        d["rows"].append([b.num("Q") for _ in d["parts"]])
        d["whole"].append(True)
        d["prints"] += [[h & 0xffff for h in d["rows"][-1]]] if n else []


def moment(b, d):
    frame, kind, name = b.num("I"), b.num("B"), b.text(31)
    before = d["moments"][-1][0] if d["moments"] else 0
    need(d["format"] > 2 and d["rows"] and before <= frame <= len(d["pads"]), "moment")
    need(kind < (len(KINDS) if d["format"] > 3 else 13), "moment")
    value = b.num("i") if d["format"] > 3 and b.at < len(b.data) else None
    need(value != 0, "moment")
    d["moments"].append((frame, KINDS[kind], name, value or 0))


def end(b, d):
    frames, fault = b.num("I"), b.num("I")
    need(frames == len(d["pads"]) and fault <= 4, "end")
    need(d["rows"] and d["hashed"] if not fault else not d["hashed"] if frames else not d["rows"], "end and track")
    if d["sparse"] and not fault and not d["whole"][-1]:
        row = [b.num("Q") for _ in d["parts"]]
        need([h & 0xffff for h in row] == d["rows"][-1], "the last row")
        d["rows"][-1], d["whole"][-1] = row, True
    d["end"] = fault


def read(data):
    need(data[:4] == b"CDEM" and len(data) >= 8, "not a demo")
    form, = struct.unpack("<I", data[4:8])
    need(form in (2, 3, 4, 5), "format")
    d, at, crc = None, 8, 0
    while len(data) - at >= 8 and not (d and d["end"] is not None):
        kind, n = data[at:at + 4], struct.unpack("<I", data[at + 4:at + 8])[0]
        need(kind[1:] == b"\0\0\0" and n <= MOST.get(kind[:1], -1), "kind or size")
        if len(data) - at < 12 + n:
            break  # cut short
        crc = zlib.crc32(data[at:at + 8 + n], crc)
        need(struct.unpack("<I", data[at + 8 + n:at + 12 + n])[0] == crc, "CRC")
        b, letter = Bytes(data[at + 8:at + 8 + n]), kind[:1]
        need((d is None) == (letter == b"H"), "header")
        if letter == b"H":
            d = header(b, form)
        elif letter == b"F":
            d["flags"] |= b.num("I")
            need(d["flags"] < 16, "flags")
        else:
            {b"S": second, b"M": moment, b"E": end}[letter](b, d)
        need(b.at == n, "size")
        at += 12 + n
    need(d, "truncated header")
    need(d["end"] is None or at == len(data), "bytes after its end")
    return d


def lines(d):
    for key in "format core game rom id lua seed difficulty mark lives invincible lang sparse flags".split():
        yield "%s %s" % (key, "%016x" % d[key] if key in ("game", "rom") else d[key])
    yield "dip " + " ".join(map(str, d["dip"]))
    yield "registers " + " ".join("%s=%d" % r for r in d["registers"])
    yield "nvram %d %08x" % (len(d["nvram"]), zlib.crc32(d["nvram"]))
    for i, row in enumerate(d["rows"]):
        form = "%s=%016x" if d["whole"][i] else "%s=%04x"
        yield "row %d " % min(60 * i, len(d["pads"])) + " ".join(form % r for r in zip(d["parts"], row))
    for f, pads in enumerate(d["pads"]):
        yield "pads %d %04x %04x" % (f + 1, *pads)
    for f, prints in enumerate(d["prints"]):
        yield "prints %d " % (f + 1) + " ".join("%s=%04x" % p for p in zip(d["parts"], prints))
    for m in d["moments"]:
        yield "moment %d %s %s" % m[:3] + (" = %d" % m[3] if m[3] else "")
    yield "cut short" if d["end"] is None else "end %d fault %d" % (len(d["pads"]), d["end"])


if __name__ == "__main__":
    try:
        print("\n".join(lines(read(open(sys.argv[1], "rb").read()))))
    except Bad as why:
        print("%s: %s" % (sys.argv[1], why), file=sys.stderr)
        sys.exit(2)

#!/usr/bin/env python3
"""Prints a demo of format 4 or 5 byte by byte with what each byte is, as docs/reference/demo-format.md has it:
`demo_dump.py DEMO`."""
import struct
import sys

data = open(sys.argv[1], "rb").read()
at = 0


def show(n, text, quiet=False):
    """The next n bytes and their meaning; 12 bytes a line, the middle of many left out."""
    global at
    if quiet:
        at += n
        return
    for i in range(0, n, 12):
        if n > 36 and 12 <= i < n - 12:
            if i == 12:
                print("      ...")
            continue
        print("%04x  %-36s%s" % (at + i, data[at + i:at + min(i + 12, n)].hex(" "), text if i == 0 else ""))
    at += n


def num(code, text, quiet=False):
    v = struct.unpack_from("<" + code, data, at)[0]
    show(struct.calcsize(code), text.replace("%", str(v)).replace("$", "%x" % v), quiet)
    return v


def string(text, quiet=False):
    n = data[at]
    show(1 + n, '%s "%s"' % (text, data[at + 1:at + 1 + n].decode()), quiet)


def part(i):
    """Is it of the middle, like those before and after? The first of these shows as dots."""
    if i == 1:
        print("      ...")
    return 1 <= i < parts - 1


def header(end):
    num("I", "core version %")
    num("Q", "game hash")
    num("Q", "ROM hash")
    string("game")
    string("Lua")
    num("Q", "seed %")
    show(64, "16 DIP switches")
    num("i", "difficulty %")
    string("practice start")
    num("i", "lives %: as the ship has")
    num("B", "invincible: %")
    for _ in range(num("B", "% registers")):
        string("register")
        num("i", "= %")
    string("language")
    global parts, sparse
    sparse = form > 4 and num("B", "sparse: %")
    parts = num("B", "% parts")
    for i in range(parts):
        string("part %d," % i, part(i))
    num("I", "% bytes of nvram")
    show(end - at, "run-length coded")


def second(end):
    first, n = num("I", "after frame %"), num("B", "% frames")
    runs, hashed = num("B", "% runs of pads"), num("B", "a row follows: %")
    num("B", "zero")
    if sparse:
        short(end, runs, hashed)
        return
    for _ in range(runs):
        num("H", "% frames with")
        num("H", "   player 1: $")
        num("H", "   player 2: $")
    for f in range(first + 1, first + n):
        mask, quiet = int.from_bytes(data[at:at + (parts + 7) // 8], "little"), f > first + 1
        show((parts + 7) // 8, "frame %d: checksums that changed, mask %x" % (f, mask), quiet)
        for i in range(bin(mask).count("1")):
            num("H", "   checksum $", quiet)
        if f == first + 2:
            print("      ...")
    for i in range((end - at) // 8 if hashed else 0):
        num("Q", "hash of part %d" % i, part(i))


def short(end, runs, hashed):
    for _ in range(runs):
        head = data[at]
        show(1, "%d frames" % ((head & 63) + 1) + (" with" if head > 63 else ""))
        for player in range(2):
            if head & 64 << player:
                num("H", "   player %d: $" % (player + 1))
    if hashed == 2:
        mask = int.from_bytes(data[at:at + (parts + 7) // 8], "little")
        show((parts + 7) // 8, "checksums that changed, mask %x" % mask)
        for i in range(bin(mask).count("1")):
            num("H", "   checksum $", i > 3)
        print("      ...")
    for i in range((end - at) // 8 if hashed == 1 else 0):
        num("Q", "hash of part %d" % i, part(i))


def moment(end):
    num("I", "in frame %")
    num("B", "kind %")
    string("name")
    if at < end:
        num("i", "value %")


show(4, "CDEM")
form, sparse = num("I", "format %"), 0
while at < len(data):
    print()
    kind = data[at:at + 1]
    show(4, "kind " + kind.decode())
    size = num("I", "size %")
    {b"H": header, b"S": second, b"M": moment, b"F": lambda end: num("I", "flags $"),
     b"E": lambda end: (num("I", "% frames"), num("I", "fault %: none"))}[kind](at + size)
    num("I", "CRC-32 $")

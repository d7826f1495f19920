#!/usr/bin/env python3
"""pe_make.py - writes a small file of the form of a Windows program, as the linker of `make windows` writes one.

    pe_make.py OUT CORE         CORE: the core version in its mark
"""
import struct
import sys

sys.dont_write_bytecode = True
TEXT, RSRC, RELOC = 0x1000, 0x2000, 0x3000  # addresses


def resources(base, items):
    """The tree of (type, number, data), sorted, one language each, and the data behind it."""
    types = sorted({t for t, _, _ in items})
    count = {t: sum(i[0] == t for i in items) for t in types}
    numbers = 16 + 8 * len(types)
    languages = numbers + sum(16 + 8 * count[t] for t in types)
    entries = languages + 24 * len(items)
    start = entries + 16 * len(items)

    def directory(n):
        return struct.pack("<IIHHHH", 0, 0, 0, 0, 0, n)

    out, at = directory(len(types)), numbers
    for t in types:
        out += struct.pack("<II", t, at | 1 << 31)
        at += 16 + 8 * count[t]
    for t in types:
        out += directory(count[t])
        for i, item in enumerate(items):
            if item[0] == t:
                out += struct.pack("<II", item[1], languages + 24 * i | 1 << 31)
    for i in range(len(items)):
        out += directory(1) + struct.pack("<II", 0x409, entries + 16 * i)
    data = b""
    for _, _, bytes_ in items:
        out += struct.pack("<IIII", base + start + len(data), len(bytes_), 0, 0)
        data += bytes_ + bytes(-len(bytes_) % 8)
    return out + data


def main(path, core):
    mark = b"<a game may stand behind curtain" + struct.pack("<IIQQII", 1, 0, 0, 0, 0, int(core))
    tree = resources(RSRC, [(3, 1, b"old icon" * 9), (14, 1, struct.pack("<HHHBBBBHHIH", 0, 1, 1, 16, 16, 0, 0, 1, 32,
                     72, 1)), (16, 1, b"old version" * 5), (24, 1, b"<assembly>a manifest</assembly>")])
    parts = [(b".text", TEXT, bytes(64) + mark + b"code" * 20, 0x60000020), (b".rsrc", RSRC, tree, 0x40000040),
             (b".reloc", RELOC, b"moves" * 4, 0x42000040)]
    headers, at, table, body = 0x400, 0x400, b"", b""
    for name, address, data, flags in parts:
        raw = data + bytes(-len(data) % 512)
        table += struct.pack("<8sIIIIIIHHI", name, len(data), address, len(raw), at, 0, 0, 0, 0, flags)
        body += raw
        at += len(raw)
    directories = [(0, 0)] * 16
    directories[2] = (RSRC, len(tree))
    directories[4] = (at, 16)  # a signature, which no copy can have
    optional = struct.pack("<HBBIIIIIQIIHHHHHHIIIIHHQQQQII", 0x20b, 2, 40, 512, 1024, 0, TEXT, TEXT, 0x140000000, 4096,
                           512, 4, 0, 0, 0, 5, 2, 0, 0x4000, headers, 0x1234, 3, 0x160, 0x800000, 0x1000, 0x100000,
                           0x1000, 0, 16)
    optional += b"".join(struct.pack("<II", *d) for d in directories)
    head = b"MZ" + bytes(58) + struct.pack("<I", 128) + bytes(64)
    head += b"PE\0\0" + struct.pack("<HHIIIHH", 0x8664, len(parts), 0x12345678, at + 16, 3, len(optional), 0x22e)
    head += optional + table
    with open(path, "wb") as f:
        f.write(head + bytes(headers - len(head)) + body + b"signature, names")


main(*sys.argv[1:])

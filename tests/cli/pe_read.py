#!/usr/bin/env python3
"""pe_read.py - what a Windows program says of itself: sections, resources, version. Exit 1: the file is not sound.

    pe_read.py FILE             a line for each
    pe_read.py FILE TYPE ID     the bytes of a resource
    pe_read.py FILE icon        the icon as an .ico file
"""
import struct
import sys

sys.dont_write_bytecode = True


def main(path, *want):
    with open(path, "rb") as f:
        file = f.read()

    def u16(at):
        return struct.unpack_from("<H", file, at)[0]

    def u32(at):
        return struct.unpack_from("<I", file, at)[0]

    def need(what, condition):
        if not condition:
            sys.exit("%s: %s" % (path, what))

    pe = u32(60)
    need("no signature PE", file[:2] == b"MZ" and file[pe:pe + 4] == b"PE\0\0")
    optional, table = pe + 24, pe + 24 + u16(pe + 20)
    need("not for x86-64", u16(pe + 4) == 0x8664 and u16(optional) == 0x20b)
    need("the header has a time or symbols", file[pe + 8:pe + 20] == bytes(12))
    sections = [struct.unpack_from("<8sIIII", file, table + 40 * i) for i in range(u16(pe + 6))]
    need("the table of sections is larger than the headers", table + 40 * len(sections) <= u32(optional + 60))
    address, end = 0, u32(optional + 60)
    for name, size, at, raw, start in sections:
        need("section %s is not behind the one before" % name, at >= address and at % 4096 == 0)
        need("section %s overlaps in the file" % name, raw == 0 or (start >= end and start % 512 == 0))
        need("section %s runs past the end" % name, start + raw <= len(file) and raw % 512 == 0)
        address, end = at + size, max(end, start + raw)
    need("the size in memory is wrong", u32(optional + 56) == (address + 4095) // 4096 * 4096)
    need("there is a checksum", u32(optional + 64) == 0)
    need("there is a signature", u32(optional + 144) == 0)

    def offset(at):
        for _, _, start, raw, file_at in sections:
            if start <= at < start + raw:
                return file_at + at - start
        sys.exit("%s: no section has the address %x" % (path, at))

    base, found = offset(u32(optional + 128)), {}

    def walk(at, level, key):
        need("a directory has names, a time or a version", file[base + at:base + at + 14] == bytes(14))
        keys = []
        for i in range(u16(base + at + 14)):
            number, to = u32(base + at + 16 + 8 * i), u32(base + at + 20 + 8 * i)
            keys.append(number)
            if level < 2:
                need("not a directory", to >> 31)
                walk(to & 0x7fffffff, level + 1, key + (number,))
            else:
                found[key + (number,)] = file[offset(u32(base + to)):][:u32(base + to + 4)]
        need("a directory is not sorted", keys == sorted(set(keys)))

    walk(0, 0, ())
    resources = {key[:2]: data for key, data in found.items()}
    if want and want[0] == "icon":
        group, n = resources[14, 1], struct.unpack("<H", resources[14, 1][4:6])[0]
        out, bodies = group[:6], b""
        for i in range(n):
            entry = group[6 + 14 * i:20 + 14 * i]
            body = resources[3, struct.unpack("<H", entry[12:])[0]]
            need("the size of an icon is wrong", struct.unpack("<I", entry[8:12])[0] == len(body))
            out += entry[:12] + struct.pack("<I", 6 + 16 * n + len(bodies))
            bodies += body
        sys.stdout.buffer.write(out + bodies)
        return
    if want:
        sys.stdout.buffer.write(resources[int(want[0]), int(want[1])])
        return
    print("sections", " ".join(s[0].rstrip(b"\0").decode() for s in sections))
    print("resources", " ".join("%d/%d" % key for key in sorted(resources)))

    def block(data, at):  # its key, value, children, and where the next one is
        length, value, text = struct.unpack_from("<HHH", data, at)
        key = ""
        i = at + 6
        while data[i:i + 2] != b"\0\0":
            key += data[i:i + 2].decode("utf-16-le")
            i += 2
        i = (i + 2 + 3) // 4 * 4
        end = at + length
        need("a block of the version runs past the end", at + 6 <= end <= len(data))
        if text and value:
            need("%s does not end in a 0" % key, end == i + 2 * value and data[end - 2:end] == b"\0\0")
            print(key + ":", data[i:end - 2].decode("utf-16-le"))
            return end
        if key == "VS_VERSION_INFO":
            fixed = struct.unpack_from("<13I", data, i)
            need("the version has no signature", fixed[0] == 0xfeef04bd and value == 52)
            print("version", *(n >> s & 0xffff for n in fixed[2:6] for s in (16, 0)))
        if key == "Translation":
            print("translation %x" % struct.unpack_from("<I", data, i))
        i += value
        while (i + 3) // 4 * 4 < end:
            i = block(data, (i + 3) // 4 * 4)
        return end

    version = resources[16, 1]
    need("the version is longer than its blocks", block(version, 0) == len(version))


main(*sys.argv[1:])

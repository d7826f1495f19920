#!/usr/bin/env python3
"""Changes a byte of a demo and makes the checksums good again: `demo_repair.py FROM TO BYTE [VALUE]`; without a value
its lowest bit is flipped."""
import struct
import sys
import zlib


def repair(data):
    """The CRCs of all records of a bytearray, as far as their sizes make sense."""
    pos, crc = 8, 0
    while len(data) - pos >= 12:
        n = struct.unpack_from("<I", data, pos + 4)[0]
        if n > len(data) - pos - 12:
            break
        crc = zlib.crc32(data[pos:pos + 8 + n], crc)
        struct.pack_into("<I", data, pos + 8 + n, crc)
        pos += 12 + n


def main(source, target, byte, value=None):
    data, at = bytearray(open(source, "rb").read()), int(byte, 0)
    data[at] = data[at] ^ 1 if value is None else int(value, 0)
    repair(data)
    open(target, "wb").write(data)


if __name__ == "__main__":
    main(*sys.argv[1:])

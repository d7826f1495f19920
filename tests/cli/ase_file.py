"""ase_file.py - writes files of Aseprite's from its published format (docs/ase-file-specs.md there), for tests.

An Ase has layers, frames of cels, tags and slices; whole() gives the file. What a test wants broken it passes as
`spoil`, or changes in the bytes."""
import struct
import zlib

DEPTHS = {"rgba": 32, "grey": 16, "indexed": 8}
IMAGE, GROUP, TILEMAP = 0, 1, 2
RAW, LINKED, COMPRESSED, TILES = 0, 1, 2, 3


def text(s):
    return struct.pack("<H", len(s.encode())) + s.encode()


def chunk(kind, data):
    return struct.pack("<IH", len(data) + 6, kind) + data


class Layer:
    def __init__(self, name, visible=True, kind=IMAGE, level=0, blend=0, opacity=255, background=False,
                 reference=False):
        self.name, self.visible, self.kind, self.level = name, visible, kind, level
        self.blend, self.opacity, self.background, self.reference = blend, opacity, background, reference

    def chunk(self):
        flags = self.visible | 2 | self.background << 3 | self.reference << 6
        data = struct.pack("<HHHHHHB3x", flags, self.kind, self.level, 0, 0, self.blend, self.opacity) + text(self.name)
        return chunk(0x2004, data + (struct.pack("<I", 0) if self.kind == TILEMAP else b""))


class Cel:
    """pixels: rows of the values a pixel has: (r, g, b, a), (v, a) or an index."""

    def __init__(self, layer, pixels=None, x=0, y=0, opacity=255, z=0, kind=COMPRESSED, link=0):
        self.layer, self.pixels, self.x, self.y, self.opacity = layer, pixels, x, y, opacity
        self.z, self.kind, self.link = z, LINKED if pixels is None and kind == COMPRESSED else kind, link

    def chunk(self):
        head = struct.pack("<HhhBHh5x", self.layer, self.x, self.y, self.opacity, self.kind, self.z)
        if self.kind == LINKED:
            return chunk(0x2005, head + struct.pack("<H", self.link))
        raw = b"".join(bytes([p] if isinstance(p, int) else p) for row in self.pixels for p in row)
        head += struct.pack("<HH", len(self.pixels[0]), len(self.pixels))
        return chunk(0x2005, head + (raw if self.kind == RAW else zlib.compress(raw)))


class Ase:
    def __init__(self, w, h, mode="rgba", palette=(), clear=0, flags=1, old_palette=False):
        self.w, self.h, self.mode, self.palette, self.clear = w, h, mode, list(palette), clear
        self.flags, self.old_palette = flags, old_palette
        self.layers, self.frames, self.tags, self.slices = [], [], [], []

    def layer(self, *args, **named):
        self.layers.append(Layer(*args, **named))
        return len(self.layers) - 1

    def frame(self, *cels, ms=100):
        self.frames.append((ms, list(cels)))

    def tag(self, name, first, last, way=0):
        self.tags.append((name, first, last, way))

    def slice(self, name, *keys, pivot=False, patch=False):
        """A key is (frame, x, y, w, h) and, with a pivot, its px, py."""
        self.slices.append((name, keys, pivot, patch))

    def palette_chunk(self):
        if self.old_palette:
            rgb = b"".join(bytes(c[:3]) for c in self.palette)
            return chunk(0x0004, struct.pack("<HBB", 1, 0, len(self.palette) % 256) + rgb)
        data = struct.pack("<III8x", len(self.palette), 0, len(self.palette) - 1)
        for i, c in enumerate(self.palette):
            named = i == 1  # one has a name, which is to be passed over
            data += struct.pack("<H4B", named, *(tuple(c) + (255,))[:4]) + (text("ink") if named else b"")
        return chunk(0x2019, data)

    def tags_chunk(self):
        data = struct.pack("<H8x", len(self.tags))
        for name, first, last, way in self.tags:
            data += struct.pack("<HHBH6x3Bx", first, last, way, 0, 0, 0, 0) + text(name)
        return chunk(0x2018, data)

    @staticmethod
    def slice_chunk(name, keys, pivot, patch):
        data = struct.pack("<III", len(keys), patch | pivot << 1, 0) + text(name)
        for key in keys:
            data += struct.pack("<IiiII", *key[:5]) + (struct.pack("<iiII", 1, 1, 2, 2) if patch else b"")
            data += struct.pack("<ii", *key[5:7]) if pivot else b""
        return chunk(0x2022, data)

    def first_chunks(self):
        """What only the first frame has. Chunks that a reader passes over are among them."""
        chunks = [chunk(0x2007, struct.pack("<HHI8x", 1, 0, 0))]  # the colour profile
        if self.palette:
            chunks.append(self.palette_chunk())
        chunks += [layer.chunk() for layer in self.layers]
        if self.tags:
            chunks += [self.tags_chunk(), chunk(0x2020, struct.pack("<I", 1) + text("of the tag"))]
        return chunks + [self.slice_chunk(*s) for s in self.slices]

    def whole(self):
        body = b""
        for i, (ms, cels) in enumerate(self.frames):
            chunks = (self.first_chunks() if i == 0 else []) + [c.chunk() for c in cels]
            chunks.append(chunk(0x2020, struct.pack("<I", 1) + text("nobody reads this")))
            data = b"".join(chunks)
            body += struct.pack("<IHHH2xI", len(data) + 16, 0xF1FA, min(len(chunks), 0xFFFF), ms, len(chunks)) + data
        head = struct.pack("<IHHHHHIHIIB3xH", len(body) + 128, 0xA5E0, len(self.frames), self.w, self.h,
                           DEPTHS[self.mode], self.flags, 100, 0, 0, self.clear, len(self.palette) % 256)
        return (head + struct.pack("<BBhhHH", 1, 1, 0, 0, 16, 16)).ljust(128, b"\0") + body

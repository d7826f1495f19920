#!/usr/bin/env python3
"""recordings.py - makes the recordings of examples/tape, and the small files that tests read: all of it computed here.

    tools/recordings.py        needs ffmpeg, which encodes

The music is eight bars in F at 120 beats a minute, of which the first two lead in and the other six repeat.
"""
import math
import os
import struct
import subprocess
import tempfile
import wave

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
TAPE = os.path.join(ROOT, "examples", "tape")
SEEDS = os.path.join(ROOT, "tests", "fuzz", "seeds", "fuzz_recording")
RATE = 24000
BEAT = RATE // 2


# ---- synthesis: lists of samples from -1 to 1 ----

def hertz(note):
    return 440 * 2 ** ((note - 69) / 12)


def tone(note, seconds, partials, decay, attack=0.004):
    """A sum of (ratio, level), each dying away the faster the higher it is."""
    out = []
    for i in range(int(seconds * RATE)):
        t = i / RATE
        v = sum(level * math.exp(-t * decay * ratio ** 0.7) * math.sin(2 * math.pi * hertz(note) * ratio * t)
                for ratio, level in partials if hertz(note) * ratio < RATE * 0.45)
        out.append(v * min(1, t / attack) * min(1, (seconds - t) * 40))
    return out


def noise(n):
    state, out = 1, []
    for _ in range(n):
        state = state * 1103515245 + 12345 & 0x7fffffff
        out.append(state / 0x40000000 - 1)
    return out


def drum(seconds, start, end, rattle):
    out, phase, hiss = [], 0.0, noise(int(seconds * RATE))
    for i, h in enumerate(hiss):
        t = i / RATE
        phase += (end + (start - end) * math.exp(-t * 40)) / RATE
        v = (1 - rattle) * math.sin(2 * math.pi * phase) + rattle * h
        out.append(v * math.exp(-t * 12 / seconds * 0.4) * min(1, (seconds - t) * 40))
    return out


def add(to, at, what, level):
    for i, v in enumerate(what):
        to[(at + i) % len(to)] += v * level


# ---- the piece ----

PLUCK = [(1, 1), (2, 0.5), (3, 0.22), (4, 0.1), (5, 0.05)]
BASS = [(1, 1), (2, 0.3), (3, 0.1)]
BELL = [(1, 1), (2.76, 0.45), (5.4, 0.2), (8.9, 0.08)]
CHORDS = [(53, 57, 60), (50, 57, 60), (46, 58, 62), (48, 55, 64)]  # F, D minor, B flat, C
TUNE = [72, 0, 69, 72, 0, 74, 72, 69, 69, 0, 65, 69, 0, 72, 69, 65,
        70, 0, 74, 77, 0, 74, 72, 70, 67, 0, 72, 76, 0, 74, 72, 67]  # eighths of four bars


def piece():
    """Left and right: two bars, then six that go round. A tail that passes the end rings on at the loop's beginning."""
    plucks = {n: tone(n, 0.9, PLUCK, 5) for n in set(TUNE) | {c + 12 for chord in CHORDS for c in chord} if n}
    lows = {chord[0] - 12: tone(chord[0] - 12, 0.45, BASS, 3) for chord in CHORDS}
    kick, snare, hat = drum(0.25, 180, 50, 0.04), drum(0.2, 260, 180, 0.7), drum(0.06, 4000, 3000, 0.97)
    sides = []
    for side in range(2):
        lead, loop = [0.0] * (8 * BEAT), [0.0] * (24 * BEAT)
        for bar in range(8):
            to, at, chord = (lead, bar * 4 * BEAT, CHORDS[bar % 4]) if bar < 2 else \
                            (loop, (bar - 2) * 4 * BEAT, CHORDS[(bar - 2) % 4])
            for k in range(8):
                add(to, at + k * BEAT // 2, lows[chord[0] - 12], 0.20 if k % 3 == 0 else 0.10)
                add(to, at + k * BEAT // 2, plucks[chord[k % 3] + 12], 0.10 if (k + side) % 2 else 0.04)
                if bar >= 2:
                    add(to, at + k * BEAT // 2, hat, 0.05 if k % 2 == side else 0.03)
                    note = TUNE[(bar - 2) % 4 * 8 + k]
                    if note and bar != 7:
                        add(to, at + k * BEAT // 2, plucks[note], 0.16 if side else 0.20)
            for k in range(4):
                add(to, at + k * BEAT, kick if k % 2 == 0 else snare, 0.34 if k % 2 == 0 else 0.18)
        sides.append(lead + loop)
    return sides


# ---- files ----

def write_wav(path, sides, rate):
    out = wave.open(path, "wb")
    out.setnchannels(len(sides))
    out.setsampwidth(2)
    out.setframerate(rate)
    out.writeframes(b"".join(struct.pack("<h", round(max(-1, min(1, v)) * 32767)) for f in zip(*sides) for v in f))
    out.close()


def encode(path, sides, *options, rate=RATE):
    with tempfile.TemporaryDirectory() as scratch:
        source = os.path.join(scratch, "x.wav")
        write_wav(source, sides, rate)
        subprocess.run(["ffmpeg", "-loglevel", "error", "-y", "-i", source, "-map_metadata", "-1", "-fflags",
                        "+bitexact", "-flags:a", "+bitexact", *options, path], check=True)
    if path.endswith(".flac"):
        drop_padding(path)


def drop_padding(path):
    """Takes ffmpeg's 8 KB of nothing out of a FLAC file."""
    with open(path, "rb") as f:
        data = f.read()
    blocks, at, last = [], 4, False
    while not last:
        kind, size = data[at], int.from_bytes(data[at + 1:at + 4], "big")
        last = kind >= 128
        if kind & 127 != 1:
            blocks.append(bytearray(data[at:at + 4 + size]))
            blocks[-1][0] &= 127
        at += 4 + size
    blocks[-1][0] |= 128
    with open(path, "wb") as f:
        f.write(data[:4] + b"".join(blocks) + data[at:])


def loop_tags(start, length):
    return ["-metadata", f"LOOPSTART={start}", "-metadata", f"LOOPLENGTH={length}"]


# ---- modules: one sample, some rows ----

SAW = bytes((i * 8 - 128) & 255 for i in range(32))  # signed


def module_mod():
    def row(period, effect, value):
        return struct.pack(">HBB", period, 0x10 | effect, value) + bytes(12)
    sample = struct.pack(">22sHBBHH", b"saw", 16, 0, 64, 0, 16)
    head = struct.pack("20s", b"tiny") + sample + struct.pack(">22sHBBHH", b"", 0, 0, 0, 0, 1) * 30
    rows = row(428, 15, 2) + row(339, 0, 0) + row(285, 0, 0x37) + row(214, 13, 0)
    return head + bytes([1, 127]) + bytes(128) + b"M.K." + rows.ljust(1024, b"\0") + SAW


def module_xm():
    head = b"Extended Module: " + b"tiny".ljust(20, b"\0") + b"\x1a" + b"recordings.py".ljust(20) + \
        struct.pack("<HI8H", 0x104, 276, 2, 1, 2, 2, 1, 1, 2, 125) + bytes([0, 1]).ljust(256, b"\0")
    out = head
    for notes in ((49, 56, 61, 0), (61, 56, 54, 97)):
        rows = b"".join(bytes([n, 1 if 0 < n < 97 else 0, 0, 0, 0]) + bytes(5) for n in notes)
        out += struct.pack("<IBHH", 9, 0, 4, len(rows)) + rows
    out += struct.pack("<I22sBHI", 263, b"saw", 0, 1, 40) + bytes(96) + bytes(96) + bytes(14) + bytes(22)
    delta = bytes((SAW[i] - (SAW[i - 1] if i else 0)) & 255 for i in range(32))
    out += struct.pack("<IIIBbBBbB22s", 32, 0, 32, 48, 0, 1, 128, 12, 0, b"saw")
    return out + delta


def module_s3m():
    rows = b"".join(bytes([0x20, n, 1, 0]) if n else b"\0" for n in (0x40, 0x44, 0x47)) + \
        bytes([0xa0, 0x50, 1, 3, 0, 0])
    rows += bytes(64 - 4)
    pattern = struct.pack("<H", len(rows) + 2) + rows
    head = struct.pack("<28sBBHHHHHHH4s6B8xH", b"tiny", 0x1a, 16, 0, 2, 1, 1, 0, 0x1320, 2, b"SCRM", 64, 2, 125, 0xb0,
                       0, 0, 0) + bytes([0] + [255] * 31) + bytes([0, 255])
    instrument_at, pattern_at, sample_at = 112, 192, 192 + (len(pattern) + 15) // 16 * 16
    head += struct.pack("<HH", instrument_at // 16, pattern_at // 16)
    instrument = struct.pack("<B12sBHIIIBBBBI12x28s4s", 1, b"saw", 0, sample_at // 16, 32, 0, 32, 64, 0, 0, 1, 8363,
                             b"saw", b"SCRS")
    data = bytes((b + 128) & 255 for b in SAW)
    return head.ljust(instrument_at, b"\0") + instrument + pattern.ljust(sample_at - pattern_at, b"\0") + data


def module_it():
    rows = b"".join(bytes([0x81, 3, n, 1, 0]) for n in (60, 64, 67)) + bytes([0x81, 1, 72, 0])
    head = struct.pack("<4s26sBBHHHHHHHHBBBBBBHII", b"IMPM", b"tiny", 4, 16, 2, 0, 1, 1, 0x214, 0x200, 1, 0, 128, 48, 2,
                       125, 128, 0, 0, 0, 0) + bytes([32] + [160] * 63) + bytes([64] * 64) + bytes([0, 255])
    sample_at = len(head) + 8
    pattern_at = sample_at + 80
    pattern = struct.pack("<HH4x", len(rows), 4) + rows
    data_at = pattern_at + len(pattern)
    sample = struct.pack("<4s12xBBBB26sBBIIIIIIIBBBB", b"IMPS", 64, 0x11, 64, 0, b"saw", 1, 0, 32, 0, 32, 16744, 0, 0,
                         data_at, 0, 0, 0, 0)
    sample = sample[:4] + b"saw".ljust(12, b"\0") + sample[16:]
    return head + struct.pack("<II", sample_at, pattern_at) + sample + pattern + SAW


# ---- all ----

def seeds():
    os.makedirs(SEEDS, exist_ok=True)

    def seed(name):
        return os.path.join(SEEDS, name)
    left = [math.sin(i * 0.05) * 0.5 + math.sin(i * 0.31) * 0.2 for i in range(2400)]
    right = [math.sin(i * 0.08) * 0.6 for i in range(2400)]
    write_wav(seed("stereo.wav"), [left[:400], right[:400]], 12000)
    with open(seed("stereo.wav"), "rb") as f:
        data = f.read()
    chunk = struct.pack("<9I", 0, 0, 0, 60, 0, 0, 0, 1, 0) + struct.pack("<6I", 0, 0, 100, 399, 0, 0)
    with open(seed("loop.wav"), "wb") as f:
        f.write(data[:4] + struct.pack("<I", len(data) - 8 + 8 + len(chunk)) + data[8:] +
                b"smpl" + struct.pack("<I", len(chunk)) + chunk)
    encode(seed("loop.ogg"), [left, right], "-c:a", "libvorbis", "-q:a", "0", *loop_tags(600, 1800), rate=12000)
    encode(seed("loop.flac"), [left, right], "-c:a", "flac", *loop_tags(600, 1800), rate=12000)
    encode(seed("mono.flac"), [left], "-c:a", "flac", rate=12000)
    encode(seed("mono.opus"), [left], "-c:a", "libopus", "-b:a", "16k", *loop_tags(2400, 4800), rate=12000)
    for name, make in (("tiny.mod", module_mod), ("tiny.xm", module_xm), ("tiny.s3m", module_s3m),
                       ("tiny.it", module_it)):
        with open(seed(name), "wb") as f:
            f.write(make())


def main():
    for folder in ("music", "sfx"):
        os.makedirs(os.path.join(TAPE, folder), exist_ok=True)
    encode(os.path.join(TAPE, "music", "reel.ogg"), piece(), "-c:a", "libvorbis", "-q:a", "1",
           *loop_tags(8 * BEAT, 24 * BEAT))
    bell = tone(77, 0.8, BELL, 4)
    encode(os.path.join(TAPE, "sfx", "bell.flac"), [[v * 0.5 for v in bell]], "-c:a", "flac")
    encode(os.path.join(TAPE, "sfx", "thump.flac"), [[v * 0.8 for v in drum(0.3, 160, 40, 0.1)]], "-c:a", "flac")
    seeds()


main()

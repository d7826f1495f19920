#!/usr/bin/env python3
"""played.py - what a card played (raw, 16 bits, stereo) beside what was rendered (WAV).

    played.py same PLAYED WANT.wav    the same frames in the same order, frames of silence that padded them aside;
                                      prints how many of these stood between the first frame and the last
    played.py sine PLAYED HZ          a sine of that pitch, within a percent: prints its gaps and breaks, expected none
"""
import array
import math
import sys


def frames(data):
    a = array.array("I")  # a stereo frame a number
    a.frombytes(data[: len(data) // 4 * 4])
    return a


def same(played, wav):
    want = frames(wav[44:])
    i = j = pads = 0
    begun = False
    while j < len(want):
        if i == len(played):
            return f"played ends at frame {j} of {len(want)}"
        if played[i] == want[j]:
            begun = begun or want[j] != 0
            j += 1
        elif played[i] == 0:
            pads += begun
        else:
            return f"frame {i} played: {played[i]:08x}, expected frame {j}: {want[j]:08x}"
        i += 1
    print(f"{len(want)} frames, {pads} of silence between them")
    return None


def sine(played, hz):
    """A sine is a line of second order: x[n+1] + x[n-1] = 2 cos(w) x[n]. What breaks it is a gap, a repeat, a cut."""
    left = [(v & 0xFFFF) - ((v & 0x8000) << 1) for v in played]
    loud = [i for i, v in enumerate(left) if abs(v) > 1000]
    if not loud:
        return "nothing was played"
    w = 2 * math.pi * hz / 48000
    top = max(left)
    first, last = loud[0] + 4800, loud[-1] - 4800
    worst = max(abs(left[i + 1] + left[i - 1] - 2 * math.cos(w) * left[i]) for i in range(first, last))
    turns = sum(left[i] < 0 <= left[i + 1] for i in range(first, last))
    got = turns * 48000 / (last - first)
    print(f"{last - first} frames, {got:.2f} Hz, at most {worst:.0f} of {top} off")
    if abs(got - hz) > hz / 100:
        return f"{got:.2f} Hz, expected {hz}"
    if worst > top * 2 * math.sin(w) * w * 0.02 + 8:
        return "it breaks"
    return None


with open(sys.argv[2], "rb") as f:
    data = frames(f.read())
if sys.argv[1] == "same":
    with open(sys.argv[3], "rb") as f:
        wrong = same(data, f.read())
else:
    wrong = sine(data, float(sys.argv[3]))
if wrong:
    sys.exit(wrong)

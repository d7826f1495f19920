#!/usr/bin/env python3
"""pe_spoil.py - exports a game with damaged players for Windows. Exit 1: not refused with one sentence, or a crash.

    pe_spoil.py CURTAIN GAME PLAYER [FLIPS]     PLAYER: where CURTAIN looks for it; it is damaged and put back
"""
import os
import random
import subprocess
import sys

sys.dont_write_bytecode = True


def main(curtain, game, player, flips=150):
    with open(player, "rb") as f:
        whole = f.read()
    refused = 0

    def attempt(what, data, may_pass):
        nonlocal refused
        with open(player, "wb") as f:
            f.write(data)
        out = "spoiled.exe"
        if os.path.exists(out):
            os.remove(out)
        run = subprocess.run([curtain, "export", game, "--windows", "-o", out], capture_output=True, text=True)
        refused += run.returncode == 2
        if run.returncode == 0 and may_pass and os.path.exists(out) and not run.stderr:
            return
        sentence = run.stderr.count("\n") == 1 and run.stderr.startswith("curtain: " + player + ": ")
        if run.returncode != 2 or not sentence or os.path.exists(out):
            sys.exit("%s: exit code %d, %r" % (what, run.returncode, run.stderr[-400:]))

    end = whole.index(b"signature, names")  # of the last section; what is behind may be missing
    for n in range(0, len(whole), 97):
        attempt("truncated to %d bytes" % n, whole[:n], n >= end)
    rng = random.Random(1)
    used = [i for i, byte in enumerate(whole) if byte or 60 <= i < 560]
    for _ in range(int(flips)):
        data = bytearray(whole)
        for _ in range(rng.choice((1, 1, 2, 8))):
            data[rng.choice(used)] ^= 1 << rng.randrange(8)
        attempt("flipped", data, True)
    with open(player, "wb") as f:
        f.write(whole)
    print("%d refused" % refused)
    if refused < 30:
        sys.exit("too few are refused")


main(*sys.argv[1:])

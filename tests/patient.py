#!/usr/bin/env python3
"""patient.py - runs a program and ends it when it hangs; however busy the machine is, one that is slow is not taken
for one that hangs.

    patient.py [--cpu SECONDS] [--asleep SECONDS] OUTPUT COMMAND...

What it prints goes to the file OUTPUT. It hangs when since its last output it (with all that it started) has used more
than --cpu seconds of the processor (default 900), or was seen asleep for more than --asleep seconds, in each of which
none of its processes ran or wanted to (default 900). A slow one on a busy machine wants to. Exit code: the program's;
128 and the signal that ended it; 124 when it hung, which OUTPUT says in its last line. Where there is no /proc nothing
hangs."""
import ctypes
import os
import signal
import subprocess
import sys
import time

TICK = os.sysconf("SC_CLK_TCK")
SUBREAPER = 36  # prctl: what its children leave behind becomes ours, so that it is seen and ended


def processes():
    """{pid: (parent, state, seconds of processor time with that of children waited for)}."""
    found = {}
    for name in os.listdir("/proc") if os.path.isdir("/proc/self") else ():
        try:
            with open("/proc/%s/stat" % name, "rb") as f:
                fields = f.read().rpartition(b")")[2].split()
            found[int(name)] = int(fields[1]), fields[0].decode(), sum(map(int, fields[11:15])) / TICK
        except (OSError, ValueError, IndexError):
            continue
    return found


def below(root, found):
    """The pids that root started, and what these started."""
    tree, grown = {root}, True
    while grown:
        more = {pid for pid, (parent, _, _) in found.items() if parent in tree} - tree
        tree |= more
        grown = bool(more)
    return tree - {root}


def end(program):
    for _ in range(20):  # what it starts meanwhile too
        found = processes()
        left = [pid for pid in below(os.getpid(), found) if found[pid][1] != "Z"]
        for pid in left:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        program.poll()
        if not left:
            return
        time.sleep(0.05)


def watch(program, out, cpu, asleep):
    """None when it ended by itself, else why it was ended."""
    size, used, slept, most = -1, 0.0, 0.0, 0.0
    before = time.monotonic()
    while True:
        try:
            program.wait(1 if slept or most else 0.2)
            return None
        except subprocess.TimeoutExpired:
            pass
        found, now = processes(), time.monotonic()
        tree = below(os.getpid(), found)
        most = max(most, sum(found[pid][2] for pid in tree))
        if os.fstat(out.fileno()).st_size != size:
            size, used, slept = os.fstat(out.fileno()).st_size, most, 0.0
        elif tree and not any(found[pid][1] in "RD" for pid in tree):
            slept += min(now - before, 2)  # we may have been kept waiting ourselves
        before = now
        if most - used > cpu:
            return "it hangs: %d s of the processor's time without a line" % cpu
        if slept > asleep:
            return "it hangs: asleep for %d s" % asleep


def main(words):
    limits = {"--cpu": 900.0, "--asleep": 900.0}
    while words and words[0] in limits:
        limits[words[0]] = float(words[1])
        words = words[2:]
    if len(words) < 2:
        sys.exit(__doc__)
    ctypes.CDLL(None).prctl(SUBREAPER, 1, 0, 0, 0)
    with open(words[0], "wb") as out:
        program = subprocess.Popen(words[1:], stdin=subprocess.DEVNULL, stdout=out, stderr=subprocess.STDOUT)
        why = watch(program, out, limits["--cpu"], limits["--asleep"])
        if why:
            end(program)
            out.seek(0, os.SEEK_END)
            out.write(("# %s\n" % why).encode())
            return 124
    end(program)  # what it left running
    return program.returncode if program.returncode >= 0 else 128 - program.returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

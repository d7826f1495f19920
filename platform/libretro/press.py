#!/usr/bin/env python3
"""press.py PORT SEED: any pads at any time over RetroArch's network gamepad (UDP), until it is stopped."""
import random, socket, struct, sys, time

BUTTONS = 12
rng, out = random.Random(int(sys.argv[2])), socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
held = 0
while True:
    held ^= 1 << rng.choice([0, 0, 1, 3, 4, 5, 6, 7, 8, 9])
    for button in range(BUTTONS):  # int port, device, index, id; u16 state
        out.sendto(struct.pack("@iiiiH2x", 0, 1, 0, button, held >> button & 1), ("127.0.0.1", int(sys.argv[1])))
    time.sleep(rng.uniform(0.02, 0.15))

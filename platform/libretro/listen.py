#!/usr/bin/env python3
"""listen.py CORE ROM FRAMES: another front end, of ctypes: prints nothing, writes the core's sound to ./heard."""
import ctypes, sys

core, heard = ctypes.CDLL(sys.argv[1]), bytearray()
ENVIRONMENT = ctypes.CFUNCTYPE(ctypes.c_bool, ctypes.c_uint, ctypes.c_void_p)
VIDEO = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_uint, ctypes.c_uint, ctypes.c_size_t)
SAMPLE = ctypes.CFUNCTYPE(None, ctypes.c_int16, ctypes.c_int16)
BATCH = ctypes.CFUNCTYPE(ctypes.c_size_t, ctypes.c_void_p, ctypes.c_size_t)
POLL = ctypes.CFUNCTYPE(None)
STATE = ctypes.CFUNCTYPE(ctypes.c_int16, ctypes.c_uint, ctypes.c_uint, ctypes.c_uint, ctypes.c_uint)


class Game(ctypes.Structure):
    _fields_ = [("path", ctypes.c_char_p), ("data", ctypes.c_char_p), ("size", ctypes.c_size_t),
                ("meta", ctypes.c_char_p)]


def batch(samples, frames):
    heard.extend(ctypes.string_at(samples, 4 * frames))
    return frames


calls = [("environment", ENVIRONMENT(lambda what, data: what == 10)),  # the format of pixels; no other wish
         ("video_refresh", VIDEO(lambda *a: None)), ("audio_sample", SAMPLE(lambda *a: None)),
         ("audio_sample_batch", BATCH(batch)), ("input_poll", POLL(lambda: None)), ("input_state", STATE(lambda *a: 0))]
for name, call in calls:
    getattr(core, "retro_set_" + name)(call)
core.retro_init()
rom = open(sys.argv[2], "rb").read()
core.retro_load_game.restype = ctypes.c_bool
if not core.retro_load_game(ctypes.byref(Game(sys.argv[2].encode(), rom, len(rom), None))):
    sys.exit("the game is refused")
for _ in range(int(sys.argv[3])):
    core.retro_run()
core.retro_unload_game()
core.retro_deinit()
open("heard", "wb").write(heard)

"""Checks the #include lines of the files named: every file includes its own floor or below.

Floors: src/base 0, fb 1, src/chips 2, src/board 3, src/cab 4, platform 5. Besides:
  - a chip includes of the chips only its own header, slots.h (what a chip is made of) and motion.h (how things move);
  - Lua's headers are seen in src/board alone; stb in src/cab/pack/png.c alone;
  - platform.h is included by src/cab; a port includes that header and nothing else of ours;
  - below the cabinet only the headers of C that reach no host; host.h alone sees what the host has set.
Tests and tools may include anything."""
import os
import re
import sys

FLOORS = {"src/base": 0, "fb": 1, "src/chips": 2, "src/board": 3, "src/cab": 4, "platform": 5}
SHARED = {"src/chips/slots.h", "src/chips/motion.h"}
LUA = {"lua.h", "lauxlib.h", "lualib.h", "luaconf.h"}
# stdio.h: snprintf into the caller's buffer; stdlib.h: strtod, qsort, abort. What is called is checked by calls.sh.
PURE = {"assert.h", "float.h", "inttypes.h", "limits.h", "math.h", "setjmp.h", "stdarg.h", "stdbool.h", "stddef.h",
        "stdint.h", "stdio.h", "stdlib.h", "string.h"}
HOST, HOST_FILES = {"fenv.h", "locale.h", "xlocale.h"}, {"src/base/host.h"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def own(path, name):
    """What is wrong with including our file `name` in `path`."""
    folder, target = os.path.dirname(path), os.path.normpath(os.path.join(os.path.dirname(path), name))
    there = os.path.dirname(target)
    if not os.path.exists(target):
        return "there is no " + target
    if there not in FLOORS:
        return target + " is on no floor"
    if folder == "platform" and target != "platform/platform.h":
        return "a port includes platform.h and nothing else of ours"
    if there == "platform" and folder not in ("platform", "src/cab"):
        return "only src/cab includes platform.h"
    if there == "platform" and target != "platform/platform.h":
        return "only platform.h is for others"
    if there != "platform" and FLOORS[there] > FLOORS[folder]:
        return "%s is on a higher floor" % target
    if folder == there == "src/chips" and target not in SHARED and target[:-2] != path[:-2]:
        return "a chip includes no other chip but slots.h and motion.h"
    return None


def system(path, name):
    """What is wrong with including the system's file `name` in `path`."""
    folder = os.path.dirname(path)
    if name in LUA:
        return None if folder == "src/board" else "only src/board sees Lua"
    if name.startswith("stb"):
        return None if path == "src/cab/pack/png.c" else "stb is for src/cab/pack/png.c alone"
    if name in HOST:
        return None if path in HOST_FILES else "the host's settings are for src/base/host.h alone"
    if FLOORS[folder] < 4 and name not in PURE:
        return "below the cabinet there is no <%s>" % name
    return None


def check(path):
    found = []
    with open(path, encoding="utf-8") as f:
        for number, line in enumerate(f, 1):
            m = INCLUDE.match(line)
            if m:
                wrong = (own if m[1] == '"' else system)(path, m[2])
                if wrong:
                    found.append("%s:%d: %s" % (path, number, wrong))
    return found


def main(paths):
    ours = [p for p in paths if os.path.dirname(p) in FLOORS]
    strange = [p + ": is in no folder of the house" for p in paths
               if p.split("/")[0] in ("src", "fb", "platform") and p not in ours]
    found = strange + [line for p in ours for line in check(p)]
    print("\n".join(found) if found else "%d files" % len(ours))
    return 1 if found or not ours else 0


sys.exit(main(sys.argv[1:]))

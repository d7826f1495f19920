"""Checks the #include lines of the files named: every file includes its own floor or below, and rooms, which are the
folders, include each other in no circle. Prints each room with how many files it has and what rooms it includes.

Floors: src/base 0, fb and src/snd 1, src/chips 2, src/board 3, src/cab 4, each of chips, board and cab
with its rooms; src/lib 5, platform 6.
Besides:
  - a chip includes of the chips only its own header, slots.h (what a chip is made of) and motion.h (how things move);
  - Lua's headers are seen in src/board alone; stb in src/cab/pack/png.c alone;
  - platform.h is included by src/cab; a port includes that header and nothing else of ours; the files of a host share
    host.h, and win.h, where Windows' own headers are seen;
  - a header that need not be installed is not included, and not asked for: what a build can do depends on none;
  - below the cabinet only the headers of C that reach no host; host.h alone sees what the host has set.
Tests and tools may include anything."""
import os
import re
import sys

FLOORS = {"src/base": 0, "fb": 1, "src/snd": 1, "src/chips": 2, "src/board": 3, "src/cab": 4, "src/lib": 5,
          "platform": 6}
BIGGEST_ROOM = 26  # files in a room of src
SHARED = {"src/chips/slots.h", "src/chips/motion.h"}
LUA = {"lua.h", "lauxlib.h", "lualib.h", "luaconf.h"}
# stdio.h: snprintf into the caller's buffer; stdlib.h: strtod, qsort, abort. What is called is checked by calls.sh.
PURE = {"assert.h", "float.h", "inttypes.h", "limits.h", "math.h", "setjmp.h", "stdarg.h", "stdbool.h", "stddef.h",
        "stdint.h", "stdio.h", "stdlib.h", "string.h"}
# The other headers of the C library and POSIX; the compiler's packages bring them.
SYSTEM = PURE | {"ctype.h", "dirent.h", "dlfcn.h", "elf.h", "errno.h", "fcntl.h", "mach-o/dyld.h", "poll.h",
                 "pthread.h", "signal.h", "spawn.h", "sys/auxv.h", "sys/stat.h", "sys/time.h", "sys/utsname.h",
                 "sys/wait.h", "time.h", "unistd.h"}
# The defaults of platform.h, and each host's half of them: they share headers that a port does not see.
HOST_HEADERS = {"platform/host.h", "platform/win.h"}
WINDOWS = {"windows.h", "io.h", "shlobj.h"}
HOST_FILE = re.compile(r"platform/(stdio|posix|win|iso|no)(_process|_register)?\.[ch]$|platform/host\.h$")
LINKED = {"src/cab/pack/png.c", "platform/sdl2.c"}  # these include headers of libraries that every build needs
HOST, HOST_FILES = {"fenv.h", "locale.h", "xlocale.h"}, {"src/base/host.h"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]|.*__has_include\(<([^>]+)>\)')


def house(folder):
    """The folder of FLOORS that a room belongs to, or None."""
    with_rooms = ("src/chips", "src/board", "src/cab")
    return next((f for f in FLOORS if folder == f or folder.startswith(f + "/") and f in with_rooms), None)


def target_of(path, name):
    return os.path.normpath(os.path.join(os.path.dirname(path), name))


def own(path, name):
    """What is wrong with including our file `name` in `path`."""
    folder, target = house(os.path.dirname(path)), target_of(path, name)
    there = house(os.path.dirname(target))
    if not os.path.exists(target):
        return "there is no " + target
    if there is None:
        return target + " is on no floor"
    if folder == "platform" and target != "platform/platform.h" and not (
            target in HOST_HEADERS and HOST_FILE.match(path)):
        return "a port includes platform.h and nothing else of ours"
    if there == "platform" and folder not in ("platform", "src/cab", "src/lib"):
        return "only src/cab and src/lib include platform.h"
    if there == "platform" and folder != "platform" and target != "platform/platform.h":
        return "only platform.h is for others"
    if there != "platform" and FLOORS[there] > FLOORS[folder]:
        return "%s is on a higher floor" % target
    if folder == there == "src/chips" and target not in SHARED and target[:-2] != path[:-2]:
        return "a chip includes no other chip but slots.h and motion.h"
    return None


def system(path, name):
    """What is wrong with including the system's file `name` in `path`."""
    folder = house(os.path.dirname(path))
    if name in LUA:
        return None if folder == "src/board" else "only src/board sees Lua"
    if name.startswith("stb"):
        return None if path == "src/cab/pack/png.c" else "stb is for src/cab/pack/png.c alone"
    if name in HOST:
        return None if path in HOST_FILES else "the host's settings are for src/base/host.h alone"
    if FLOORS[folder] < 4 and name not in PURE:
        return "below the cabinet there is no <%s>" % name
    if name in WINDOWS:
        return None if path.startswith("platform/win") else "<%s> is for the files of Windows alone" % name
    if name not in SYSTEM and path not in LINKED:
        return "<%s> need not be installed; declare what is used (src/cab/host/library.h)" % name
    return None


def check(path):
    found = []
    with open(path, encoding="utf-8") as f:
        for number, line in enumerate(f, 1):
            m = INCLUDE.match(line)
            if m:
                wrong = (own if m[1] == '"' else system)(path, m[2] or m[3])
                if wrong:
                    found.append("%s:%d: %s" % (path, number, wrong))
    return found


def arrows(paths):
    """The rooms each room includes, as {room: {other: a line that does}}."""
    rooms = {}
    for path in paths:
        room = rooms.setdefault(os.path.dirname(path), {})
        with open(path, encoding="utf-8") as f:
            for number, line in enumerate(f, 1):
                m = INCLUDE.match(line)
                other = os.path.dirname(target_of(path, m[2])) if m and m[1] == '"' else None
                if other and other != os.path.dirname(path):
                    room.setdefault(other, "%s:%d" % (path, number))
    return rooms


def circle(rooms):
    """A circle of arrows, as a list of rooms, or None."""
    done, way = set(), []

    def walk(room):
        if room in way:
            return way[way.index(room):] + [room]
        if room in done:
            return None
        way.append(room)
        found = next(filter(None, (walk(other) for other in sorted(rooms.get(room, {})))), None)
        way.pop()
        done.add(room)
        return found

    return next(filter(None, (walk(room) for room in sorted(rooms))), None)


def check_rooms(paths):
    """What is wrong with the rooms; prints them."""
    rooms, found = arrows(paths), []
    for room in sorted(rooms):
        files = sum(os.path.dirname(p) == room for p in paths)
        print("%-18s %2d files -> %s" % (room, files, " ".join(sorted(rooms[room])) or "none"))
        if room.startswith("src/") and files > BIGGEST_ROOM:
            found.append("%s: %d files; a room has %d at most" % (room, files, BIGGEST_ROOM))
    round_and_round = circle(rooms)
    if round_and_round:
        found.append("rooms in a circle: " + ", ".join(
            "%s -> %s (%s)" % (a, b, rooms[a][b]) for a, b in zip(round_and_round, round_and_round[1:])))
    return found


def main(paths):
    ours = [p for p in paths if house(os.path.dirname(p))]
    strange = [p + ": is in no folder of the house" for p in paths
               if p.split("/")[0] in ("src", "fb", "platform") and p not in ours]
    found = strange + [line for p in ours for line in check(p)] + check_rooms(ours)
    print("\n".join(found) if found else "%d files" % len(ours))
    return 1 if found or not ours else 0


sys.exit(main(sys.argv[1:]))

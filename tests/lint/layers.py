"""Checks the #include lines of the files named: a file includes headers of its own layer and of those below, and the
directories of src/player and src/workbench include each other in no cycle.

LAYERS is the order, lowest first; a layer is a directory with those in it. Besides:
  - an entity includes of the entities only its own headers (bullets_move.c: bullets.h, bullets_parts.h) and motion.h
    (how things move);
  - Lua's headers are seen in src/script and src/board, and where rom.lua and test scripts are read; stb in
    src/player/picture/png.c and src/workbench/pack/ttf.c alone;
  - platform.h is included by src/common, src/demo, src/lib, src/player and src/workbench; a port includes that header
    and nothing else of ours, or curtain.h if it is a host of the library; the files of a host share host.h, and win.h,
    where Windows' own headers are seen;
  - a header that need not be installed is not included, and not asked for: what a build can do depends on none;
  - below src/common only the headers of C that reach no host; src/base/host.h alone sees what the host has set.
Tests and tools may include anything."""
import graphlib
import os
import re
import sys

LAYERS = ["src/base", "fb", "src/sound", "src/entities", "src/rom", "src/machine", "src/script", "src/board",
          "src/common", "src/demo", "src/lib", "src/player", "src/workbench", "platform"]
SHARED = {"src/entities/motion.h"}
LUA = {"lua.h", "lauxlib.h", "lualib.h", "luaconf.h"}
SEES_LUA = re.compile(r"src/(script|board)/|src/workbench/(test/test_script\w*|pack/(manifest_\w+|value))\.[ch]$")
ASKS_HOST = {"src/common", "src/demo", "src/lib", "src/player", "src/workbench"}
# stdio.h: snprintf into the caller's buffer; stdlib.h: strtod, qsort, abort. What is called is checked by calls.sh.
PURE = {"assert.h", "float.h", "inttypes.h", "limits.h", "math.h", "setjmp.h", "stdarg.h", "stdbool.h", "stddef.h",
        "stdint.h", "stdio.h", "stdlib.h", "string.h"}
# The other headers of the C library and POSIX; the compiler's packages bring them.
SYSTEM = PURE | {"ctype.h", "dirent.h", "dlfcn.h", "elf.h", "errno.h", "fcntl.h", "mach-o/dyld.h", "poll.h",
                 "pthread.h", "signal.h", "spawn.h", "sys/auxv.h", "sys/stat.h", "sys/time.h", "sys/utsname.h",
                 "sys/wait.h", "time.h", "unistd.h"}
# Hosts of libcurtain and of the whole program in other ports: they may include what they need.
HOSTS = re.compile(r"platform/(example|libretro|web)/")
# The defaults of platform.h, and each host's half of them: they share headers that a port does not see.
HOST_HEADERS = {"platform/host.h", "platform/win.h"}
WINDOWS = {"windows.h", "io.h", "shlobj.h"}
HOST_FILE = re.compile(r"platform/(stdio|posix|win|iso|no)(_process|_register)?\.[ch]$|platform/host\.h$")
STB_FILES = ("src/player/picture/png.c", "src/workbench/pack/ttf.c")
LINKED = {*STB_FILES, "platform/sdl2.c"}  # these include headers of libraries that every build needs
HOST, HOST_FILES = {"fenv.h", "locale.h", "xlocale.h"}, {"src/base/host.h"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]|.*__has_include\(<([^>]+)>\)')


def layer(folder):
    """The layer that a directory belongs to, or None."""
    return next((one for one in LAYERS if folder == one or folder.startswith(one + "/")), None)


def target_of(path, name):
    return os.path.normpath(os.path.join(os.path.dirname(path), name))


def entity(path):
    return os.path.basename(path)[:-2].split("_")[0]


def own(path, name):
    """What is wrong with including our file `name` in `path`."""
    here, target = layer(os.path.dirname(path)), target_of(path, name)
    there = layer(os.path.dirname(target))
    if not os.path.exists(target):
        return "there is no " + target
    if there is None:
        return target + " is in no layer"
    if target == "platform/platform.h" and here != "platform":
        return None if here in ASKS_HOST else "platform.h is not for this layer"
    if here == "platform":
        free = target == "platform/platform.h" or os.path.dirname(target) == os.path.dirname(path) != "platform"
        if free or (target in HOST_HEADERS and HOST_FILE.match(path)) or HOSTS.match(path):
            return None
        return "a port includes platform.h and nothing else of ours"
    if there == "platform":
        return "only platform.h is for others"
    if LAYERS.index(there) > LAYERS.index(here):
        return "%s is in a higher layer" % target
    if here == there == "src/entities" and target not in SHARED and entity(target) != entity(path):
        return "an entity includes no other but motion.h"
    return None


def system(path, name):
    """What is wrong with including the system's file `name` in `path`."""
    here = layer(os.path.dirname(path))
    if name in LUA:
        return None if SEES_LUA.match(path) else "Lua is not for this file"
    if name.startswith("stb"):
        return None if path in STB_FILES or HOSTS.match(path) else "stb is for %s alone" % " and ".join(STB_FILES)
    if name in HOST:
        return None if path in HOST_FILES else "the host's settings are for src/base/host.h alone"
    if LAYERS.index(here) < LAYERS.index("src/common") and name not in PURE:
        return "below src/common there is no <%s>" % name
    if name in WINDOWS:
        return None if path.startswith("platform/win") else "<%s> is for the files of Windows alone" % name
    if name not in SYSTEM and path not in LINKED and not HOSTS.match(path):
        return "<%s> need not be installed; declare what is used (src/common/library.h)" % name
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
    """The directories that each directory of src/player and src/workbench includes."""
    graph = {}
    for path in paths:
        here = os.path.dirname(path)
        if not here.startswith(("src/player", "src/workbench")):
            continue
        with open(path, encoding="utf-8") as f:
            names = [m[2] for m in map(INCLUDE.match, f) if m and m[1] == '"']
        graph.setdefault(here, set()).update(os.path.dirname(target_of(path, name)) for name in names)
        graph[here].discard(here)
    return graph


def check_cycle(paths):
    try:
        graphlib.TopologicalSorter(arrows(paths)).prepare()
    except graphlib.CycleError as error:
        return ["directories in a cycle: " + " ".join(error.args[1])]
    return []


def main(paths):
    ours = [p for p in paths if layer(os.path.dirname(p))]
    found = [p + ": is in no layer" for p in paths if p.split("/")[0] in ("src", "fb", "platform") and p not in ours]
    found += [line for p in ours for line in check(p)] + check_cycle(ours)
    print("\n".join(found) if found else "%d files" % len(ours))
    return 1 if found or not ours else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

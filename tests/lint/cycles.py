"""cycles.py OUT: which objects need each other, by their symbols, a table of function pointers like a call. Prints the
cycles, longest first; none may be longer than LONGEST. No symbol is used in a layer below the one that defines it, and
no file is longer than LINES."""
import os
import subprocess
import sys

from layers import LAYERS, layer

LONGEST, LINES = 8, 1000
GENERATED = {"src/base/trig_tables.h"}


def objects(out):
    """{source: its object}"""
    found = {}
    for top in ("src", "fb"):
        for folder, _, files in os.walk(top):
            for name in files:
                path = os.path.join(folder, name)
                built = os.path.join(out, path[:-1] + "o")
                if path.endswith(".c") and os.path.exists(built):
                    found[path] = built
    return found


def graph_of(out):
    """{source: {source that defines what it uses: a symbol}}"""
    defined, used = {}, {}
    for path, built in objects(out).items():
        for line in subprocess.run(["nm", "-g", built], capture_output=True, text=True, check=True).stdout.splitlines():
            kind, name = line.split()[-2:]
            if kind == "U":
                used.setdefault(path, set()).add(name)
            else:
                defined[name] = path
    return {path: {defined[s]: s for s in sorted(used.get(path, ())) if defined.get(s, path) != path}
            for path in objects(out)}


def cycles(graph):
    """Tarjan's strongly connected components of more than one node."""
    index, low, stack, found = {}, {}, [], []

    def walk(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for other in sorted(graph[node]):
            if other not in index:
                walk(other)
            if other in stack:
                low[node] = min(low[node], low[other])
        if low[node] == index[node]:
            at = stack.index(node)
            if len(stack) - at > 1:
                found.append(sorted(stack[at:]))
            del stack[at:]

    for node in sorted(graph):
        if node not in index:
            walk(node)
    return sorted(found, key=lambda c: (-len(c), c))


def wrong(graph):
    found = ["%s uses %s of %s, a higher layer" % (a, s, b) for a in sorted(graph) for b, s in sorted(graph[a].items())
             if LAYERS.index(layer(os.path.dirname(b))) > LAYERS.index(layer(os.path.dirname(a)))]
    for cycle in cycles(graph):
        print("cycle of %d: %s" % (len(cycle), " ".join(cycle)))
        if len(cycle) > LONGEST:
            found.append("a cycle of %d objects, at most %d: %s" % (len(cycle), LONGEST, " ".join(cycle)))
    return found


def too_long():
    found = []
    for top in ("src", "fb", "platform"):
        for folder, _, files in os.walk(top):
            for path in (os.path.join(folder, name) for name in files if name.endswith((".c", ".h"))):
                with open(path, encoding="utf-8") as f:
                    lines = sum(1 for _ in f)
                if lines > LINES and path not in GENERATED:
                    found.append("%s: %d lines, at most %d" % (path, lines, LINES))
    return found


def main(out):
    sys.setrecursionlimit(10000)
    graph = graph_of(out)
    found = wrong(graph) + too_long()
    print("\n".join(found) if found else "%d objects" % len(graph))
    return 1 if found or len(graph) < 100 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))

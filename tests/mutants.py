#!/usr/bin/env python3
"""mutants.py - reads tests/mutants.list and plants its faults (mutants) in a tree.

    mutants.py list LIST [WORD...]      numbers and digests, of all or of those whose line contains a word
    mutants.py tests LIST NUMBER...     the tests named with them, as paths below tests/
    mutants.py check LIST               the format only: reads no source. Prints what is wrong; exit 1
    mutants.py plantable LIST TREE      can each be planted? Prints those that cannot; exit 1
    mutants.py plant LIST TREE NUMBER   plants one; exit 1 and a sentence if it cannot

The list's format is described at its top. A mutant is found by the name of what encloses it and by its text, where any
white space matches any: so it survives moved files, reformatting, and edits around it."""
import functools
import hashlib
import os
import re
import sys

FOLDERS = ("src", "fb", "platform", "tools", "scripts", "roms", "ports")
NAME = r"[A-Za-z_][A-Za-z0-9_]*"
# Comments and strings of C and Lua, whose braces and parentheses do not count.
C_SKIP = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S)
C_TOKEN = re.compile(r"^[ \t]*#(?:[^\n\\]|\\\n|\\.)*|[{}();=]|" + NAME, re.M)
LUA_NAME = re.compile(r"(?:local\s+)?function\s+([\w.:]+)|(?:local\s+)?([\w.]+)(?:\s*,\s*[\w.]+)*\s*=|local\s+(\w+)")


class Mutant:
    def __init__(self, number, line, tests):
        self.number, self.line, self.tests = number, line, tests
        self.place, _, change = line.partition(": ")
        self.old, _, self.new = change.partition(" => ")


def read(path):
    """The mutants of a list, and what is wrong with its format."""
    mutants, wrong, tests = [], [], []
    with open(path, encoding="utf-8") as f:
        for n, line in enumerate(f.read().split("\n"), 1):
            if not line.strip() or line.startswith("#"):
                continue
            if line.startswith("@"):
                tests = line[1:].split()
                wrong += ["line %d: no test is named" % n] if not tests else []
                continue
            m = Mutant(len(mutants) + 1, line, tests)
            mutants.append(m)
            if not re.fullmatch(r"[\w.:-]+", m.place) or not m.old.strip() or line.count(" => ") != 1:
                wrong.append("line %d: expected PLACE: OLD => NEW, got: %s" % (n, line))
            elif m.old.split() == m.new.split():
                wrong.append("line %d: nothing is changed: %s" % (n, line))
            elif not tests:
                wrong.append("line %d: no test is named above it: %s" % (n, line))
    return mutants, wrong


def blank(match):
    return re.sub(r"[^\n]", " ", match.group())


def c_regions(text):
    """[(name, from, to)] of a C file's outermost definitions: functions, tables, types, macros."""
    regions, depth, parens, start, name, fixed = [], 0, 0, None, None, False
    for t in C_TOKEN.finditer(C_SKIP.sub(blank, text)):
        word = t.group()
        if word.lstrip().startswith("#"):
            macro = re.match(r"\s*#\s*define\s+(" + NAME + ")", word)
            if macro and depth == 0:
                regions.append((macro.group(1), t.start(), t.end()))
            continue
        start = t.start() if start is None else start
        if word == "{":
            depth += 1
        elif word == "}":
            depth -= 1
        elif word in "()":
            fixed, parens = fixed or (depth == 0 and name is not None), parens + (1 if word == "(" else -1)
        elif word == "=":
            fixed = fixed or depth == 0
        elif word != ";" and depth == 0 and not fixed:
            name = word
        if depth == 0 and parens == 0 and (word == ";" or (word == "}" and not re.match(r"\s*;", text[t.end():]))):
            if name:
                regions.append((name, start, t.end()))
            start, name, fixed = None, None, False
    return regions


def lua_regions(text):
    """The same of a Lua file: what begins at a line's first column, up to the next that does."""
    starts = [m for m in re.finditer(r"^(?!end\b|else|[\s)}\]]|--)\S[^\n]*", text, re.M)]
    ends = [m.start() for m in starts[1:]] + [len(text)]
    named = [(LUA_NAME.match(m.group()), m.start(), end) for m, end in zip(starts, ends)]
    return [(next(g for g in name.groups() if g), start, end) for name, start, end in named if name]


def regions(path, text):
    return (lua_regions if path.endswith(".lua") else c_regions)(text)


@functools.lru_cache(maxsize=None)
def sources(tree):
    """{path: text}"""
    found = {}
    for folder in FOLDERS:
        for at, _, names in os.walk(os.path.join(tree, folder)):
            for name in sorted(names):
                if name.endswith((".c", ".h", ".lua")):
                    path = os.path.join(at, name)
                    with open(path, encoding="utf-8") as f:
                        found[path] = f.read()
    return found


@functools.lru_cache(maxsize=None)
def places(tree):
    """{place: [(path, from, to)]}; a place is NAME, FILE:NAME, or FILE."""
    found = {}
    for path, text in sources(tree).items():
        file = os.path.basename(path)
        found.setdefault(file, []).append((path, 0, len(text)))
        for name, start, end in regions(path, text):
            for place in (name, file + ":" + name):
                found.setdefault(place, []).append((path, start, end))
    return found


def pattern(old):
    """A regular expression for a text in which any white space between two tokens matches any, or none."""
    tokens = re.findall(r"\w+|[^\w\s]", old)
    out = ""
    for before, token in zip([""] + tokens, tokens):
        if out:
            out += r"\s+" if before[-1:].isalnum() and token[0].isalnum() else r"\s*"
        out += (r"\b" if not out and token[0].isalnum() else "") + re.escape(token)
    return re.compile(out + (r"\b" if tokens[-1][-1].isalnum() else ""))


def find(tree, m):
    """[(path, match)] of all places where it could be planted."""
    hits, old = {}, pattern(m.old)
    for path, start, end in places(tree).get(m.place, ()):
        for hit in old.finditer(sources(tree)[path], start, end):
            hits[path, hit.start()] = hit
    return [(path, hit) for (path, _), hit in sorted(hits.items())]


def trouble(tree, m):
    """Why it cannot be planted, or None."""
    if m.place not in places(tree):
        return "there is no %s" % m.place
    n = len(find(tree, m))
    return None if n == 1 else "its text is found %d times in %s" % (n, m.place)


def test_paths(name):
    """The tests of that name, as paths below tests/, without .c; a name may begin with its folder."""
    file = name if name.endswith(".sh") else name + ".c"
    found = [file] if "/" in name else [os.path.join(folder, file) for folder in os.listdir("tests")]
    return [os.path.splitext(f)[0] if f.endswith(".c") else f for f in found if os.path.isfile("tests/" + f)]


def main(command, path, *rest):
    mutants, wrong = read(path)
    if command == "list":
        def digest(m, salt=""):
            return hashlib.sha1((salt + m.line).encode()).hexdigest()
        if rest[:1] == ("--sample",):  # COUNT SEED: the same lines however many others the list gains or loses
            chosen = sorted(mutants, key=lambda m: digest(m, rest[2]))[:int(rest[1])]
        else:
            chosen = [m for m in mutants if not rest or any(word in m.line for word in rest)]
        for m in chosen:
            print(m.number, digest(m))
    elif command == "tests":
        for name in (name for number in rest for name in mutants[int(number) - 1].tests):
            print("\n".join(test_paths(name)))
    elif command == "check":
        wrong += ["there is no mutant in it"] if not mutants else []
        print("\n".join(wrong) if wrong else "%d mutants" % len(mutants))
        return bool(wrong)
    elif command == "plantable":
        bad = [(m, trouble(rest[0], m)) for m in mutants]
        bad = ["%d: %s: %s" % (m.number, why, m.line) for m, why in bad if why]
        bad += ["there is no one test %s" % t for t in sorted({t for m in mutants for t in m.tests})
                if len(test_paths(t)) != 1]
        print("\n".join(bad) if bad else "%d mutants can be planted" % len(mutants))
        return bool(bad)
    else:
        tree, m = rest[0], mutants[int(rest[1]) - 1]
        why = trouble(tree, m)
        if why:
            print("%s: %s" % (why, m.line))
            return True
        (path, hit), = find(tree, m)
        text = sources(tree)[path]
        with open(path, "w", encoding="utf-8") as f:
            f.write(text[:hit.start()] + m.new + text[hit.end():])
        print("%s: %s" % (os.path.relpath(path, tree), m.line))
    return False


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

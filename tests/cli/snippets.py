#!/usr/bin/env python3
"""snippets.py - takes the code blocks out of a Markdown page, so that a test can run them.

    snippets.py PAGE OUT        writes OUT/LINE.KIND (and OUT/LINE.says) for every block; LINE is where it starts
    snippets.py --cover PAGE... reads `curtain help lua` on stdin; fails when an entry is in no Lua block of the pages

KIND is what follows the three backquotes: lua (a script), lua task (the body of a task), lua wide (a
script for a field wider than the screen), lua main (main.lua), lua rom
(rom.lua), lua = PATH (the text of a file of the repository), mml (a piece of music), sh (commands), none (plain text).
Of these the next block is what is said: mml error (a piece that is refused), lua error (the body of a task that
faults), lua main error (a main.lua that faults where rom.lua gives no room), lua rom error (a rom.lua that is refused),
lua check (the body of a task in which check finds something), lua tests error (a script of tests/ that fails; lua tests
is one that holds). yaml is a file of a CI service, xml a BulletML document.
"""
import os
import re
import sys

WRONG = "lua error", "lua main error", "lua rom error", "lua check", "lua tests error", "mml error"


def blocks(page):
    kind, start, lines = None, 0, []
    for number, line in enumerate(open(page, encoding="utf-8"), 1):
        fence = re.match(r"```(.*)$", line)
        if not fence:
            if kind is not None:
                lines.append(line)
        elif kind is None:
            kind, start, lines = fence.group(1).strip() or "none", number, []
        else:
            yield start, kind, "".join(lines)
            kind = None
    if kind is not None:
        sys.exit(f"{page}:{start}: a block without an end")


def write(page, out):
    error = None
    for start, kind, text in blocks(page):
        if kind.startswith("lua = "):
            with open(os.path.join(out, f"{start}.file"), "w", encoding="utf-8") as f:
                f.write(kind[6:].strip() + "\n" + text)
            continue
        if kind in WRONG:
            error = start
        elif error is not None:
            with open(os.path.join(out, f"{error}.says"), "w", encoding="utf-8") as f:
                f.write(text)
            error = None
            continue
        name = kind.replace("lua ", "").replace(" ", "-")
        with open(os.path.join(out, f"{start}.{name}"), "w", encoding="utf-8") as f:
            f.write(text)


def cover(pages):
    lua = "".join(text for page in pages for _, kind, text in blocks(page)
                  if kind.startswith("lua") and kind not in WRONG)
    missing = []
    for line in sys.stdin:
        name = re.match(r"[a-z_]+(?:([.:])([a-z_]+))?", line)
        if not name:
            continue
        word = r":" + name.group(2) if name.group(1) == ":" else re.escape(name.group(0))
        if not re.search(r"(?<![\w.])" + word + r"\b" if name.group(1) != ":" else word + r"\b", lua):
            missing.append(name.group(0))
    for name in missing:
        print(f"no example uses {name}")
    sys.exit(bool(missing))


if sys.argv[1] == "--cover":
    cover(sys.argv[2:])
write(sys.argv[1], sys.argv[2])

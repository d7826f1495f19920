#!/usr/bin/env python3
"""from.py - looks up every Curtain name in the tables of the migration pages: from.py CURTAIN PAGE...

A table whose second column is headed Curtain has Curtain's names in the code of that column. A name with a dot or a
colon is an entry of the API, or a property or verb of the kind of thing that its letter stands for; a word by itself is
an entry, an argument, a field or a word that the API knows, a key of rom.lua or a shape; with dashes it is an option of
the program. Texts in quotes and the words of Lua are left out.
"""
import re
import subprocess
import sys

LUA = set("local function return for in do while true false nil end and or not pairs ipairs error".split())
# What stands for a value of the reader's own.
OWN = set("name list route key value f easy hard rank".split())
# The keys of rom.lua, and the shapes of a hit.
READ_HERE = ("src/workbench/pack/manifest_text.c", "src/workbench/pack/manifest_art.c",
             "src/workbench/pack/manifest_sound.c",
             "src/rom/manifest.c", "src/script/api/api_hit.c")
THINGS = {"b": "bullet", "e": "enemy", "p": "player", "l": "laser", "s": "shot"}


def asked(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


class Known:
    def __init__(self, curtain):
        self.curtain = curtain
        self.entries = set(re.findall(r"^([a-z_]+(?:[.:][a-z_]+)?)", asked(curtain, "help", "lua"), flags=re.M))
        said = asked(curtain, "help", "lua", "--annotations")
        self.words = set(re.findall(r"@(?:field|param) ([a-z_]+)|\"([a-z_]+)\"", said))
        self.words = {word for pair in self.words for word in pair if word}
        for path in READ_HERE:
            with open(path, encoding="utf-8") as f:
                self.words |= set(re.findall(r"\"(?:[a-z_]+\.)?([a-z_]+)\"", f.read()))
        self.options = set(re.findall(r"^  (--[a-z]+)", asked(curtain, "help"), flags=re.M))
        self.namespaces = {entry.split(".")[0] for entry in self.entries if "." in entry}
        self.properties = {}

    def of(self, thing):
        if thing not in self.properties:
            page = asked(self.curtain, "help", "lua", thing).partition("properties of ")[2]
            self.properties[thing] = set(re.findall(r"^    ([a-z_]+) +(?:read|write)", page, flags=re.M))
        return self.properties[thing]

    def has(self, name):
        if name.startswith("--"):
            return name in self.options
        first, mark, second = re.match(r"(\w+)(?:([.:])(\w+))?$", name).groups()
        if not mark:
            return name in self.entries | self.words | LUA | OWN | self.namespaces or len(name) == 1
        if first in self.namespaces or len(first) > 1:
            return name in self.entries
        thing = THINGS.get(first)
        return thing is not None and (f"{thing}:{second}" in self.entries or mark == "." and (
            second in self.of(thing) or second in OWN | {"power", "bombs"}))


def cells(page):
    """Page, line and text of each cell of a column that is headed Curtain."""
    ours = False
    for number, line in enumerate(open(page, encoding="utf-8"), 1):
        row = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if not row:
            ours = False
        elif row[1:2] == ["Curtain"]:
            ours = True
        elif ours and not set(row[1]) <= set("-: "):
            yield page, number, row[1]


def main():
    known, wrong, count = Known(sys.argv[1]), 0, 0
    for page, number, cell in (found for page in sys.argv[2:] for found in cells(page)):
        for code in re.findall(r"`([^`]*)`", cell):
            code = re.sub(r'"[^"]*"', "", code)
            for name in re.findall(r"--[a-z]+|[A-Za-z_]\w*(?:[.:][A-Za-z_]\w*)?", code):
                count += 1
                if name != "rom.lua" and not known.has(name):
                    wrong = 1
                    print(f"{page}:{number}: Curtain has no {name}")
    print(f"{count} names")
    return wrong or not count


sys.exit(main())

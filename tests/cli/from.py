#!/usr/bin/env python3
"""from.py - looks up the Curtain names in the tables of the migration pages: from.py CURTAIN PAGE...

A table whose second column is headed Curtain has Curtain's names in the code of that column. A name with a dot after a
table of the API is an entry of the API; a name with dashes is an option of the program.
"""
import re
import subprocess
import sys


def asked(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


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


def main(curtain, *pages):
    known = set(re.findall(r"^([a-z_]+(?:[.:][a-z_]+)?)", asked(curtain, "help", "lua"), flags=re.M))
    tables = {name.split(".")[0] for name in known if "." in name}
    known |= set(re.findall(r"^  (--[a-z]+)", asked(curtain, "help"), flags=re.M))
    wrong, count = 0, 0
    for page, number, cell in (found for page in pages for found in cells(page)):
        for code in re.findall(r"`([^`]*)`", cell):
            code = re.sub(r'"[^"]*"', "", code)
            names = re.findall(r"--[a-z]+|\b[a-z]+\.[a-z_]+", code)
            for name in names:
                if name[:2] == "--" or name.split(".")[0] in tables:
                    count += 1
                    if name not in known:
                        wrong = 1
                        print(f"{page}:{number}: Curtain has no {name}")
    print(f"{count} names")
    return wrong or not count


sys.exit(main(*sys.argv[1:]))

#!/usr/bin/env python3
"""explained.py - what docs/reference/api.md, which is the output of `curtain help lua NAME`, leaves unexplained.

    explained.py API.md             lists rows without a meaning, entries without an example or guide
    explained.py --texts API.md     prints all help sentences and meanings, one a line

An example has one to five lines of at most 96 columns. The guide's page exists.
"""
import os
import re
import sys

ROW = re.compile(r"    ([\w.]+) +(read |write)? *(.*?) ?\[([^][]*)\]$")


def blocks(text):
    """The name and the lines of every text block of the page; wrapped lines are joined."""
    text = re.sub(r"\n {15,}(?=\S)", " ", text)
    for heading, body in re.findall(r"^##+ (\S+)\n\n```\n(.*?)\n```$", text, re.S | re.M):
        yield heading, body.split("\n")


def unexplained(page, texts):
    for name, lines in blocks(page):
        properties = lines[0].startswith("properties of")
        where, example = name, None
        if len(lines) > 1 and not properties:
            texts.append(lines[1].strip())
        for line in lines[1:]:
            part, row = re.match(r"  (\w+): (.*)$", line), ROW.match(line)
            if line == "  Example:":
                example = []
            elif example is not None and line.startswith("    "):
                example.append(line[4:])
            elif line.startswith("      "):
                texts[-1] += " " + line.strip()
            elif part:
                where = "%s %s" % (name, part.group(1))
                texts.append(part.group(2))
            elif row and example is None:
                texts.append(row.group(3))
                if not row.group(3):
                    yield name, "%s: %s has no meaning" % (where, row.group(1))
        guide = re.search(r"docs/guide/\S+$", lines[-1])
        if properties:
            continue
        if not example or not guide:
            yield name, "%s has no example" % name
        elif not os.path.exists(guide.group(0)):
            yield name, "%s: there is no %s" % (name, guide.group(0))
        elif len(example) > 5 or max(map(len, example)) > 96:
            yield name, "%s: its example is longer than 5 lines of 96 columns" % name


def main(arguments):
    texts = []
    with open(arguments[-1], encoding="utf-8") as page:
        found = list(unexplained(page.read(), texts))
    if arguments[0] == "--texts":
        print("\n".join(sorted({t for t in texts if len(t) > 12})))
        return 0
    for _, what in found:
        print(what)
    return bool(found)


sys.exit(main(sys.argv[1:]))

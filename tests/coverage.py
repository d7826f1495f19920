#!/usr/bin/env python3
"""Prints how many lines of src and fb a build with --coverage has run, by directory.

    tests/coverage.py FOLDER     build/coverage; run.sh keeps each test's counters in FOLDER/results/NAME.counters

A line counts as run if any of the programs ran it. gcov works out the counts of some lines from those of others, and
after a longjmp, which Lua's errors are, such a count can be negative: it stands for a line that was run. Counters of a
program that was killed while it wrote them are left out."""

import collections
import concurrent.futures
import glob
import json
import os
import subprocess
import sys


def counters(folder):
    """The counters below results/NAME.counters, each with a link to its .gcno beside it, as gcov wants it."""
    for results in glob.glob(f"{folder}/results/*.counters"):
        for path, _, names in os.walk(results):
            if f"/{folder}/" not in path:
                continue  # of a program that a test compiles
            for name in (name for name in names if name.endswith(".gcda")):
                note = path[path.index(f"/{folder}/") + 1 :] + f"/{name[:-5]}.gcno"
                link = f"{path}/{name[:-5]}.gcno"
                if not os.path.lexists(link):
                    os.symlink(os.path.abspath(note), link)
                yield f"{path}/{name}"


def read(counter):
    gcov = subprocess.run(["gcov", "--json-format", "--stdout", counter], capture_output=True)
    return [] if gcov.stderr else [source for line in gcov.stdout.splitlines() for source in json.loads(line)["files"]]


def main(folder):
    run = collections.defaultdict(dict)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as threads:
        for sources in threads.map(read, counters(folder)):
            for source in sources:
                lines = run[os.path.normpath(source["file"])]
                for line in source["lines"]:
                    number = line["line_number"]
                    lines[number] = lines.get(number, False) or line["count"] != 0
    totals = collections.defaultdict(lambda: [0, 0])
    for source, lines in run.items():
        parts = source.split("/")
        if parts[0] not in ("src", "fb"):
            continue
        for name in ("/".join(parts[: 2 if parts[0] == "src" else 1]), "all"):
            totals[name][0] += sum(lines.values())
            totals[name][1] += len(lines)
    for name in sorted(totals, key=lambda name: (name == "all", name)):
        covered, total = totals[name]
        print(f"{name:16} {covered:6} of {total:6} lines, {100 * covered / total:5.1f} %")


if __name__ == "__main__":
    main(sys.argv[1])

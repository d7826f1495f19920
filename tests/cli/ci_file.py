#!/usr/bin/env python3
"""ci_file.py - reads a CI service's file, GitHub's or GitLab's: Curtain is built of packages that tools/deps.sh names,
and tests are run with options that there are.

    ci_file.py FILE
"""
import re
import subprocess
import sys

import yaml

def need(holds, what):
    if not holds:
        sys.exit("%s: %s" % (sys.argv[1], what))


def lines_of(file):
    """The shell commands of GitHub's or GitLab's jobs."""
    if "jobs" not in file:
        return [line for job in file.values() for line in job["before_script"] + job["script"]]
    steps = [step for job in file["jobs"].values() for step in job["steps"]]
    return [line for step in steps for line in step.get("run", "").splitlines()]


def main(path):
    with open(path, encoding="utf-8") as f:
        file = yaml.safe_load(f)
    lines = lines_of(file)
    packages = open("tools/deps.sh", encoding="utf-8").read()
    for line in lines:
        need(subprocess.run(["sh", "-nc", line], check=False).returncode == 0, "no shell: " + line)
        for package in re.findall(r"apt-get install (.*)", line):
            for name in (p for p in package.split() if not p.startswith("-")):
                need(name in ("ca-certificates", "make") or re.search(r"need [^\n]*\b%s\b" % name, packages),
                     "tools/deps.sh does not know " + name)
    need(any(re.search(r"make -C \S+ null$", line) for line in lines), "nothing is built")
    tests = [line for line in lines if "curtain-null test" in line]
    need(len(tests) == 1 and "--junit junit.xml" in tests[0], "nothing is tested")
    options = open("src/player/args/args_table.c", encoding="utf-8").read()
    for option in re.findall(r"--[a-z]+", tests[0]):
        need('"%s"' % option in options, "there is no " + option)


main(sys.argv[1])

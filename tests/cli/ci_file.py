#!/usr/bin/env python3
"""ci_file.py - reads a CI service's file, GitHub's or GitLab's, and looks whether it is one: the keys are the
service's, Curtain is built of packages that tools/deps.sh names, and tests are run with options that there are.

    ci_file.py FILE
"""
import re
import subprocess
import sys

import yaml

STEP = {"name", "uses", "with", "run", "env", "if"}
JOB = {"image", "variables", "before_script", "script", "artifacts"}


def need(holds, what):
    if not holds:
        sys.exit("%s: %s" % (sys.argv[1], what))


def github(file):
    need(set(file) == {"name", True, "jobs"}, "GitHub's keys are name, on and jobs")  # YAML 1.1 reads on as true
    need(set(file[True]) <= {"push", "pull_request"}, "no such event")
    lines = []
    for job in file["jobs"].values():
        need("runs-on" in job and job["steps"], "a job has runs-on and steps")
        for step in job["steps"]:
            need(set(step) <= STEP and ("uses" in step) != ("run" in step), "no step: %s" % step)
            need(re.match(r"actions/[a-z-]+@v\d+$", step.get("uses", "actions/x@v1")), "no action: %s" % step)
            lines += step.get("run", "").splitlines()
    return lines


def gitlab(file):
    lines = []
    for job in file.values():
        need(set(job) <= JOB, "no key of a job: %s" % sorted(set(job) - JOB))
        need(set(job["artifacts"]) <= {"when", "paths", "reports"}, "no key of artifacts")
        need(all(isinstance(line, str) for line in job["before_script"] + job["script"]), "a line that is no text")
        lines += job["before_script"] + job["script"]
    return lines


def main(path):
    with open(path, encoding="utf-8") as f:
        file = yaml.safe_load(f)
    lines = github(file) if "jobs" in file else gitlab(file)
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

#!/usr/bin/env bash
# mutants.sh - tests/mutants.list is current: what tests/mutants.sh will plant can be planted, and the tests it names
# are there. That they find it is for `make mutants`.
. "$(dirname "$0")/../tap.sh"

# Of a list: entries whose old line is not found exactly once in its file, whose new line is the old one, or which name
# a file or test that is not there.
current() {
    python3 - "$1" <<'END'
import os, sys
entries = [e for e in open(sys.argv[1], encoding="utf-8").read().split("\n\n") if not e.startswith("#")]
bad = 0
for number, entry in enumerate(entries, 1):
    lines = entry.strip("\n").split("\n")
    what = "entry %d" % number
    if len(lines) != 3 or lines[1][:2] != "- " or lines[2][:2] != "+ ":
        print("%s is not a file, a line that begins with - and one with +: %s" % (what, lines[0]))
        bad = 1
        continue
    path, *programs = lines[0].split()
    what += ", " + path
    for name in [path] + ["tests/" + (p if p.endswith(".sh") else p + ".c") for p in programs]:
        if not os.path.isfile(name):
            print("%s: there is no %s" % (what, name))
            bad = 1
    if not programs or lines[1][2:] == lines[2][2:]:
        print("%s: no test is named, or nothing is changed" % what)
        bad = 1
    found = open(path, encoding="utf-8").read().count(lines[1][2:]) if os.path.isfile(path) else 0
    if found != 1:
        print("%s: found %d times: %s" % (what, found, lines[1][2:]))
        bad = 1
print(len(entries))
sys.exit(bad or len(entries) < 1)
END
}

# planted OLD NEW: the list with this in its first entry
planted() {
    sed "0,/q -= q & 1;/s,q -= q & 1;,$1," tests/mutants.list >"$scratch/list"
    current "$scratch/list"
}

check "every fault can be planted: its line is found once" current tests/mutants.list
same_count() { [ "$(current tests/mutants.list | tail -n 1)" = "$(grep -c '^- ' tests/mutants.list)" ]; }
check "no entry is lost between two" same_count
refuse "planted: a line that is not there" "found 0 times" planted 'q -= q \& 3;'
refuse "planted: a line that is there often" "found" planted 'return'
refuse "planted: a file that is not there" "there is no src/base/fy.h" eval \
    'sed "s,src/base/fx.h ,src/base/fy.h ," tests/mutants.list >"$scratch/list"; current "$scratch/list"'
refuse "planted: a test that is not there" "there is no tests/unit/test_fy.c" eval \
    'sed "s,unit/test_fx,unit/test_fy," tests/mutants.list >"$scratch/list"; current "$scratch/list"'
finish

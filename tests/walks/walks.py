"""walks.py PROGRAM PAGE: runs PROGRAM (walks.c), and compares the functions of each walk with those that PAGE lists
under its heading ("### A bullet: ..."): each is entered, in that order, in that file, and each except the first is
called by one of the list, or by Lua or a test. Prints what is wrong, and how many more functions of ours each run
entered."""
import re
import subprocess
import sys


def entered(program):
    """{walk: [(called, caller)], in order; each is (file, function)}"""
    walks, out = {}, subprocess.run([program], capture_output=True, text=True, check=True).stdout
    for part in out.split("walk ")[1:]:
        name, *addresses = part.split()
        found = subprocess.run(["addr2line", "-s", "-f", "-e", program] + addresses, capture_output=True, text=True,
                               check=True).stdout.split("\n")
        functions = [(found[i + 1].split(":")[0], found[i]) for i in range(0, len(found) - 1, 2)]
        walks[name] = list(zip(functions[::2], functions[1::2]))
    return walks


def listed(page):
    """{walk: [(path, function)], in order}"""
    walks, name = {}, None
    with open(page, encoding="utf-8") as f:
        for line in f:
            heading = re.match(r"###? (?:An? (\w+):)?", line)
            if heading:
                name = heading[1] and heading[1].lower()
            item = re.match(r"\* `([\w./]+)`: (.*)", line)
            if name and item:
                walks.setdefault(name, []).extend((item[1], f) for f in re.findall(r"`(\w+)`", item[2]))
    return walks


def is_ours(function):
    return function[0] not in ("??", "walks.c", "rig.h")


def main(program, page):
    runs, lists, wrong = entered(program), listed(page), []
    if set(runs) != set(lists):
        wrong.append("walks of the program: %s; of the page: %s" % (sorted(runs), sorted(lists)))
    for name in sorted(set(runs) & set(lists)):
        at = {called: i for i, (called, _) in reversed(list(enumerate(runs[name])))}
        names = [(path.split("/")[-1], function) for path, function in lists[name]]
        last = -1
        for n, (path, function) in enumerate(lists[name]):
            here = at.get(names[n])
            if here is None:
                wrong.append("%s: %s of %s is not entered" % (name, function, path))
            elif here < last:
                wrong.append("%s: %s is entered earlier than what stands before it" % (name, function))
            elif n and is_ours(runs[name][here][1]) and runs[name][here][1] not in names:
                wrong.append("%s: %s is called by %s of %s, which is missing" % (
                    (name, function) + runs[name][here][1][::-1]))
            last = max(last, here or 0)
        ours = [called[0] for called, _ in runs[name] if is_ours(called)]
        print("%s: %d functions in %d files listed; %d in %d files entered" % (
            name, len(lists[name]), len({p for p, _ in lists[name]}), len(ours), len(set(ours))))
    print("\n".join(wrong) if wrong else "every walk is as the page says")
    return 1 if wrong or not runs else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))

"""names.py FILE...: every public function of the headers has a prefix that says where it is from: the name of its
header or the first word of that, the header's folder, or a struct or enum that the same header declares. Those that
have none are listed in NO_PREFIX with the reason. And no function of the C files has more than 100 lines."""
import os
import re
import sys

NO_PREFIX = {
    "plat_": "the seam to a port",
    "program_": "the program, for ports whose host has the loop",
    "snd_": "src/sound",
    "int64_": "int.h's functions of the wider type",
    "luaerror_ luapattern_ luatable_ luatext_ luautf8_ luamath_": "luaparts.h says what each file of the library gives",
    "board_eval board_set_profile": "operations on a board, in headers of their own",
}
LISTED = tuple(" ".join(NO_PREFIX).split())
LONGEST = 100  # lines of a function
COMMENT = re.compile(r"/\*.*?\*/", re.S)
DECLARED = re.compile(
    r"^(?:static inline )?(?!typedef|static|extern|return|struct \w+ \{|#)[a-z][\w ]*?[ *]+(\w+)\(", re.M)
TYPE = re.compile(r"^(?:struct|enum) (\w+) \{", re.M)


def prefixes(path, text):
    """What a public name of this header may begin with."""
    stem = os.path.basename(path)[:-2]
    own = {stem, stem.split("_")[0], os.path.basename(os.path.dirname(path)).rstrip("s")}
    return own | {t for t in TYPE.findall(text)} | {t + "s" for t in TYPE.findall(text)}


def check(path):
    with open(path, encoding="utf-8") as f:
        text = COMMENT.sub("", f.read())
    own = prefixes(path, text)
    return ["%s: %s" % (path, name) for name in DECLARED.findall(text)
            if not name.startswith(LISTED) and not any(name == p or name.startswith(p + "_") for p in own)]


def long_functions(path):
    """Functions of a C file with more lines than LONGEST, as clang-format leaves them: a brace at the line's start."""
    found, start = [], 0
    with open(path, encoding="utf-8") as f:
        for number, line in enumerate(f, 1):
            if line == "{\n":
                start = number
            elif line == "}\n" and start:
                if number - start > LONGEST:
                    found.append("%s:%d: a function of %d lines; one has %d at most" %
                                 (path, start, number - start, LONGEST))
                start = 0
    return found


def main(paths):
    headers = [p for p in paths if p.endswith(".h")]
    found = [line for path in headers for line in check(path)]
    found += [line for path in paths for line in long_functions(path)]
    count = sum(len(DECLARED.findall(COMMENT.sub("", open(p, encoding="utf-8").read()))) for p in headers)
    print("\n".join(found) if found else "%d public functions" % count)
    return 1 if found or not count else 0


sys.exit(main(sys.argv[1:]))

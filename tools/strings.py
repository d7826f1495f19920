#!/usr/bin/env python3
"""Lists the text of the program's screens that games can translate, one string per line as in a language file.

    tools/strings.py            prints the list
    tools/strings.py --write    writes it to src/workbench/check/program_text.c

A string is a literal in the files below that starts with a capital, a conversion or a digit and contains a word.
Phrases of the tables of settings and keys are shown as sentences. Numbers are %d, as in screen_words.c.
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCREENS = ["src/player/screens/*.c", "src/player/play/screen_*.c", "src/player/play/practice.c",
           "src/player/play/play_practice.c"]
TABLES = ["src/player/settings/config.c", "src/player/input/keys.c"]
LIST = "src/workbench/check/program_text.c"

LITERAL = r'"((?:[^"\\\n]|\\.)*)"'
ANY = LITERAL.replace("((", "(?:(")
# A string is one or several literals.
STRING = re.compile(r"%s(?:\s*(?:PRI\w+\s*)?%s)*" % (ANY, ANY))
# Comments, and calls whose text is for a file or a terminal.
SKIPPED = re.compile(r"/\*.*?\*/|^#.*?$|\b(?:err_set|play_log|strn?cmp)\((?:[^;\"]|%s)*;"
                     % ANY, re.S | re.M)
# Calls with a format for the player.
FORMATTED = re.compile(r"\b(?:screens_format|screens_show_message|play_show_message|play_warn|show)\((?:[^;\"]|%s)*;"
                       % ANY)
CONVERSION = re.compile(r"%[-+ 0]*\d*(?:\.\d+)?(?:l|ll|z|h)?[duix]|(?<![A-Za-z])\d+")
ESCAPES = {"n": "\n", '"': '"', "\\": "\\"}


def decode(literals):
    """The text of a string of the source, with %d for numbers."""
    text = "".join(re.findall(LITERAL, re.sub(r'"\s*PRI[du]\d+\s*"', "d", literals)))
    return CONVERSION.sub("%d", re.sub(r"\\(.)", lambda m: ESCAPES.get(m[1], " "), text))


def strings(source):
    return [decode(m[0]) for m in STRING.finditer(source)]


def sources(patterns):
    for path in (path for pattern in patterns for path in sorted(ROOT.glob(pattern))):
        yield SKIPPED.sub("", path.read_text(encoding="utf-8"))


def sentence(phrase):
    return phrase[:1].upper() + phrase[1:] + "."


def is_shown(text):
    return re.fullmatch("%d [a-z]+", text) or (re.match("[A-Z%].*[^ ]$", text, re.S) and "pad." not in text and
                                               re.search("[A-Za-z]{2}", re.sub("%[ds]", "", text)))


def collect():
    found = set()
    for source in sources(SCREENS):
        for text in strings(source):
            # text of several lines is translated line by line, unless it is a format
            found.update([text] if "%s" in text else text.split("\n"))
    for source in sources(["src/player/*/*.c"]):
        for call in FORMATTED.findall(source):
            found.update(strings(call))
    for source in sources(["src/player/input/input_code.c"]): # buttons that are named by their places
        found.update(filter(re.compile("[A-Z][a-zA-Z-]+( [a-z]+)+").fullmatch, strings(source)))
    for source in sources(TABLES):
        for row in re.findall(r"\{((?:[^{}\";]|%s)*)\}" % ANY, source):
            texts = strings(row)
            if len(texts) > 6 or (texts and re.match("p%d", texts[0]) and '"p1.' not in row):
                continue
            # { name, label, group or inputs, .., help, unit, zero }; other tables have the labels of values
            if len(texts) > 3 and re.match("[a-z].*[A-Z]", texts[0] + texts[1]):
                found.update(texts[1:3] + [sentence(texts[3])] * (texts[3] != ""))
                found.update("%d" + text if text[0] == " " else text for text in texts[4:])
            else:
                found.update(texts)
    return sorted(filter(is_shown, found))


def main():
    texts = collect()
    if "--write" not in sys.argv[1:]:
        for text in texts:
            print(re.sub(r"^#", r"\#", text.replace("\\", "\\\\").replace("=", "\\=")).replace("\n", "\\n"))
        return
    rows = "".join('"%s",\n' % t.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") for t in texts)
    path = ROOT / LIST
    source = path.read_text(encoding="utf-8")
    path.write_text(re.sub(r"(/\* the list \*/\n).*?(\};)", lambda m: m[1] + rows + m[2], source, count=1, flags=re.S),
                    encoding="utf-8")
    subprocess.run(["clang-format", "-i", str(path)], check=True)


if __name__ == "__main__":
    main()

#!/usr/bin/env bash
# japanese.sh - roms/glasstide in Japanese: the file has words for all that the standard library's screens and the game
# show, all of them in katakana, and none is wider than the row it stands in.
. "$(dirname "$0")/../tap.sh"

cat >"$scratch/words.py" <<'PY'
import glob, re, sys
lines = [l.rstrip("\n") for l in open(sys.argv[1], encoding="utf-8")]
words = dict(l.split(" = ", 1) for l in lines if l and l[0] != "#")
found = []
shown = {}  # text: cells it may have
for path in glob.glob("scripts/**/*.lua", recursive=True):
    for text in re.findall(r'"([^"\n]*[A-Z]{2}[^"\n]*)"', re.sub(r"sys\.fail\(.*", "", open(path).read())):
        if not re.search("[a-z]", re.sub("%[0-9]*[ds]", "", text)) and text != "HI ":  # the hud's, in every language
            shown[text] = 30
for path in glob.glob("roms/glasstide/**/*.lua", recursive=True):
    code = re.sub("--.*", "", open(path).read())
    for text in re.findall(r'"([A-Z][^"]+)"', code if not path.endswith("rom.lua") else ""):
        shown[text] = 80  # sentences and names: they are broken into rows
for path in glob.glob("roms/glasstide/stages/**/*.lua", recursive=True):
    for text in re.findall(r'(?:title|spell) = "([^"]*)"', open(path).read()):
        shown[text] = 28
    for text in re.findall(r'(?:talk\.def\("\w+", \{ name =|say\([\w"]+,) "([^"]*)"', open(path).read()):
        shown[text] = 3 * 26  # a page of a talk
for path in glob.glob("roms/glasstide/fx/*.lua"):
    for name in re.findall(r'\{ name = "(\w+)", show', open(path).read()):
        shown[name.upper().replace("_", " ")] = 26  # a page of the title's list
rom = open("roms/glasstide/rom.lua", encoding="utf-8").read()
for name in re.findall(r'"(\w+)"', re.search(r"difficulties = {([^}]*)}", rom)[1]):
    shown[name.upper()] = 26
main = open("roms/glasstide/main.lua").read()
for part in re.findall(r"(?:stages|players) = {([^}]*)}", main):
    for name in re.findall(r'"(\w+)"', part):
        shown[name.upper()] = 26
for name in re.findall(r'{ name = "(\w+)", stages', main):
    shown[name.upper()] = 26
for path in ["opening", "ending"]:  # a row each, whatever it begins with
    for lines in re.findall(r"lines = {([^}]*)}", open("roms/glasstide/%s.lua" % path).read()):
        for text in re.findall(r'"([^"]*)"', lines):
            shown[text] = 28
for part in re.findall(r"staff = {(.*)} }", main, re.S):
    for text in re.findall(r'"([^"]*)"', part):
        shown[text] = 30
for text in re.findall(r'hint = "([^"]*)"', open("roms/glasstide/unlocks.lua").read()):
    shown[text] = 80
for kind in re.findall(r'kind = "(\w+)"', open("roms/glasstide/players/forms.lua").read()):
    shown[kind.replace("_", " ").upper()] = 26
scoring = open("roms/glasstide/scoring.lua").read()
for name in re.findall(r'(\w+) = {[^}]*show = "(?:bar|number|icons)"', scoring):
    shown[name.upper()] = 12
number = lambda m: "0" * int(m[1] or 1)
for text, most in sorted(shown.items()):
    row = re.sub(r"%0?(\d*)d", number, words.get(text, "")).replace("%s", words["STAGE %s"].replace("%s", "1"))
    if not row:
        found.append('no words for "%s"' % text)
    elif len(row) > most:
        found.append('%d cells for "%s": %s' % (len(row), text, row))
    elif re.search(r"[a-zA-Z]", re.sub(r"%\w+", "", words[text])):
        found.append('Latin letters for "%s": %s' % (text, words[text]))
found += ['nothing shows "%s"' % text for text in words if text not in shown]
print("\n".join(found) or "%d texts" % len(shown))
sys.exit(bool(found) or not shown)
PY
ja=roms/glasstide/lang/ja.txt
check 'each text has words that fit' python3 "$scratch/words.py" $ja
sed '/^PAUSE /d' $ja >"$scratch/ja.txt"
detects 'a text without words' 'no words for "PAUSE"' python3 "$scratch/words.py" "$scratch/ja.txt"
finish

#!/usr/bin/env bash
# japanese.sh - roms/glasstide in Japanese: the file has words for the texts of the standard library's screens and of
# the game, all of them in katakana, and none is wider than its row.
. "$(dirname "$0")/../tap.sh"

cat >"$scratch/words.py" <<'PY'
import glob, re, sys

GAME = "roms/glasstide/"
# Files, a pattern for the texts that they show, and the cells a text may have.
SHOWN = [
    ("scripts/**/*.lua", r'"((?:%[0-9]*[ds]|[^"\na-z])*[A-Z]{2}(?:%[0-9]*[ds]|[^"\na-z])*)"', 30),
    (GAME + "**/*.lua", r'"([A-Z][^"]+)"', 80),  # sentences and names are broken into rows
    (GAME + "stages/**/*.lua", r'(?:title|spell) = "([^"]*)"', 28),
    (GAME + "stages/**/*.lua", r'(?:talk\.def\("\w+", \{ name =|say\([\w"]+,) "([^"]*)"', 3 * 26),
]
# Names, which are shown in capitals.
NAMES = [
    (GAME + "fx/*.lua", r'\{ name = "(\w+)", show', 26),
    (GAME + "scoring.lua", r'(\w+) = {[^}]*show = "(?:bar|number|icons)"', 12),
]
CODE = re.compile(r"--.*|sys\.fail\(.*")
lines = [line.rstrip("\n") for line in open(sys.argv[1], encoding="utf-8")]
words = dict(line.split(" = ", 1) for line in lines if line and line[0] != "#")
shown = {}
for pattern, text, cells in SHOWN + NAMES:
    for path in set(glob.glob(pattern, recursive=True)) - {GAME + "rom.lua"}:
        for found in re.findall(text, CODE.sub("", open(path, encoding="utf-8").read())):
            capitals = (pattern, text, cells) in NAMES
            shown[found.upper().replace("_", " ") if capitals else found] = cells
shown.pop("HI ", None)  # the hud's, in every language
found = [f'no words for "{text}"' for text in sorted(shown) if text not in words]
for text, row in words.items():
    row = re.sub(r"%0?(\d*)d", lambda m: "0" * int(m[1] or 1), row)
    if len(row) > shown.get(text, 30):
        found.append(f'{len(row)} cells for "{text}": {row}')
    if re.search("[a-zA-Z]", row.replace("%s", "")):
        found.append(f'Latin letters for "{text}": {row}')
print("\n".join(found) or "%d texts" % len(shown))
sys.exit(bool(found) or not shown)
PY
ja=roms/glasstide/lang/ja.txt
check 'each text has words that fit' python3 "$scratch/words.py" $ja
sed '/^PAUSE /d' $ja >"$scratch/ja.txt"
detects 'a text without words' 'no words for "PAUSE"' python3 "$scratch/words.py" "$scratch/ja.txt"
finish

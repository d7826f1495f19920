#!/usr/bin/env bash
# japanese.sh - roms/glasstide in Japanese: lang/ja.txt translates the text of the standard library's screens, of the
# game, and of the program's screens, and no translation is wider than its row; check.sh looks for missing characters.
. "$(dirname "$0")/../tap.sh"

cat >"$scratch/words.py" <<'PY'
import glob, re, subprocess, sys

GAME = "roms/glasstide/"
# Files, a pattern for the texts that they show, and the cells a text may have.
SHOWN = [
    ("scripts/**/*.lua", r'"((?:%[0-9]*[ds] )*[A-Z][^"]+)"', 30),
    (GAME + "**/*.lua", r'"([A-Z][^"]+)"', 80),  # sentences and names are broken into rows
    (GAME + "stages/**/*.lua", r'(?:title|spell) = "([^"]*)"', 28),
    (GAME + "stages/**/*.lua", r'(?:talk\.def\("\w+", \{ name =|say\([\w"]+,) "([^"]*)"', 3 * 26),
]
# Names that the HUD shows in capitals.
NAMES = [(GAME + "scoring.lua", r'(\w+) = {[^}]*show = "(?:bar|number|icons)"', 12)]
CODE = re.compile(r"--.*|(?:sys\.)?fail\(.*|\"NaN\"")
HELP = 80  # characters of the program's sentences; a screen has 255 bytes for them
lines = [line.rstrip("\n") for line in open(sys.argv[1], encoding="utf-8")]
words = dict(line.split(" = ", 1) for line in lines if line and line[0] != "#")
shown = {}
for pattern, text, cells in SHOWN + NAMES:
    for path in set(glob.glob(pattern, recursive=True)) - {GAME + "rom.lua"}:
        for found in re.findall(text, CODE.sub("", open(path, encoding="utf-8").read())):
            capitals = (pattern, text, cells) in NAMES
            shown[found.upper().replace("_", " ") if capitals else found] = cells
shown.pop("HI ", None)  # the hud's, in every language
program = subprocess.run(["tools/strings.py"], check=True, capture_output=True, text=True).stdout.splitlines()
shown = {**{text: HELP for text in program}, **shown}
found = [f'no words for "{text}"' for text in sorted(shown) if text not in words]
for text, row in words.items():
    width = len(re.sub(r"%0?(\d*)d", lambda m: "0" * int(m[1] or 1), row))
    if width > shown.get(text, 30):
        found.append(f'{width} cells for "{text}": {row}')
    if set(re.findall("[A-Za-z]+", row)) - set(re.findall("[A-Za-z]+", text)):
        found.append(f'Latin letters for "{text}": {row}')
    if re.findall("%.?", re.sub(r"%[0-9]+d", "%d", text)) != re.findall("%.?", re.sub(r"%[0-9]+d", "%d", row)) \
            and text in program and "%s" in text:
        found.append(f'other arguments for "{text}": {row}')
print("\n".join(found) or "%d texts" % len(shown))
sys.exit(bool(found) or not shown)
PY
ja=roms/glasstide/lang/ja.txt
check 'each text has words that fit' python3 "$scratch/words.py" $ja
sed '/^Ready /d' $ja >"$scratch/ja.txt"
detects "a text of the game without words" 'no words for "Ready"' python3 "$scratch/words.py" "$scratch/ja.txt"
sed '/^Key Bindings /d' $ja >"$scratch/ja.txt"
detects "a text of the program without words" 'no words for "Key Bindings"' \
    python3 "$scratch/words.py" "$scratch/ja.txt"
finish

#!/usr/bin/env python3
"""Writes docs/measured/patterns.md: the patterns of Glass Tide, stage by stage, with text and pictures. The order is
that of the complete games in tests/demos/glasstide. The text is a phase's `text`, or the comment above its function.
The pictures, in docs/images/patterns, show the frames with the most objects, on normal and abyss."""
import glob
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "..", "..", "tests", "golden"))
import png  # noqa: E402

OUT = os.environ.get("OUT", "build/release")
CURTAIN = os.environ.get("CURTAIN", "build/curtain-null")
GAME, DEMOS, IMAGES = "roms/glasstide", "tests/demos/glasstide", "docs/images/patterns"
SHOWN = ["normal", "abyss"]
SCALE = 2


# ---- text ----

def sources():
    return {path: open(path, encoding="utf-8").read() for path in sorted(glob.glob(GAME + "/**/*.lua", recursive=True))}


def sentence(lines):
    text = " ".join(line.strip().lstrip("-").strip() for line in lines)
    return text[:1].upper() + text[1:] if text else ""


def above(text, at):
    """The comment that ends in the line above `at`."""
    lines = text[:at].split("\n")[:-1]
    found = []
    while lines and lines[-1].lstrip().startswith("--"):
        found.insert(0, lines.pop())
    return sentence(found)


def of_function(files, path, name):
    """The comment above a function, of the phase's own file if there is one."""
    plain = name.split(".")[-1]
    pattern = re.compile(r"^[ \t]*(?:local )?function (?:\w+[.:])?%s *\(|^[ \t]*(?:local )?(?:\w+\.)?%s *= *function" %
                         (re.escape(plain), re.escape(plain)), re.M)
    for other in [path] + sorted(files, key=lambda f: os.path.dirname(f) != os.path.dirname(path)):
        found = pattern.search(files[other])
        if found:
            return above(files[other], found.start())
    return ""


def table_at(text, at):
    """The Lua table that begins at `at`, with its braces; quoted strings are skipped."""
    depth, i, quote = 0, at, ""
    while i < len(text):
        c = text[i]
        if quote:
            i += c == "\\"
            quote = "" if c == quote else quote
        elif c in "\"'":
            quote = c
        elif text.startswith("--", i):
            i = text.find("\n", i)
        depth += not quote and c == "{"
        depth -= not quote and c == "}"
        i += 1
        if depth == 0:
            break
    return text[at:i]


def numbered(text):
    """Comments in a boss's file that begin with a phase number: `-- 3. Rings bounce off the walls`."""
    found = {}
    for one in re.finditer(r"^-- (\d+)\. .*(?:\n--.*)*", text, re.M):
        found.setdefault(int(one[1]), sentence([line for line in one[0].split("\n")]))
    return {n: words.split(". ", 1)[1] for n, words in found.items()}


def phases(files):
    """BOSS/PHASE: (the boss's title, spell or "", text)."""
    found = {}
    for path, text in files.items():
        for boss in re.finditer(r'boss\.(?:def|cast)\("(\w+)"\s*,\s*', text):
            body = table_at(text, text.index("{", boss.start()))
            title = re.search(r'title *= *"([^"]*)"', body)
            beside = {}
            for other in files: # a long boss has several files
                if other != path and os.path.dirname(other) == os.path.dirname(path):
                    beside.update(numbered(files[other]))
            first = not re.search(r"boss\.(?:def|cast)\(", text[:boss.start()])
            beside = {**beside, **numbered(text)} if first else {} # numbers belong to the first boss in the file
            for n, one in enumerate(re.finditer(r'\{ *id *= *"(\w+)"', body), 1):
                phase = table_at(body, one.start())
                spell, said = re.search(r'spell *= *"([^"]*)"', phase), re.search(r'\btext *= *"([^"]*)"', phase)
                run = re.search(r"run *= *(.*?)(?=, *\w+ *=|\}\s*$)", phase, re.S)
                names = re.findall(r"[A-Za-z_][\w.]*", run[1]) if run else []
                words = [said[1]] if said else [w for w in (of_function(files, path, f) for f in names) if w]
                if not said and n in beside:
                    words = [beside[n]]
                words = [re.sub(r"^\d+\. ", "", w) for w in words]
                found["%s/%s" % (boss[1], one[1])] = (title[1] if title else boss[1].title(), spell[1] if spell else "",
                                                      " ".join(dict.fromkeys(words)))
    return found


def marks(files, stage):
    """The text for each mark of a stage: its comment, or that of the next function called."""
    said = {}
    for path, text in files.items():
        if not re.search(r'stage\.def\("%s"' % stage, text):
            continue
        for mark in re.finditer(r'stage\.mark\("(\w+)"\)', text):
            words = above(text, mark.start())
            for name in re.findall(r"^\s*([a-z_]\w*)\(", text[mark.end():].split("stage.mark")[0], re.M):
                words = words or of_function(files, path, name)
            said[mark[1]] = words
        first = re.search(r'stage\.def\("%s"' % stage, text)
        head = text[first.end():].split("stage.mark")[0]
        for name in re.findall(r"^\s*([a-z_]\w*)\(", head, re.M):
            said[""] = said.get("") or of_function(files, path, name)
    return said


# ---- pictures ----

def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def small_png(source, target):
    """Scales a frame up and writes it with a minimal palette; repeated lines become zeros."""
    w, h, rows = png.read(source)
    colours = {}
    lines = []
    for row in rows:
        line = bytearray()
        for x in range(w):
            line += bytes([colours.setdefault(bytes(row[3 * x:3 * x + 3]), len(colours))]) * SCALE
        lines.append(bytes(line))
    raw = b"".join(b"\0" + line + (b"\2" + bytes(len(line))) * (SCALE - 1) for line in lines)
    data = b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", w * SCALE, h * SCALE, 8, 3, 0, 0, 0))
    data += chunk(b"PLTE", b"".join(colours)) + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b"")
    open(target, "wb").write(data)


def lively(demo):
    """[(kind, name, frame)] in the order of the run, without parts that fire nothing; stages always stay."""
    said = subprocess.run([OUT + "/lively", GAME, demo], capture_output=True, text=True, check=True).stdout
    return [(kind, name, int(frame)) for kind, name, frame, most, *_ in map(str.split, said.splitlines())
            if int(most) or kind == "stage"]


def draw(demo, frames, names):
    """Renders frames of a demo as docs/images/patterns/NAME.png."""
    folder = tempfile.mkdtemp()
    subprocess.run([CURTAIN, "render", GAME, "--demo", demo, "-o", folder, "--frames",
                    ",".join(map(str, sorted(set(frames))))], check=True, stdout=subprocess.DEVNULL)
    for frame, name in zip(frames, names):
        small_png("%s/%06d.png" % (folder, frame), "%s/%s.png" % (IMAGES, name))
    shutil.rmtree(folder)


def file_name(stage, kind, name, difficulty):
    return "%s-%s-%s" % (stage, (name or "first").replace("/", "-") if kind != "stage" else "first", difficulty)


def parts(demo):
    """{(stage, kind, name): frame}, with the first frame of each."""
    found, stage = {}, ""
    for kind, name, frame in lively(demo):
        stage = name if kind == "stage" else stage
        found.setdefault((stage, kind, name), frame)
    return found


# ---- the page ----

def best_games():
    """The complete game of each difficulty shown. The page shows only the patterns these games meet."""
    return {d: "%s/clear-%s.demo" % (DEMOS, d) for d in SHOWN if os.path.exists("%s/clear-%s.demo" % (DEMOS, d))}


def pictures(stage, kind, name, shown):
    return " ".join("![%s, %s](../images/patterns/%s.png)" % (name or stage, d, file_name(stage, kind, name, d))
                    for d in shown)


def page(files, games):
    met = {d: parts(demo) for d, demo in games.items()}
    order = list(dict.fromkeys(key for found in met.values() for key in found))
    told, n = phases(files), 0
    stages = list(dict.fromkeys(key[0] for key in order))
    yield """# Patterns of Glass Tide

`make patterns` writes this page, which shows the patterns of *Glass Tide* stage by stage, in the order of play. Each
pattern has a description from the script and two pictures: one on normal and one on abyss. Each picture shows the frame
of the pattern with the most objects. The pictures come from recordings of complete games in `tests/demos/glasstide`,
played by an invincible bot. The [cookbook](../cookbook.md) shows how to write patterns.
"""
    yield subprocess.check_output("tools/docs/measured.sh", text=True)
    for stage in stages:
        yield "\n## %s\n" % stage.title()
        said, boss = marks(files, stage), ""
        for key in (key for key in order if key[0] == stage):
            _, kind, name = key
            shown = [d for d in games if key in met[d]]
            if kind == "phase":
                title, spell, words = told.get(name, (name.split("/")[0].title(), "", ""))
                if boss != title:
                    boss = title
                    yield "\n### %s\n" % title
                yield "**%s** (`%s`)%s\n" % (spell or name.split("/")[1].title(), name, ": " + words if words else "")
            elif name in (key[2].split("/")[0] for key in order if key[1] == "phase"):
                continue # the mark of a boss; its phases follow
            else:
                words = said.get("" if kind == "stage" else name, "")
                head = "First waves" if kind == "stage" else name.title()
                yield "**%s**%s\n" % (head, ": " + words if words else "")
            yield pictures(stage, kind, name, shown) + "\n"
            n += 1
    yield "\n%d patterns." % n
    for d, demo in games.items():
        draw(demo, list(met[d].values()), [file_name(*key, d) for key in met[d]])


def main():
    shutil.rmtree(IMAGES, ignore_errors=True)
    os.makedirs(IMAGES)
    files, games = sources(), best_games()
    text = "\n".join(page(files, games))
    for name in os.listdir(IMAGES): # pictures that the page does not show
        if "images/patterns/%s)" % name not in text:
            os.remove(os.path.join(IMAGES, name))
    with open("docs/measured/patterns.md", "w", encoding="utf-8") as f:
        f.write(re.sub(r"\n{3,}", "\n\n", text) + "\n")
    total = sum(os.path.getsize(os.path.join(IMAGES, name)) for name in os.listdir(IMAGES))
    last = text.splitlines()[-1]
    print("docs/measured/patterns.md: %s, %d pictures, %d kB" % (last, len(os.listdir(IMAGES)), total // 1000))


if __name__ == "__main__":
    main()

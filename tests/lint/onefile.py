#!/usr/bin/env python3
"""onefile.py - reads what make docs wrote, and says what does not hold: onefile.py FILE [ROOT]

Tags are closed; ids are there once; every link within the file leads to one; nothing is fetched from elsewhere;
pictures are whole. Each page of the repository is in it with all its headings and blocks of code, which are counted in
the Markdown by rules of this program's own.
"""
import base64
import glob
import os
import re
import sys
from html.parser import HTMLParser

VOID = {"meta", "link", "img", "br", "hr", "input"}


class Reader(HTMLParser):
    def __init__(self):
        super().__init__()
        self.open, self.ids, self.links, self.wrong = [], [], [], []
        self.pages, self.pictures = {}, 0

    def say(self, what):
        self.wrong.append(f"line {self.getpos()[0]}: {what}")

    def handle_starttag(self, tag, attributes):
        at = dict(attributes)
        if tag not in VOID:
            self.open.append(tag)
        if at.get("id"):
            self.ids.append(at["id"])
        if tag == "article":
            self.pages[at["data-file"]] = {"headings": 0, "blocks": 0, "id": at["id"]}
        elif self.pages and (re.fullmatch("h[1-6]", tag) or tag == "pre"):
            list(self.pages.values())[-1]["blocks" if tag == "pre" else "headings"] += 1
        if tag == "a":
            self.links.append(at.get("href") or "")
        if at.get("src") is not None:
            self.picture(tag, at["src"])
        if tag == "link" and at["href"][:5] != "data:":
            self.say(f"<{tag}> fetches {at['href']}")

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.say(f"</{tag}> ends what is not open")

    def picture(self, tag, src):
        self.pictures += 1
        head, _, data = src.partition(";base64,")
        whole = {"data:image/png": (b"\x89PNG", b"IEND\xaeB`\x82"), "data:image/svg+xml": (b"<svg", b"</svg>")}
        if head not in whole:
            self.say(f"<{tag}> fetches {src[:60]}")
            return
        data = base64.b64decode(data).strip()
        if not (data.startswith(whole[head][0]) and data.endswith(whole[head][1])):
            self.say("a picture is not whole")


def written(path):
    """Headings and blocks of a Markdown page, and its pictures."""
    headings = blocks = pictures = 0
    inside = False
    for line in open(path, encoding="utf-8"):
        if re.match(r" *```", line):
            inside = not inside
            blocks += inside
        elif not inside:
            headings += bool(re.match(r"#{1,6} ", line))
            pictures += len(re.findall(r"<img |!\[", re.sub(r"`[^`]*`", "", line)))
    return headings, blocks, pictures


def main():
    root = sys.argv[2] if len(sys.argv) > 2 else "."
    text = open(sys.argv[1], encoding="utf-8").read()
    reader = Reader()
    reader.feed(text)
    reader.close()
    wrong = reader.wrong + [f"<{tag}> is not closed" for tag in reader.open]
    known = set(reader.ids)
    wrong += [f'the id "{i}" is there twice' for i in sorted(known) if reader.ids.count(i) > 1]
    wrong += [f'a link to "{link}", which is not there' for link in sorted(set(reader.links))
              if not re.match("https?:", link) and (link[:1] != "#" or link[1:] not in known)]
    wrong += [f"the style fetches {url}" for url in re.findall(r"url\((?!data:)[^)]*\)|@import[^;]*", text)]
    pictures = 0
    pages = sorted(glob.glob("docs/**/*.md", recursive=True, root_dir=root))
    for path in ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"] + pages:
        page = reader.pages.get(path)
        if not page:
            wrong.append(f"{path} is not in it")
            continue
        headings, blocks, images = written(os.path.join(root, path))
        pictures += images
        if page["headings"] != headings:
            wrong.append(f"{path}: {headings} headings, and {page['headings']} in the file")
        # Text that is indented by four blanks is a block too.
        if page["blocks"] < blocks:
            wrong.append(f"{path}: {blocks} blocks of code, and {page['blocks']} in the file")
    if reader.pictures != pictures:
        wrong.append(f"{pictures} pictures, and {reader.pictures} in the file")
    found = f"{len(reader.pages)} pages, {len(known)} ids, {len(reader.links)} links, {pictures} pictures"
    print("\n".join(wrong) or found)
    return 1 if wrong or len(known) < 500 or len(reader.links) < 1000 else 0


sys.exit(main())

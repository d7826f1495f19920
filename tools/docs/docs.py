#!/usr/bin/env python3
"""docs.py - README and all pages of docs/ as one HTML file that needs nothing else: make docs.

    docs.py [--root DIR] -o FILE

Pictures are in it, links between pages lead to places in the file, and what is searched is the file itself. A link to
a page, a section or a file that is not there is an error, with its place; so is a picture. Files of the source that
pages name are no links in it, for whoever reads it may not have the source.

Markdown is read by markdown-it (CommonMark, and tables), code is coloured by Pygments.
"""
import argparse
import base64
import os
import posixpath
import re
import sys
from html import escape

from markdown_it import MarkdownIt
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import get_lexer_by_name

HERE = os.path.dirname(os.path.abspath(__file__))
# A group is a title and its pages, in order; a folder stands for all of its pages by name.
GROUPS = [
    ("Start", ["README.md", "docs/README.md", "docs/tutorial"]),
    ("Guide", ["docs/guide"]),
    ("Reference", ["docs/reference", "docs/cookbook.md"]),
    ("Internals", ["CONTRIBUTING.md", "docs/internals", "CHANGELOG.md", "LICENSE"]),
    ("Measured", ["docs/measured"]),
]
NAMES = {"README.md": "Curtain", "docs/README.md": "Contents", "LICENSE": "Licence",
         "docs/measured/proof.txt": "Proofs"}
TYPES = {".png": "image/png", ".svg": "image/svg+xml", ".gif": "image/gif"}
LEXERS = {"lua": "lua", "c": "c", "sh": "bash", "make": "make"}


def slug(text, seen):
    """The anchor of a heading, as the pages' links write it: that of GitHub."""
    text = re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")
    seen[text] = seen.get(text, -1) + 1
    return f"{text}-{seen[text]}" if seen[text] else text


class Wrong(Exception):
    pass


class Page:
    """A Markdown page, or a plain text, of the repository: its words, and the anchors of its headings."""

    def __init__(self, root, path):
        self.root, self.path = root, path
        self.id = re.sub("^docs/(?!readme)", "", os.path.splitext(path)[0].lower()).replace("/", "-")
        with open(os.path.join(root, path), encoding="utf-8") as f:
            self.text = f.read()
        self.name = NAMES.get(path)
        self.headings = []  # (level, anchor, words)
        self.tokens = []
        if path.endswith(".md"):
            self.tokens = MarkdownIt("commonmark", {"html": True}).enable("table").parse(self.text)
        self.find_headings()
        self.name = self.name or (self.headings[0][2] if self.headings else posixpath.basename(path))

    def find_headings(self):
        seen = {}
        for i, token in enumerate(self.tokens):
            if token.type == "heading_open":
                words = "".join(c.content for c in self.tokens[i + 1].children if c.type in ("text", "code_inline"))
                token.meta["anchor"] = slug(words, seen)
                self.headings.append((int(token.tag[1]), token.meta["anchor"], words))

    def anchors(self):
        return {anchor for _, anchor, _ in self.headings}


class Writer:
    """Renders pages into one file; collects what is wrong with their links."""

    def __init__(self, root, pages):
        self.root, self.pages, self.wrong = root, {page.path: page for page in pages}, []
        api = self.pages.get("docs/reference/api.md")
        # A function's name leads to its entry. Anchors have no dots, names have.
        self.api = {words: f"{api.id}/{anchor}" for level, anchor, words in (api.headings if api else []) if level == 3}
        self.formatter = HtmlFormatter(nowrap=True)
        self.lexers = {name: get_lexer_by_name(lexer, stripnl=False) for name, lexer in LEXERS.items()}
        self.page, self.line = None, 0

    def say(self, what):
        self.wrong.append(f"{self.page.path}:{self.line}: {what}")

    # ---- links and pictures ----

    def file(self, target):
        """A path as the page writes it, as one of the repository."""
        return posixpath.normpath(posixpath.join(posixpath.dirname(self.page.path), target))

    def place(self, href):
        """Where a link leads in the file; None: to a file that is not in it."""
        target, _, anchor = href.partition("#")
        path = self.file(target) if target else self.page.path
        page = self.pages.get(path)
        if page is None:
            if not os.path.exists(os.path.join(self.root, path)):
                self.say(f'a link to "{href}": there is no {path}')
            return None
        if not anchor:
            return page.id
        if anchor not in page.anchors():
            self.say(f'a link to "{href}": {path} has no section "{anchor}"')
        return f"{page.id}/{anchor}"

    def picture(self, src):
        path = self.file(src)
        kind = TYPES.get(os.path.splitext(path)[1])
        try:
            with open(os.path.join(self.root, path), "rb") as f:
                data = f.read()
        except OSError:
            self.say(f"there is no picture {path}")
            return ""
        if kind is None:
            self.say(f"{path}: expected a picture in PNG, SVG or GIF")
        return f"data:{kind};base64,{base64.b64encode(data).decode()}"

    def html(self, text):
        """What a page has as HTML: pictures, and comments, which are for its authors."""
        text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
        return re.sub(r'src="([^"]*)"', lambda m: f'loading="lazy" src="{self.picture(m[1])}"', text)

    # ---- code ----

    def linked(self, html):
        """Coloured Lua, in which names of the API lead to their entries."""
        word = r'<span class="n[a-z]?">(\w+)</span>'

        def link(m):
            name = m[1] + (m[2] + m[3] if m[3] else "")
            return f'<a href="#{self.api[name]}">{m[0]}</a>' if name in self.api else m[0]
        # A key of a table that is called as a function is (wait = 30) is not that function.
        key = r"(?!(?:<[^>]*>|\s)*=)"
        return re.sub(rf'{word}(?:<span class="[po]">([.:])</span>{word})?{key}', link, html)

    def code(self, info, text):
        kind, _, about = info.partition(" ")
        title = about[2:].strip() if about.startswith("= ") else ""
        body = escape(text)
        if kind in self.lexers:
            body = highlight(text, self.lexers[kind], self.formatter)
        if kind == "lua":
            body = self.linked(body)
        caption = f"<figcaption>{escape(title)}</figcaption>" if title else ""
        return f'<figure class="code {kind or "plain"}">{caption}<pre tabindex="0"><code>{body}</code></pre></figure>\n'

    def word(self, token, in_link):
        """Code within a sentence; the name of a function leads to its entry."""
        name = re.match(r"[a-z_]+(?:[.:][a-z_]+)?", token.content)
        name = name[0] if name else ""
        html = f"<code>{escape(token.content)}</code>"
        known = name in self.api and (re.search("[.:]", name) or token.content.startswith(name + "("))
        return f'<a class="api" href="#{self.api[name]}">{html}</a>' if known and not in_link else html

    # ---- text ----

    def inline(self, tokens, in_link=False):
        out, closing = [], []
        for t in tokens:
            if t.type == "text":
                out.append(escape(t.content, quote=False))
            elif t.type == "code_inline":
                out.append(self.word(t, in_link or bool(closing)))
            elif t.type in ("softbreak", "hardbreak"):
                out.append("\n" if t.type == "softbreak" else "<br>")
                self.line += 1
            elif t.type == "html_inline":
                out.append(self.html(t.content))
            elif t.type == "image":
                out.append(f'<img loading="lazy" src="{self.picture(t.attrGet("src"))}" alt="{escape(t.content)}">')
            elif t.type == "link_open":
                opened, close = self.link(t.attrGet("href"))
                out.append(opened)
                closing.append(close)
            elif t.type == "link_close":
                out.append(closing.pop())
            else:
                out.append(f"<{'/' if t.nesting < 0 else ''}{t.tag}>")
        return "".join(out)

    def link(self, href):
        if re.match(r"[a-z]+:", href):
            return f'<a class="out" href="{escape(href)}">', "</a>"
        place = self.place(href)
        if place is None:
            return f'<span class="source" title="in the source: {escape(self.file(href))}">', "</span>"
        return f'<a href="#{escape(place)}">', "</a>"

    def block(self, token, heading):
        if token.map:
            self.line = token.map[0] + 1
        if token.type == "heading_open":
            return f'<{token.tag} id="{escape(self.anchor(token))}">'
        if token.type == "heading_close":
            place = escape(self.anchor(heading))
            return f' <a class="here" href="#{place}" aria-label="link to this section">#</a></{token.tag}>\n'
        if token.type == "inline":
            return self.inline(token.children, in_link=heading is not None)
        if token.type in ("fence", "code_block"):
            return self.code(token.info.strip(), token.content)
        if token.type == "html_block":
            return self.html(token.content)
        if token.type == "table_open":
            return f'<div class="table{self.wordy(token)}" tabindex="0"><table>'
        if token.type == "table_close":
            return "</table></div>\n"
        if token.hidden:
            return ""
        style = f' style="{token.attrGet("style")}"' if token.attrGet("style") else ""
        start = f' start="{token.attrGet("start")}"' if token.attrGet("start") else ""
        return f"<{'/' if token.nesting < 0 else ''}{token.tag}{style}{start}>" + ("\n" if token.nesting < 0 else "")

    def wordy(self, table):
        """Of two or three columns and sentences: in a narrow window its cells stand below each other."""
        from_, cells, columns = self.page.tokens.index(table), [], 0
        for token in self.page.tokens[from_:]:
            if token.type == "table_close":
                break
            columns += token.type == "th_open"
            if token.type == "inline":
                cells.append(len(token.content))
        return " wordy" if columns <= 3 and sum(cells) > 25 * len(cells) else ""

    def anchor(self, token):
        return f"{self.page.id}/{token.meta['anchor']}"

    def article(self, page):
        self.page, self.line, heading, out = page, 1, None, []
        for token in page.tokens:
            if token.type == "heading_open":
                heading = token
            out.append(self.block(token, heading))
            if token.type == "heading_close":
                heading = None
        if not page.tokens:
            out.append(f"<h1>{escape(page.name)}</h1>\n{self.code('', page.text)}")
        return (f'<article id="{page.id}" data-name="{escape(page.name)}" data-file="{escape(page.path)}">\n'
                f'{"".join(out)}</article>\n')


def contents(groups):
    out = []
    for title, pages in groups:
        out.append(f"<h2>{escape(title)}</h2>\n<ul>\n")
        for page in pages:
            out.append(f'<li data-page="{page.id}"><a href="#{page.id}">{escape(page.name)}</a>{sections(page)}</li>\n')
        out.append("</ul>\n")
    return "".join(out)


def sections(page):
    """The page's sections, and those within them."""
    out, open_in = [], False
    for level, anchor, words in page.headings:
        if level == 2:
            out.append(("</ul></li>" if open_in else "") + f'<li><a href="#{page.id}/{anchor}">{escape(words)}</a><ul>')
            open_in = True
        elif level == 3 and open_in:
            out.append(f'<li><a href="#{page.id}/{anchor}">{escape(words)}</a></li>')
    if not out:
        return ""
    return ("<ul>" + "".join(out) + "</ul></li></ul>").replace("<ul></ul>", "")


def pages_of(root, path):
    """The Markdown and text pages of a folder by name, or the file itself."""
    if not os.path.isdir(os.path.join(root, path)):
        return [path] if os.path.exists(os.path.join(root, path)) else []
    return [f"{path}/{name}" for name in sorted(os.listdir(os.path.join(root, path))) if name.endswith((".md", ".txt"))]


def gather(root):
    """The pages by group. A page of docs/ that no group names is an error."""
    groups = [(title, [page for path in paths for page in pages_of(root, path)]) for title, paths in GROUPS]
    named = {page for _, pages in groups for page in pages}
    for folder, _, names in sorted(os.walk(os.path.join(root, "docs"))):
        for name in sorted(names):
            path = posixpath.join(os.path.relpath(folder, root), name)
            if name.endswith(".md") and path not in named:
                raise Wrong(f"{path}: no group of tools/docs/docs.py has this page")
    return [(title, [Page(root, path) for path in paths]) for title, paths in groups]


def read(name):
    with open(os.path.join(HERE, name), encoding="utf-8") as f:
        return f.read()


def version(root):
    with open(os.path.join(root, "CHANGELOG.md"), encoding="utf-8") as f:
        found = re.search(r"^## ([0-9.]+)", f.read(), flags=re.M)
    return found[1] if found else ""


def whole(root):
    groups = gather(root)
    pages = [page for _, some in groups for page in some]
    writer = Writer(root, pages)
    articles = "".join(writer.article(page) for page in pages)
    if writer.wrong:
        raise Wrong("\n".join(writer.wrong))
    parts = {"style": read("page.css"), "script": read("page.js"), "contents": contents(groups), "articles": articles,
             "version": version(root)}
    return re.sub(r"\{\{(\w+)\}\}", lambda m: parts[m[1]], read("page.html"))


def main():
    args = argparse.ArgumentParser(description="README and docs/ as one HTML file")
    args.add_argument("--root", default=os.path.join(HERE, "..", ".."))
    args.add_argument("-o", dest="out", required=True)
    args = args.parse_args()
    try:
        page = whole(args.root)
    except (Wrong, OSError) as wrong:
        sys.exit(str(wrong))
    os.makedirs(os.path.dirname(os.path.abspath(args.out)), exist_ok=True)
    with open(args.out, "w", encoding="utf-8") as f:
        f.write(page)
    print(f"{args.out}: {page.count('<article ')} pages, {(len(page.encode()) + 99999) // 100000 / 10} MB")


main()

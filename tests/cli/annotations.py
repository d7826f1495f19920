"""annotations.py - compares `curtain help lua --annotations` with docs/reference/api.md, the other page made of the
API table.

    annotations.py ANNOTATIONS API.md      fails and says what differs

The annotations are read by LuaLS's grammar: every line --- with a tag is parsed to its end, every type that is named
must be declared. Optional marks, ranges and defaults are those of the page, and rows of the same words have the same
type.
"""
import re
import sys

BASIC = {"any", "boolean", "false", "function", "integer", "nil", "number", "string", "table"}
TOKEN = re.compile(r'\s*("[^"]*"|-?\d+|\.\.\.|[A-Za-z_][\w.]*|[^\s])')


class Types:
    """A type, read from a text; `rest` is what stands behind it, `names` are the types it names."""

    def __init__(self, text):
        self.text, self.at, self.names = text, 0, set()
        self.union()
        self.rest = text[self.at:].strip()
        self.type = text[:self.at].strip()

    def peek(self):
        found = TOKEN.match(self.text, self.at)
        return found.group(1) if found else ""

    def take(self, want=None):
        found = TOKEN.match(self.text, self.at)
        if not found or (want and found.group(1) != want):
            raise ValueError('expected %s in type "%s"' % (want or "a type", self.text[self.at:]))
        self.at = found.end()
        return found.group(1)

    def union(self):
        self.one()
        while self.peek() == "|":
            self.take("|")
            self.one()

    def one(self):
        word = self.take()
        if word == "{":
            self.listed("}")
        elif word == "(":
            self.union()
            self.take(")")
        elif word == "fun":
            self.take("(")
            self.listed(")")
            if self.peek() == ":":
                self.take(":")
                self.union()
        elif re.match(r"[A-Za-z_]", word):
            self.names.add(word)
        elif not re.match(r'"|-?\d', word):
            raise ValueError('"%s" is no type' % word)
        if word == "table" and self.peek() == "<":
            self.take("<")
            self.union()
            self.take(",")
            self.union()
            self.take(">")
        while self.text[self.at:self.at + 2] == "[]" or self.text[self.at:self.at + 1] == "?":
            self.at += 2 if self.text[self.at] == "[" else 1

    def listed(self, end):
        while self.peek() != end:
            name = self.take()
            if not re.match(r"\.\.\.$|[A-Za-z_]\w*$", name):
                raise ValueError('"%s" is no name of a field' % name)
            if self.peek() == "?":
                self.take("?")
            self.take(":")
            self.union()
            if self.peek() != end:
                self.take(",")
        self.take(end)


class Definitions:
    """What an annotation file declares."""

    def __init__(self, text):
        self.aliases, self.classes, self.parents = {}, {}, {}
        self.globals, self.locals, self.functions, self.used = {}, {}, {}, {}
        self.doc = []
        lines = text.split("\n")
        if not lines[0].startswith("---@meta"):
            raise ValueError("the first line is not ---@meta")
        for n, line in enumerate(lines[1:], 2):
            try:
                self.line(line)
            except ValueError as wrong:
                raise ValueError("line %d: %s" % (n, wrong)) from None
        declared = BASIC | set(self.aliases) | set(self.classes)
        for name, where in self.used.items():
            if name not in declared:
                raise ValueError("type %s is not declared: %s" % (name, where))

    def typed(self, text):
        """A type and its comment, "# words"."""
        t = Types(text)
        if t.rest and not t.rest.startswith("#"):
            raise ValueError('"%s" stands behind a type' % t.rest)
        for name in t.names:
            self.used.setdefault(name, text)
        return t.type, t.rest[1:].strip()

    def line(self, line):
        tag = re.match(r"---@(\w+)(?: +(.*))?$", line)
        if tag:
            getattr(self, "tag_" + tag.group(1), self.unknown)(tag.group(2) or "")
        elif line.startswith("---"):
            self.doc.append(("doc", line[3:]))
        elif line.startswith("--") or not line.strip():
            self.doc = [] if not line.strip() else self.doc
        else:
            self.code(line)

    def unknown(self, text):
        raise ValueError("no tag of LuaLS's: " + text)

    def tag_alias(self, text):
        name, rest = text.split(" ", 1)
        if name in self.aliases:
            raise ValueError("alias %s is declared twice" % name)
        self.aliases[name] = self.typed(rest)[0]

    def tag_class(self, text):
        found = re.match(r"([A-Za-z_][\w.]*)(?:: ([A-Za-z_][\w.]*))?$", text)
        if not found:
            raise ValueError("no class: " + text)
        name, parent = found.groups()
        if name in self.classes:
            raise ValueError("class %s is declared twice" % name)
        self.classes[name], self.parents[name] = {}, parent
        if parent:
            self.used.setdefault(parent, text)
        self.doc.append(("class", name))

    def tag_field(self, text):
        found = re.match(r"([A-Za-z_]\w*)(\??) (.*)$", text)
        owner = [d[1] for d in self.doc if d[0] == "class"]
        if not found or not owner:
            raise ValueError("no field of a class: " + text)
        name, optional, rest = found.groups()
        if name in self.classes[owner[-1]]:
            raise ValueError("field %s is declared twice" % name)
        self.classes[owner[-1]][name] = (optional == "?",) + self.typed(rest)

    def tag_param(self, text):
        found = re.match(r"([A-Za-z_]\w*|\.\.\.)(\??) (.*)$", text)
        if not found:
            raise ValueError("no parameter: " + text)
        self.doc.append(("param", (found.group(1), found.group(2) == "?") + self.typed(found.group(3))))

    def tag_return(self, text):
        self.doc.append(("return", self.typed(text)))

    def tag_type(self, text):
        self.doc.append(("type", self.typed(text)[0]))

    def said(self, what):
        return [d[1] for d in self.doc if d[0] == what]

    def code(self, line):
        function = re.match(r"function ([\w.:]+)\(([^)]*)\) end$", line)
        table = re.match(r"(local )?(\w+) = \{\}$", line)
        value = re.match(r"(\w+) = nil$", line)
        if function:
            params = self.said("param")
            names = [n for n in re.split(", *", function.group(2)) if n]
            if names != [p[0] for p in params]:
                raise ValueError("the parameters of %s are not those of its comment" % function.group(1))
            name = function.group(1)
            if name in self.functions:
                raise ValueError("%s is declared twice" % name)
            self.functions[name] = (params, self.said("return"), " ".join(self.said("doc")))
        elif table and len(self.said("class")) == 1:
            (self.locals if table.group(1) else self.globals)[table.group(2)] = self.said("class")[0]
        elif value and len(self.said("type")) == 1:
            self.globals[value.group(1)] = self.said("type")[0]
        else:
            raise ValueError("not expected here: " + line)
        self.doc = []


# ---- the page ----

# What rows of the page must be typed as. The other rows are only compared with each other: rows of the same words have
# the same type.
TYPES = {
    "whole number": "integer", "whole number or forever": "integer", "number": "number", "degrees": "number",
    "string": "string", "true or false": "boolean", "any value": "any", "1, 2 or a player": "player|1|2",
    "name of a bullet kind": "bullet_kind", "name of a sprite": "sprite_name", "linear, in, out or both": "ease_word",
}
MAKERS = ["bullet.fire", "shot.fire", "laser.bolt", "laser.curve", "laser.beam"]


def bare(words):
    """What an argument is, without its meaning, range and default."""
    if words.endswith("]") and "[" in words:
        words = words[words.rindex("[") + 1:-1]
    words = re.sub(r" \((required|default [^()]*)\)$", "", words)
    words = re.sub(r"^colour from 0x\w{6} to 0x\w{6}$", "whole number", words)
    words = re.sub(r"^whole number from -?\d[^,]*, or forever$", "whole number or forever", words)
    words = re.sub(r"^(whole number|number|\{ first, last \}, whole numbers) "
                   r"from -?[\d.e+]+ to -?[\d.e+]+.*$", r"\1", words)
    return re.sub(r"^string of \d+ to \d+ bytes$", "string", words)


class Entry:
    def __init__(self, lines):
        lines, self.first = list(lines), lines[0]
        self.help = ""
        while len(lines) > 1 and re.match(r"  \S", lines[1]):
            self.help += (" " if self.help else "") + lines.pop(1).strip()
        if "  Example:" in lines:
            lines = lines[:lines.index("  Example:")]
        found = re.match(r"([\w.:]+)(?:\(([^)]*)\))?(\{\.\.\.\})?(?: -> (.*))?$", self.first)
        self.name, plain, table, returns = found.groups()
        plain = [p for p in (plain or "").split(", ") if p]
        self.table, self.more = bool(table) or "{...}" in plain, "..." in plain
        self.plain = [p.rstrip("?") for p in plain if p not in ("...", "{...}")]
        self.returns = returns.split(", ") if returns else []
        self.params, self.parts, self.helps, self.fires, into, part = {}, {}, {}, False, None, None
        for line in filter(None, lines[1:]):
            param = re.match(r"    (\S+) +(.*)$", line)
            found = re.match(r"  (\w+): (.*)$", line)
            if found:
                part = found.group(1)
                into = self.parts.setdefault(part, {})
                self.helps[part] = found.group(2)
            elif line.startswith("      "):
                self.helps[part] += " " + line.strip()
            elif param.group(1) == "...":
                self.fires = True
            else:
                (self.params if into is None else into)[param.group(1)] = param.group(2)


class Page:
    def __init__(self, text):
        self.entries, self.values, self.properties = {}, {}, {}
        text = re.sub(r"\n {15,}(?=\S)", " ", text)  # wrapped lines
        for section in re.split(r"^## ", text, flags=re.M)[1:]:
            listed = re.search(r"```\nproperties of [^\n]*:\n(.*?)```", section, re.S)
            if listed:
                self.properties[section.split("\n")[0]] = [
                    re.match(r"    (\w+) +(read|write) +(.*)$", line).groups() for line in
                    listed.group(1).splitlines()]
            for entry in re.findall(r"^### [^\n]*\n\n```\n(.*?)\n```", section, re.S | re.M):
                first = entry.split("\n\n  Example:")[0]
                value = re.match(r"([\w.]+)(\([^)]*\))?   +(\S.*)$", first) or \
                    re.match(r"(hud\.centre)(\([^)]*\)) (\S.*)$", first)
                if value:
                    self.values[value.group(1)] = value.groups()[1:]
                else:
                    e = Entry(entry.split("\n"))
                    self.entries[e.name] = e


# ---- one with the other ----

class Comparison:
    def __init__(self, definitions, page):
        self.d, self.page, self.found, self.types = definitions, page, [], {}
        self.wanted_classes, self.wanted_functions = {"route", "fired"}, set()
        for e in page.entries.values():
            self.entry(e)
        self.fired()
        for kind in page.properties:
            self.handle(kind)
        for name, value in page.values.items():
            self.value(name, *value)
        spaces = {n.split(".")[0] for n in list(page.entries) + list(page.values) if "." in n and ":" not in n}
        for space in spaces:
            self.same("table " + space, space + "lib", self.d.globals.get(space))
            self.wanted_classes.add(space + "lib")
        self.same("classes", sorted(self.wanted_classes), sorted(self.d.classes))
        self.same("functions", sorted(self.wanted_functions), sorted(self.d.functions))
        self.same("globals", sorted(spaces | {"forever"}), sorted(self.d.globals))

    def same(self, what, want, got):
        if want != got:
            if isinstance(want, list) and isinstance(got, list):
                want, got = [w for w in want if w not in got], [g for g in got if g not in want]
            self.found.append("%s: the table says %s, the annotations %s" % (what, want, got))

    def typed(self, what, words, got):
        """Rows of the same words have the same type; functions and tables have types of their own."""
        words = bare(words)
        if words in ("function", "table") or words.startswith("{"):
            return
        self.same("type of %s, %s" % (what, words), TYPES.get(words, self.types.setdefault(words, got)), got)

    def fields(self, name, wanted):
        got = self.d.classes.get(name)
        self.wanted_classes.add(name)
        if got is None:
            self.found.append("class %s is missing" % name)
            return
        self.same("fields of " + name, list(wanted), list(got))
        for field, words in wanted.items():
            required = words.endswith("(required)]")
            optional, kind, comment = got.get(field, (None, None, None))
            self.same("field %s of %s" % (field, name), (not required, words), (optional, comment))
            self.typed("field %s of %s" % (field, name), words, kind)

    def entry(self, e):
        method = ":" in e.name
        name = "a_" + e.name if method else e.name
        base = e.name.replace(":", ".") + (".self" if method else "")
        self.wanted_functions.add(name)
        for part, params in e.parts.items():
            self.fields("%s.%s" % (e.name, part), params)
        if e.table:
            self.fields(base + ".args", {p: w for p, w in e.params.items() if p not in e.plain})
            self.same("what %s is" % base, "fired" if e.fires else None, self.d.parents.get(base + ".args"))
        if name not in self.d.functions:
            self.found.append("%s is missing" % name)
            return
        params, returns, doc = self.d.functions[name]
        self.same("help of " + name, e.help, doc)
        want = [(p, "(required)" not in e.params[p], e.params[p]) for p in e.plain]
        for p, kind in [(p[0], p[2]) for p in params if p[0] in e.plain]:
            self.typed("parameter %s of %s" % (p, name), e.params[p], kind)
        if e.more:
            want.append(("...", False, ""))
        if e.table:
            must = e.fires or any(w.endswith("(required)]") for p, w in e.params.items() if p not in e.plain)
            want.append(("args", not must, ""))
        self.same("parameters of " + name, want, [(p, optional, comment) for p, optional, _, comment in params])
        self.same("results of " + name, e.returns, [comment for _, comment in returns])
        for kind, comment in returns:
            self.typed("result of " + name, comment, kind)

    def fired(self):
        want = {}
        for maker in MAKERS:
            e = self.page.entries[maker]
            for p, words in e.params.items():
                if p not in e.plain and p not in want:
                    words = words.replace(" (required)", "")
                    want[p] = (True, "%s: %s" % (maker, words))
        self.same("class fired", want, {p: (o, c) for p, (o, _, c) in self.d.classes.get("fired", {}).items()})

    def handle(self, kind):
        self.wanted_classes.add(kind)
        got = self.d.classes.get(kind, {})
        self.same("table of " + kind, kind, self.d.locals.get("a_" + kind))
        self.same("properties of " + kind, [p[0] for p in self.page.properties[kind]], list(got))
        for name, how, text in self.page.properties[kind]:
            words = re.search(r" \[(.*)\]$", text)
            optional, of, comment = got.get(name, (None, None, None))
            want = ("nil" in text, ("read-only: " if how == "read" else "") + text)
            self.same("%s.%s" % (kind, name), want, (optional, comment))
            if '"' not in text:
                self.typed("%s.%s" % (kind, name), words.group(1) if words else "true or false", of)

    def value(self, name, arguments, text):
        if name in ("print", "require"):
            return  # Lua's own, and the language server's
        if arguments:
            self.wanted_functions.add(name)
            params, returns, doc = self.d.functions.get(name, ([], [], ""))
            self.same("parameters of " + name, arguments[1:-1].split(", "),
                      [p[0] + ("?" if p[1] else "") for p in params])
            self.same("help of " + name, text, doc)
            self.same("results of " + name, len(re.findall("returns", text)), len(returns))
            kinds = [p[2] for p in params]
        elif "." in name:
            field = self.d.classes.get(name.split(".")[0] + "lib", {}).get(name.split(".")[1], (None, "any", None))
            self.same("help of " + name, text, field[2])
            kinds = [field[1]]
        else:
            kinds = [self.d.globals.get(name, "any")]
        if "any" in kinds:
            self.found.append("%s has no type" % name)


def compare(annotations, api):
    try:
        definitions = Definitions(annotations)
    except ValueError as wrong:
        return [str(wrong)]
    definitions.text = annotations
    return Comparison(definitions, Page(api)).found


def main(arguments):
    annotations, api = (open(path, encoding="utf-8").read() for path in arguments)
    found = compare(annotations, api)
    print("\n".join(found[:20]))
    return bool(found)


sys.exit(main(sys.argv[1:]))

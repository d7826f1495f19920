"""annotations.py - compares `curtain help lua --annotations` with docs/reference/api.md, the other page made of the
API table.

    annotations.py ANNOTATIONS API.md      fails and says what differs

Every line --- of the annotations has a tag and a form that LuaLS knows, and every type that is named is declared. Each
entry of the page is declared, with the arguments, optional marks, words and types that the page says.
"""
import re
import sys

BASIC = {"any", "boolean", "false", "fun", "function", "integer", "nil", "number", "string", "table"}


def names_in(kind):
    """The types that a type names."""
    plain = re.sub(r'"[^"]*"', '""', kind)
    if not re.match(r'["\w({-]|\.\.\.', plain) or any(plain.count(a) != plain.count(b) for a, b in ("()", "{}", "<>")):
        raise ValueError('"%s" is no type' % kind)
    plain = re.sub(r"(\w+|\.\.\.)\??:", "", plain)  # names of fields and parameters
    return set(re.findall(r"[A-Za-z_][\w.]*", plain))


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
        """A type and its comment, "TYPE # words"."""
        kind, _, comment = text.partition(" # ")
        for name in names_in(kind):
            self.used.setdefault(name, text)
        return kind, comment

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
        self.aliases[name] = self.typed(rest)[0]

    def tag_class(self, text):
        found = re.match(r"([A-Za-z_][\w.]*)(?:: ([A-Za-z_][\w.]*))?$", text)
        if not found:
            raise ValueError("no class: " + text)
        name, parent = found.groups()
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
            self.functions[name] = (params, self.said("return"), " ".join(self.said("doc")))
        elif table and len(self.said("class")) == 1:
            (self.locals if table.group(1) else self.globals)[table.group(2)] = self.said("class")[0]
        elif value and len(self.said("type")) == 1:
            self.globals[value.group(1)] = self.said("type")[0]
        else:
            raise ValueError("not expected here: " + line)
        self.doc = []


# ---- the page ----

# What rows of the page must be typed as, of those that are not things.
TYPES = {
    "number": "number", "degrees": "number", "string": "string", "true or false": "boolean", "any value": "any",
    "1, 2 or a player": "player|1|2", "name of a bullet kind": "bullet_kind", "name of a sprite": "sprite_name",
    "linear, in, out or both": "ease_word",
}


def type_of(words):
    """The type of an argument that the page describes with these words; None: any will do."""
    words = re.sub(r" \((required|default [^()]*)\)$", "", words)
    if words.startswith("thing: "):
        return "|".join(re.split(", | or ", words[len("thing: "):]))
    if re.match(r"(whole number|colour)( from [^,]*)?$", words):
        return "integer"
    return TYPES.get("number" if words.startswith("number from") else words)


def blocks(page):
    """The name and the lines of every text block of the page, up to its example; wrapped lines are joined."""
    page = re.sub(r"\n {15,}(?=\S)", " ", page)
    for name, body in re.findall(r"^##+ (\S+)\n\n```\n(.*?)\n```$", page, re.S | re.M):
        yield name, body.split("\n\n  Example:")[0].split("\n")


def arguments(lines):
    """(part or None, name, words) of each row; a part is a table within the arguments."""
    part = None
    for line in lines[1:]:
        row = re.match(r"    (\w+) +(.*)$", line)
        heading = re.match(r"  (\w+): ", line)
        if heading:
            part = heading.group(1)
        elif row:
            yield part, row.group(1), row.group(2)


class Comparison:
    def __init__(self, definitions, page):
        self.d, self.found = definitions, []
        for name, lines in blocks(page):
            if name in ("print", "require"):
                continue  # Lua's own, and the language server's
            if lines[0].startswith("properties of"):
                self.properties(name, lines[1:])
            elif "(" in lines[0].split("  ")[0] or "{...}" in lines[0]:
                self.function(name, lines)
            else:
                self.value(name)

    def same(self, what, want, got):
        if want != got:
            self.found.append("%s: the page says %s, the annotations %s" % (what, want, got))

    def function(self, name, lines):
        declared = self.d.functions.get("a_" + name if ":" in name else name)
        if not declared:
            self.found.append("%s is missing" % name)
            return
        parameters = {p[0]: p[1:] for p in declared[0]}
        table = self.d.classes.get(name.replace(":", ".") + (".self" if ":" in name else "") + ".args", {})
        for part, argument, words in arguments(lines):
            where = self.d.classes.get("%s.%s" % (name, part), {}) if part else {**table, **parameters}
            if argument not in where:
                self.found.append("%s: %s is missing" % (name, argument))
                continue
            optional, kind, comment = where[argument]
            self.same("%s, %s" % (name, argument), (not re.search(r"\(required\)\]?$", words), words),
                      (optional, comment))
            want = type_of(re.sub(r".*\[|\]$", "", words))
            self.same("type of %s, %s" % (name, argument), want or kind, kind)

    def properties(self, kind, lines):
        fields = self.d.classes.get(kind, {})
        rows = [re.match(r"    (\w+) +(read|write) +(.*)$", line).groups() for line in lines]
        self.same("properties of " + kind, [row[0] for row in rows], list(fields))
        for name, how, text in rows:
            optional, _, comment = fields.get(name, (None, None, None))
            self.same("%s.%s" % (kind, name), ("nil" in text, ("read-only: " if how == "read" else "") + text),
                      (optional, comment))

    def value(self, name):
        library, _, field = name.rpartition(".")
        declared = self.d.classes.get(library + "lib", {}) if library else self.d.globals
        if field not in declared:
            self.found.append("%s is missing" % name)


def main(annotations, api):
    try:
        definitions = Definitions(open(annotations, encoding="utf-8").read())
        found = Comparison(definitions, open(api, encoding="utf-8").read()).found
    except ValueError as wrong:
        found = [str(wrong)]
    print("\n".join(found[:20]))
    return bool(found)


sys.exit(main(*sys.argv[1:]))

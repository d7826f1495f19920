"""messages.py FILE...: see messages.sh."""
import re
import sys

# Comments, character constants, strings, names and anything else of C; PRId64 and its like stay in a text.
C = re.compile(r'/\*.*?\*/|//[^\n]*|\'(?:\\.|[^\'\\])*\'|"(?:\\.|[^"\\])*"|\w+|\\\n|\s+|.', re.S)
LUA = re.compile(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'')
WORDS = re.compile(r"[A-Za-z]{2,}[^A-Za-z]* .*[A-Za-z]{2}|[A-Za-z]{2}.* [^A-Za-z]*[A-Za-z]{2}")


def of_c(source):
    """(line, text) of each string literal, adjacent ones joined."""
    text, start, line = None, 0, 1
    for token in C.findall(source):
        if token[0] == '"':
            start = line if text is None else start
            text = (text or "") + token[1:-1]
        elif text is not None and re.match(r"PRI\w+$", token):
            text += token
        elif text is not None and not token.isspace() and token != "\\\n" and token[:2] not in ("/*", "//"):
            yield start, text
            text = None
        line += token.count("\n")


def of_lua(source):
    calls = 0
    for line, text in enumerate(source.split("\n"), 1):
        if "sys.fail" in text:
            calls = 1
        elif calls and text.strip()[:1] not in ("(", "'", '"', ":", "."):
            calls = 0
        if calls:
            for literal in LUA.findall(text):
                yield line, literal[1:-1]


def main():
    for name in sys.argv[1:]:
        with open(name, encoding="utf-8") as file:
            source = file.read()
        for line, text in (of_lua if name.endswith(".lua") else of_c)(source):
            if WORDS.search(text):
                print(f"{name}:{line}: {text}")


main()

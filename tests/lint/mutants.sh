#!/usr/bin/env bash
# mutants.sh - tests/mutants.list has the right format, and tests/mutants.py plants what it should. `make
# mutants` reports faults that can't be planted in today's sources.
. "$(dirname "$0")/../tap.sh"

check "the list's format" tests/mutants.py check tests/mutants.list
list=$scratch/list
wrong() { # LINE...
    printf '%s\n' "@ test_f" "$@" >"$list"
    tests/mutants.py check "$list"
}
detects "a line without a place" "expected PLACE: OLD => NEW" wrong "x + 1 => x - 1"

# A tree with one source.
tree=$scratch/tree
mkdir -p "$tree/src"
cat >"$tree/src/f.c" <<'END'
/* int f(int x) { return x + 1; } */
static const int table[] = { 1, 2, 3 };
int g(int x)
{
    return x + 1 + table[0];
}
int f(int x)
{
    return x + 1;
}
END
plant() { # LINE: into a copy; prints the line that is another
    printf '@ test_f\n%s\n' "$1" >"$list"
    rm -rf "$scratch/copy"
    cp -r "$tree" "$scratch/copy"
    tests/mutants.py plant "$list" "$scratch/copy" 1 || return
    diff -r "$tree/src" "$scratch/copy/src" | grep '^>'
}
plants() { plant "$1" | grep -qFx "> $2" || { plant "$1"; return 1; }; }
check "a function's text, which another one has too" plants "f: x + 1 => x - 1" "    return x - 1;"
check "a file's function" plants "f.c:g: x + 1 => x" "    return x + table[0];"
refuse "a text that is not there" "found 0 times in f" plant "f: x + 2 => x - 1"
refuse "a text that is there often" "found 3 times in f.c" plant "f.c: x + 1 => x - 1"
finish

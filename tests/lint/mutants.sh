#!/usr/bin/env bash
# mutants.sh - tests/mutants.list has the right format, and tests/mutants.py plants what it should. `make
# mutants` reports faults that can't be planted in today's sources.
. "$(dirname "$0")/../tap.sh"

check "the list's format" tests/mutants.py check tests/mutants.list

# A tree with one source.
mkdir -p "$scratch/tree/src"
cat >"$scratch/tree/src/f.c" <<'END'
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
    printf '@ test_f\n%s\n' "$1" >"$scratch/list"
    tests/mutants.py check "$scratch/list" || return
    rm -rf "$scratch/copy"
    cp -r "$scratch/tree" "$scratch/copy"
    tests/mutants.py plant "$scratch/list" "$scratch/copy" 1 || return
    diff -r "$scratch/tree" "$scratch/copy" | grep '^>'
}
same "a function's text, which another one has too" ">     return x - 1;" "$(plant "f: x + 1 => x - 1" | tail -n 1)"
same "a file's function" ">     return x + table[0];" "$(plant "f.c:g: x + 1 => x" | tail -n 1)"
refuse "a line without a place" "expected PLACE: OLD => NEW" plant "x + 1 => x - 1"
refuse "a text that is not there" "found 0 times in f" plant "f: x + 2 => x - 1"
refuse "a text that is there often" "found 3 times in f.c" plant "f.c: x + 1 => x - 1"
finish

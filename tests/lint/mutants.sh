#!/usr/bin/env bash
# mutants.sh - tests/mutants.list has the right format, tests/mutants.py plants what it should, and tests/mutants.sh
# resumes. Whether the list's faults can be planted in the sources of today, `make mutants` says, not this test.
. "$(dirname "$0")/../tap.sh"

check "the list's format" tests/mutants.py check tests/mutants.list
list=$scratch/list
wrong() { # LINE...
    printf '%s\n' "@ test_f" "$@" >"$list"
    tests/mutants.py check "$list"
}
detects "a line without a place" "expected PLACE: OLD => NEW" wrong "x + 1 => x - 1"

# A tree with one source and one test, and what mutants.sh needs of this one.
tree=$scratch/tree
mkdir -p "$tree"/{src,tests/unit,tests/golden}
cp tests/mutants.sh tests/mutants.py tests/patient.py "$tree/tests/"
printf '%s\n' 'OUT := build/$(CONFIG)' 'programs: $(OUT)/unit/test_f' \
    '$(OUT)/curtain-null $(OUT)/curtain-short $(OUT)/curtain:' \
    '$(OUT)/unit/test_f: src/f.c tests/unit/test_f.c ; @mkdir -p $(@D) && echo built >>$(LOG) && $(CC) $^ -o $@' \
    >"$tree/Makefile"
cat >"$tree/tests/unit/test_f.c" <<'END'
#include <stdio.h>
int f(int x), g(int x);
int main(void)
{
    printf("%sok 1 - f\n1..1\n", f(1) == 2 ? "" : "not ");
    return f(1) != 2;
}
END
printf '#!/bin/sh\n' >"$tree/tests/golden/run.sh"
chmod +x "$tree/tests/golden/run.sh"
source_is() { cat >"$tree/src/f.c"; }
source_is <<'END'
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

# The run: killed, survived, not planted.
source_is <<'END'
int f(int x) { return x + 1; }
int g(int x) { return x + 2; }
END
printf '@ test_f\nf: x + 1 => x - 1\ng: x + 2 => x - 2\nh: x => y\n' >"$tree/tests/mutants.list"
export LOG=$scratch/log
run() { # ARGUMENT...: the last lines, and how often something was built
    local code
    : >"$LOG"
    env -u MAKEFLAGS -u MAKELEVEL "$tree/tests/mutants.sh" "$@" >"$scratch/run" 2>&1
    code=$?
    grep -E "$pattern" "$scratch/run"
    echo "built $(wc -l <"$LOG") exit $code"
}
pattern='^[0-9]+ killed|done before|^SURVIVED|^NOT PLANTED|starting'
all_of_it=$'3 faults, 0 of them done before\nNOT PLANTED 3 there is no h: h: x => y\n1 killed, 2 survived'
whole=$(run | sort -u)
same "all faults: one is killed" "$(sort <<<"$all_of_it
SURVIVED 2 src/f.c: g: x + 2 => x - 2
built 3 exit 1")" "$whole"
same "a second run builds nothing and says the same" \
    "$(sed 's/, 0 of them/, 3 of them/; s/^built 3/built 0/' <<<"$whole")" "$(run | sort -u)"
ls "$tree/build/mutants" | grep -E '^[0-9a-f]{40}$' | head -n 1 | sed "s,^,$tree/build/mutants/," | xargs rm
pattern='killed|done before'
stopped=$(run)
check "a run that was stopped resumes" grep -q "2 of them done before" <<<"$stopped"
check "and comes to the same end" grep -qx "1 killed, 2 survived" <<<"$stopped"
echo 'int more;' >>"$tree/src/f.c"
pattern='starting|done before'
same "a changed tree starts again" \
    "the tree has changed since the results in build/mutants: starting again 3 faults, 0 of them done before" \
    "$(run | head -n 2 | paste -sd ' ')"
finish

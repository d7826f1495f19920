#!/usr/bin/env bash
# targets.sh - every goal of make that README, CONTRIBUTING or `make help` names is run by a test, or at least all that
# it compiles is built by `make test`.
. "$(dirname "$0")/../tap.sh"

# The goals that texts name: in the pages between backticks or at the start of a line, in the help anywhere.
in_pages() { # PAGE...
    grep -ohE '(^|`)make( [A-Z]+=[^ `]+)*( [a-z][a-z-]*)' "$@" | sed 's/.* //'
}
in_help() {
    make --no-print-directory help | grep -oE '(^|  )make( [A-Z]+=[^ ]+)*( [a-z][a-z-]*)( |$)' | sed 's/ *$//; s/.* //'
}
named=$( (in_pages README.md CONTRIBUTING.md; in_help) | sort -u)

# Those that run elsewhere: the file that runs each, and words of it.
runs() {
    cat <<'END'
all       tests/cli/install.sh      built_in
analyze   tests/nightly.sh          parts="analyze
asan      tests/nightly.sh          asan ubsan
clean     tests/lint/targets.sh    make -s -C "$scratch/clean" clean
compare   tests/cli/compare.sh      tools/compare/compare.sh "$@"
cross     tests/builds.sh           tools/cross/run.sh i386
deps      tests/cli/install.sh      installs deps
docs      tests/lint/onefile.sh    tools/docs/docs.sh
format    tests/lint/targets.sh    make -s -C "$scratch/format" format
fuzz      tests/nightly.sh          fuzz mutants"
help      tests/lint/targets.sh    make --no-print-directory help
install   tests/cli/install.sh      makes install
library   tests/nightly.sh          browser library ports
monkey    tests/nightly.sh          ubsan monkey
msan      tests/nightly.sh          monkey msan
mutants   tests/nightly.sh          fuzz mutants"
nightly   tests/lint/targets.sh    tests/nightly.sh none
bulletml  tests/nightly.sh          build/release/bulletml
play      .ci/run                   make play
players   Makefile                  --no-print-directory players
ports     tests/nightly.sh          library ports
test      .ci/run                   make test
torture   tests/nightly.sh          torture screens
ubsan     tests/nightly.sh          asan ubsan
uninstall tests/cli/install.sh      makes uninstall
valgrind  tests/nightly.sh          msan valgrind
walks     tests/nightly.sh          analyze walks
web       platform/web/test.sh         --web -o
windows   Makefile                  --no-print-directory windows
END
}
run_by() { # GOAL: that line is true
    local file words
    read -r _ file words < <(runs | grep "^$1 ")
    [ -n "$file" ] && grep -qF -- "$words" "$file"
}

# What a goal compiles or links, as make would if nothing were built; gen/ is what make itself writes.
makes() {
    make -n -B CONFIG=release "$1" 2>/dev/null | grep -oE ' -o build/[^ ;]+' | sed 's/ -o //' | grep -v /gen/ | sort -u
}
built() { # GOAL: there is something, and all of it is there
    local file n=0
    for file in $(makes "$1"); do
        [ -e "$file" ] || { echo "make $1: $file is built by no test"; return 1; }
        n=$((n + 1))
    done
    [ $n -gt 0 ] || { echo "make $1: no test runs it, and it builds nothing"; return 1; }
}
covered() { # GOAL...
    local goal bad=0
    for goal in "$@"; do run_by "$goal" || built "$goal" || bad=1; done
    return $bad
}
# shellcheck disable=SC2086
check "every goal is run or built by a test" covered $named
useful() { # no line of the list is about a goal that is not named
    local goal
    for goal in $(runs | cut -d ' ' -f 1); do
        grep -qx -- "$goal" <<<"$named" || { echo "$goal is not named"; return 1; }
    done
}
check "the list names no other" useful
check "there are many" [ "$(wc -l <<<"$named")" -gt 30 ]
# shellcheck disable=SC2016
echo 'Type `make nonsense`.' >"$scratch/page.md"
same "a page's goals" nonsense "$(in_pages "$scratch/page.md")"
refuse "planted: a goal that is not there" "make nonsense: no test runs it" covered nonsense
makes() { echo build/release/gone; }
refuse "planted: a program that no test builds" "build/release/gone is built by no test" covered bench

# The small ones, here.
clean() {
    mkdir -p "$scratch/clean/build/x" && cp Makefile "$scratch/clean/" && make -s -C "$scratch/clean" clean &&
        [ ! -e "$scratch/clean/build" ]
}
check "make clean" clean
format() {
    mkdir "$scratch/format" && cp Makefile .clang-format "$scratch/format/" && git -C "$scratch/format" init -q &&
        echo 'int  f( void );' >"$scratch/format/a.c" && git -C "$scratch/format" add a.c &&
        make -s -C "$scratch/format" format && [ "$(cat "$scratch/format/a.c")" = 'int f(void);' ]
}
check "make format" format
recording=$(sed -n 's,^taskset .*/bench_fx" ,,p' tools/bench_fx/bench_fx.sh)
# shellcheck disable=SC2086
check "make bench-fx: its demo has enough bullets" "$OUT/bench_fx_build/bench_fx" $recording
refuse "make nightly takes its parts alone" '"none" is none of analyze walks' tests/nightly.sh none
finish

#!/usr/bin/env bash
# ci.sh - .ci/run runs make play, then make test and the other builds, adds up what they count, and takes what prints no
# count for a failure.
. "$(dirname "$0")/../tap.sh"

tree=$scratch/tree
mkdir -p "$tree/.ci" "$tree/tests"
cp .ci/run "$tree/.ci/"
play=true
ends() { # TEST BUILDS WANT CODE: shell code in place of make test and of tests/builds.sh; the last line, the exit code
    local got code
    printf 'play:\n\t@%s\ntest:\n\t@%s\n' "$play" "$1" >"$tree/Makefile"
    printf '#!/bin/sh\n%s\n' "$2" >"$tree/tests/builds.sh"
    chmod +x "$tree/tests/builds.sh"
    got=$(env -u MAKEFLAGS -u MAKELEVEL "$tree/.ci/run")
    code=$?
    [ "$(tail -n 1 <<<"$got")" = "$3" ] && [ $code = "$4" ] ||
        { echo "$got"; echo "exit $code, expected $3 and exit $4"; return 1; }
}
three='echo "3 passed, 0 failed"'
check 'both counts and make play are added' \
    ends "$three" 'echo "unit 4"; echo "40 passed, 0 failed"' '44 passed, 0 failed' 0
check 'what failed too' \
    ends 'echo "3 passed, 2 failed"; exit 1' 'echo "1 passed, 1 failed"; exit 1' '5 passed, 3 failed' 1
check 'a first part without a count has failed' ends 'echo no compiler; exit 2' "$three" '4 passed, 1 failed' 1
check 'so has a second' ends "$three" 'exit 1' '4 passed, 1 failed' 1
check 'what comes after a count is no count' \
    ends "$three; echo x" 'echo "1 passed, 0 failed"; echo 7' '5 passed, 0 failed' 0
play='touch played'
check 'make play comes first' ends 'test -f played && echo "3 passed, 0 failed"' "$three" '7 passed, 0 failed' 0
play='test -z "$$DISPLAY$$WAYLAND_DISPLAY"'
export DISPLAY=:9 WAYLAND_DISPLAY=x
check 'it opens no window' ends "$three" "$three" '7 passed, 0 failed' 0
play='echo no compiler; exit 2'
check 'make play has failed' ends "$three" "$three" '6 passed, 1 failed' 1
refuse 'planted: another sum' 'expected 5 passed, 0 failed' ends "$three" "$three" '5 passed, 0 failed' 0
finish

#!/usr/bin/env bash
# ci.sh - .ci/run adds up what make test and the other builds count, and what says no count has failed.
. "$(dirname "$0")/../tap.sh"

tree=$scratch/tree
mkdir -p "$tree/.ci" "$tree/tests"
cp .ci/run "$tree/.ci/"
ends() { # TEST BUILDS WANT CODE: shell code in place of make test and of tests/builds.sh; the last line, the exit code
    local got code
    printf 'test:\n\t@%s\n' "$1" >"$tree/Makefile"
    printf '#!/bin/sh\n%s\n' "$2" >"$tree/tests/builds.sh"
    chmod +x "$tree/tests/builds.sh"
    got=$(env -u MAKEFLAGS -u MAKELEVEL "$tree/.ci/run")
    code=$?
    [ "$(tail -n 1 <<<"$got")" = "$3" ] && [ $code = "$4" ] ||
        { echo "$got"; echo "exit $code, expected $3 and exit $4"; return 1; }
}
three='echo "3 passed, 0 failed"'
check 'two counts are added' ends "$three" 'echo "unit 4"; echo "40 passed, 0 failed"' '43 passed, 0 failed' 0
check 'what failed too' \
    ends 'echo "3 passed, 2 failed"; exit 1' 'echo "1 passed, 1 failed"; exit 1' '4 passed, 3 failed' 1
check 'a first part without a count has failed' ends 'echo no compiler; exit 2' "$three" '3 passed, 1 failed' 1
check 'so has a second' ends "$three" 'exit 1' '3 passed, 1 failed' 1
check 'what comes after a count is no count' \
    ends "$three; echo x" 'echo "1 passed, 0 failed"; echo 7' '4 passed, 0 failed' 0
refuse 'planted: another sum' 'expected 5 passed, 0 failed' ends "$three" "$three" '5 passed, 0 failed' 0
finish

#!/bin/sh
# run.sh - make test on macOS: the test programs in C, and the demos of the games. The other tests need Linux.
#
#     OUT=build/release tests/macos/run.sh       Exit 1: something failed, or was not built.
set -u
cd "$(dirname "$0")/../.." || exit 2
OUT=${OUT:-build/release}
XDG_DATA_HOME=$(mktemp -d) || exit 2
export XDG_DATA_HOME
trap 'rm -rf "$XDG_DATA_HOME"' EXIT
passed=0 failed=0

try() { # NAME COMMAND...: its last lines are shown if it fails
    name=$1
    shift
    if output=$("$@" 2>&1); then
        passed=$((passed + 1))
        return
    fi
    failed=$((failed + 1))
    echo "FAILED $name"
    printf '%s\n' "$output" | tail -n 12 | sed 's/^/    /'
}

for source in tests/unit/test_*.c tests/machine/test_*.c; do
    program=${source#tests/}
    try "$source" "$OUT/${program%.c}"
done
for demo in roms/*/demos/*.demo; do
    try "$demo" "$OUT/curtain-null" verify "${demo%/demos/*}" "$demo"
done
echo "$passed passed, $failed failed on $(uname -srm)"
[ "$failed" = 0 ]

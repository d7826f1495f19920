#!/bin/sh
# files.sh - lists the files of the repository, also without Git.
#
#     tests/files.sh [PATTERN...]     * stands for any characters, also /; without patterns: all files
#     tests/files.sh --digest         one hash of the names and contents of all files
set -f
cd "$(dirname "$0")/.." || exit 2
if [ "${1:-}" = --digest ]; then
    "$0" | tr '\n' '\0' | xargs -0 sha256sum | sha256sum | cut -d ' ' -f 1
    exit
fi
[ $# != 0 ] || set -- '*'
for pattern; do find . \( -path ./build -o -path ./.git \) -prune -o -type f -path "./$pattern" -print; done |
    sed 's,^\./,,' | LC_ALL=C sort -u

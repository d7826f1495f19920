#!/usr/bin/env bash
# messages.sh - prints the texts that the program can show, for review: "FILE:LINE: TEXT", a line each.
#
#     tools/messages.sh [FILE...]    of these C and Lua files; without one, of src, platform, ports and scripts
#
# From C files, every string literal of several words, adjacent ones joined; from Lua files, the literals in lines that
# call sys.fail. A literal that is code or data for another program is printed, too: only a reader can tell.
set -eu
cd "$(dirname "$0")/.."
if [ $# = 0 ]; then
    # shellcheck disable=SC2046
    set -- $(tests/files.sh 'src/*.[ch]' 'platform/*.[ch]' 'scripts/*.lua')
fi
exec python3 tools/messages.py "$@"

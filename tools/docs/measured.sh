#!/bin/sh
# measured.sh - the lines of a generated page that name the commit and the machine that it was measured on.
#
#     tools/docs/measured.sh [WITH]     WITH: the compiler, for pages with times; other pages name only the commit
#
# Without Git there is no commit to name. tools/docs/stale.sh reads it.
cd "$(dirname "$0")/../.." || exit 2
measured='src fb platform scripts tools roms Makefile'
commit=$(git log -1 --format='%h (%cs)' 2>/dev/null)
# shellcheck disable=SC2086
[ -z "$commit" ] || git diff --quiet HEAD -- $measured || commit="$commit with changes"
[ -z "$commit" ] || printf 'Measured at commit %s.\n\n' "$commit"
[ $# = 0 ] || awk -F ': *' -v with="$1" '
    /^model name/ && !name { name = $2 }
    /^cpu MHz/ && !mhz { mhz = int($2) " MHz" }
    /^cache size/ && !cache { cache = $2 " of cache" }
    /^processor/ { cores++ }
    END {
        printf "Measured on: %s, %d cores, %s, %s; %s\n\n", name ? name : "an unnamed processor", cores,
            mhz ? mhz : "unknown speed", cache ? cache : "unknown cache", with
    }' /proc/cpuinfo

#!/usr/bin/env bash
# porting.sh - docs/internals/porting.md: its commands run, every function of the platform API is named. (The template:
# ../template.sh.)
. "$(dirname "$0")/../pages.sh"

blocks docs/internals/porting.md

api() {
    grep -oE "^[A-Za-z0-9_ ]+ \*?plat_[a-z_]+\(" platform/platform.h | grep -v inline |
        grep -oE "plat_[a-z_]+\(" | tr -d '(' | sort -u
}
named() { # PAGE
    local f bad=0
    for f in $(api); do
        grep -q "$f" "$1" || { echo "$1: $f is not named"; bad=1; }
    done
    return $bad
}
check "the page names them all" named docs/internals/porting.md
finish

#!/usr/bin/env bash
# bulletml.sh - docs/measured/bulletml.md is a whole page of `make bulletml`: every document of the list is in its
# table, and none is out. libbulletml is not needed for this; what single elements do is tested by
# tests/machine/test_answers.c.
measured=bulletml
. "$(dirname "$0")/../measured.sh"
list=tools/lab/bulletml/documents.list

cat >"$scratch/sections" <<'END'
Every document
Restarted
Decided by the last bit
Speed
Pictures
END
names() { # LIST: as the page has them
    grep '^/' "$1" | sed -E 's,^/usr/share/(games|doc)/,,; s/\.xml$//'
}
whole() { # PAGE
    diff "$scratch/sections" <(sed -n 's/^## //p' "$1") || return 1
    diff <(names "$list") <(sed -n '/^## Every document/,/^## /p' "$1" | sed -nE 's/^\| ([^ |]+) \| [0-9].*/\1/p') ||
        return 1
    local n
    n=$(names "$list" | wc -l)
    grep -qF "| documents within 1/16 px | **$n of $n** |" "$1" || { echo "not all of $n are within"; return 1; }
    ! grep -qF '**out**' "$1" || { echo "a document is out"; return 1; }
}
check "docs/measured/bulletml.md has all documents, all within 1/16 px" whole "$page"
planted "a document that is missing" "< noiz2sa/boss/beewinder" '/^| noiz2sa\/boss\/beewinder /d' whole

# Every small document has its answer, and every answer its document.
pairs() {
    diff <(cd "$1" && ls ./*.xml | sed 's/\.xml$//') <(cd "$1" && ls ./*.out | sed 's/\.out$//')
}
check "tests/bulletml: each document has an answer" pairs tests/bulletml
finish

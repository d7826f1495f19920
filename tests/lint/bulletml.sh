#!/usr/bin/env bash
# bulletml.sh - docs/measured/bulletml.md is a whole page of `make bulletml`: every document of the list is in its
# table, and none is out. libbulletml is not needed for this; what single elements do is tested by
# tests/machine/test_answers.c.
measured=bulletml
. "$(dirname "$0")/../measured.sh"
list=tools/lab/bulletml/documents.list

whole() { # PAGE
    diff <(grep '^/' "$list" | sed -E 's,^/usr/share/(games|doc)/,,; s/\.xml$//') \
        <(sed -nE '/^## Every document/,/^## /s/^\| ([^ |]+) \| [0-9].*/\1/p' "$1") || return 1
    ! grep -qF '**out**' "$1" || { echo "a document is out"; return 1; }
}
check "docs/measured/bulletml.md has all documents, all within 1/16 px" whole "$page"
planted "a document that is missing" "< noiz2sa/boss/beewinder" '/^| noiz2sa\/boss\/beewinder /d' whole

pairs() { diff <(cd "$1" && basename -s .xml ./*.xml) <(cd "$1" && basename -s .out ./*.out); }
check "tests/bulletml: each document has an answer" pairs tests/bulletml
finish

#!/usr/bin/env bash
# bulletml.sh - docs/measured/bulletml.md is a whole page of `make bulletml`: every document of the list is in its
# table, and none is out. libbulletml is not needed for this; what single elements do is tested by
# tests/machine/test_answers.c.
measured=bulletml
. "$(dirname "$0")/../measured.sh"
list=tools/bulletml/documents.list

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
part() { # TITLE PAGE: what is below that heading
    awk -v title="## $1" '/^## /{ in_it = $0 == title } in_it' "$2"
}
whole() { # PAGE
    diff "$scratch/sections" <(sed -n 's/^## //p' "$1") || return 1
    diff <(names "$list") <(part "Every document" "$1" | sed -nE 's/^\| ([^ |]+) \| [0-9].*/\1/p') || return 1
    local n
    n=$(names "$list" | wc -l)
    grep -qF "| documents within 1/16 px | **$n of $n** |" "$1" || { echo "not all of $n are within"; return 1; }
    ! grep -qF '**out**' "$1" || { echo "a document is out"; return 1; }
    n=$(part Speed "$1" | grep -cE '^\| .* \| [0-9,]+ \|')
    [ "$n" = 24 ] || { echo "times are missing"; return 1; }
}
check "docs/measured/bulletml.md has all documents, all within 1/16 px, and all times" whole "$page"
planted "a document that is missing" "< noiz2sa/boss/beewinder" '/^| noiz2sa\/boss\/beewinder /d' whole
planted "a document that is out" "a document is out" 's/^\(| noiz2sa\/boss\/bit .*|\)  |$/\1 **out**: too far |/' whole
planted "fewer that are alike" "not all of 218" 's/218 of 218/217 of 218/' whole
planted "a time that is missing" "times are missing" '0,/^| straight | 4,000/{/^| straight | 4,000/d}' whole

# Every small document has its answer, and every answer its document.
pairs() {
    diff <(cd "$1" && ls ./*.xml | sed 's/\.xml$//') <(cd "$1" && ls ./*.out | sed 's/\.out$//')
}
check "tests/bulletml: each document has an answer" pairs tests/bulletml
cp -r tests/bulletml "$scratch/pairs" && rm "$scratch/pairs/two_tops.out"
detects "an answer that is missing" "< ./two_tops" pairs "$scratch/pairs"
finish

#!/usr/bin/env bash
# texts.sh - the repository speaks of itself only: no path of anybody's machine, no history of how it was written; and
# what its pages point to is there.
. "$(dirname "$0")/../tap.sh"

machine='\.\./shared|/work/|/tmp/w\b|/home/[a-z]|/Users/|\bsessions?[ -]?(id|log|number)|\bthis session\b'
machine="($machine|\\bAI (assistant|model|agent)|language model|\\bclaude\\b)"
undone='\b(TODO|FIXME)[: ]'
speaks() {
    local found
    found=$(grep -nIiE "$machine" "$@"; grep -nIE "$undone" "$@")
    echo "$found"
    [ -z "$found" ]
}
check "no file names a machine's paths or how it was written" speaks \
    $(tree | grep -v '^tests/lint/texts.sh$' | grep -v /seeds/)
echo 'see ../shared/DESIGN.md' >"$scratch/a.md"
detects "a path of a machine" "shared" speaks "$scratch/a.md" /dev/null
# Links of the pages, [text](target), to files that are here.
links() {
    local page target bad=0
    for page in "$@"; do
        for target in $(grep -oE '\]\([^)# ]+' "$page" | sed 's/^](//' | grep -vE '^[a-z]+:'); do
            [ -e "$(dirname "$page")/$target" ] || { echo "$page: there is no $target"; bad=1; }
        done
    done
    return $bad
}
check "the pages' links lead somewhere" links $(tree '*.md')
echo '[gone](nowhere.md)' >"$scratch/b.md"
detects "a link to nothing" "nowhere.md" links "$scratch/b.md"
finish

#!/usr/bin/env bash
# guide.sh - every example of docs/guide and docs/reference runs, every error shown is the one printed, and every API
# entry has an example.
. "$(dirname "$0")/../pages.sh"

for page in docs/guide/*.md docs/reference/{bulletml,command-line,mml,rom,settings}.md; do
    case $page in docs/guide/3[45]-*) ;; *) blocks "$page" ;; esac # from.sh runs 34 and 35
done
covers() { "$OUT/curtain-null" help lua | python3 tests/cli/snippets.py --cover "$@"; }
check "every API entry has an example" covers docs/guide/*.md docs/reference/rom.md

printf '%s\n' '```lua error' 'wait(1)' '```' '```' 'nothing' '```' >"$scratch/bad.md"
take "$scratch/bad.md"
detects "an error that is not raised" "no fault" block "$scratch/blocks/1.error"
detects "a page without an entry" "no example uses wait" covers "$scratch/bad.md"
finish

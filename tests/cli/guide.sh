#!/usr/bin/env bash
# guide.sh - every example of docs/guide and docs/reference runs, every error shown is the one printed, and every API
# entry has an example.
. "$(dirname "$0")/../pages.sh"

for page in docs/guide/*.md docs/reference/{bulletml,command-line,mml,rom,settings}.md; do
    case $page in docs/guide/3[45]-*) ;; *) blocks "$page" ;; esac # from.sh runs 34 and 35
done
covers() { "$OUT/curtain-null" help lua | python3 tests/cli/snippets.py --cover "$@"; }
check "every API entry has an example" covers docs/guide/*.md docs/reference/rom.md

# Planted: an example that faults, an error that reads differently, a page that leaves an entry out.
printf '%s\n' '```lua task' 'bullet.fire { kind = "orb", from = e }' '```' >"$scratch/bad.md"
take "$scratch/bad.md"
detects "an example that faults" "speed: expected" block "$scratch/blocks/1.task"
printf '%s\n' '```lua' 'bullet.def("ember", { sprite = "orb", hit = "none" })' '```' >"$scratch/bad.md"
take "$scratch/bad.md"
detects "a name that the sandbox has" "in the sandbox as it is" block "$scratch/blocks/1.lua"
printf '%s\n' '```lua error' 'wait(1)' '```' '```' 'nothing' '```' >"$scratch/bad.md"
take "$scratch/bad.md"
detects "an error that does not come" "no fault" block "$scratch/blocks/1.error"
{
    printf '%s\n' '```lua check' 'wait(1)' '```' '```' 'a finding' '```'
    printf '%s\n' '```lua rom error' 'return {}' '```' '```' 'refused' '```'
    printf '%s\n' '```lua main error' 'bullets.def("a", {})' '```' '```' 'main.lua:1: other' '```'
} >"$scratch/bad.md"
take "$scratch/bad.md"
detects "a finding that does not come" "a finding" block "$scratch/blocks/1.check"
detects "a rom.lua that is not refused" "no fault" block "$scratch/blocks/7.rom-error"
detects "another message" "main.lua:1: other" block "$scratch/blocks/13.main-error"
printf '%s\n' '```lua error' 'wait(1)' '```' '```' 'nothing' '```' >"$scratch/bad.md"
take "$scratch/bad.md"
detects "a page without an entry" "no example uses wait" covers "$scratch/bad.md"
finish

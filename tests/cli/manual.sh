#!/usr/bin/env bash
# manual.sh - every example of docs/manual.md runs, every error it shows is the one that comes, every API entry has one.
. "$(dirname "$0")/../pages.sh"

blocks docs/manual.md
covers() { "$OUT/curtain-null" help lua | python3 tests/cli/snippets.py --cover "$1"; }
check "every API entry stands in an example" covers docs/manual.md

# Planted: an example that faults, an error that reads differently, a page that leaves an entry out.
printf '%s\n' '```lua task' 'bullet.fire { kind = "orb", from = e }' '```' >"$scratch/bad.md"
take "$scratch/bad.md"
refuse "planted: an example that faults" "speed: expected" block "$scratch/blocks/1.task"
printf '%s\n' '```lua error' 'wait(1)' '```' '```' 'nothing' '```' >"$scratch/bad.md"
take "$scratch/bad.md"
refuse "planted: an error that does not come" "no fault" block "$scratch/blocks/1.error"
refuse "planted: a page without an entry" "no example uses wait" covers "$scratch/bad.md"
finish

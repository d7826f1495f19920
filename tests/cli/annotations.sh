#!/usr/bin/env bash
# annotations.sh - `curtain help lua --annotations`: it is Lua, it keeps to LuaLS's grammar, and it says of every entry,
# field, type, range and default what docs/reference/api.md says, which is made of the same table
# (tests/lint/docs.sh). And what does not go with the option.
. "$(dirname "$0")/../tap.sh"
curtain=$OUT/curtain-null
file=$scratch/curtain.lua

write() { "$curtain" help lua --annotations >"$file"; }
check "the file is written" write
check "it is Lua" "${LUAC:-luac5.4}" -p "$file"
check "it says what the table says" python3 tests/cli/annotations.py "$file" docs/reference/api.md
sed 's/@return bullet/@return/' "$file" >"$scratch/bad.lua"
detects "a type is missing" 'is no type' \
    python3 tests/cli/annotations.py "$scratch/bad.lua" docs/reference/api.md
full() { "$curtain" help lua --annotations >/dev/full; }
refuse "a disk that is full" "cannot write to standard output" full
refuse "with a name" "--annotations works only with curtain help lua --annotations" \
    "$curtain" help lua bullet.fire --annotations
finish

#!/usr/bin/env bash
# apidoc.sh - writes docs/reference/api.md from the API table that the board itself uses: every entry with its
# parameters.
#
#     tools/apidoc.sh [CURTAIN] > docs/reference/api.md
set -euo pipefail
cd "$(dirname "$0")/.."
curtain=${1:-build/curtain-null}

cat <<'END'
# The Lua API, entry by entry

`tools/apidoc.sh` generates this page from the table that Curtain uses to check arguments; `curtain help lua` prints the
same text. `name{...}` takes a table of named arguments, `thing:name()` is a method, and the return values follow `->`.
The brackets after an argument show its type, range and default.
END
properties() { "$curtain" help lua "$1" | sed -n '/^properties of/,$p'; } # THING
heading() {
    local lines
    printf '\n## %s\n' "$1"
    lines=$(properties "$1")
    [ -z "$lines" ] || printf '\n```\n%s\n```\n' "$lines"
}
# An entry is a line that does not begin with a blank.
entries=$("$curtain" help lua | grep '^[^ ]' | sed 's/   .*//')
section=
while IFS= read -r entry; do
    name=$(printf '%s\n' "$entry" | sed -E 's/^([A-Za-z_0-9]+([.:][A-Za-z_0-9]+)?).*/\1/')
    space=${name%%[.:]*}
    if [ "$space" != "$section" ]; then
        section=$space
        if [ "$space" = "$name" ]; then # a value: its properties are below, with its meaning
            printf '\n## %s\n' "$space"
        else
            heading "$space"
        fi
    fi
    printf '\n### %s\n\n```\n' "$name"
    "$curtain" help lua "$name"
    printf '```\n'
done <<<"$entries"
# Things that have properties and no functions.
sed -n 's/.* -> \([a-z]*\).*/\1/p' <<<"$entries" | sort -u | while read -r thing; do
    if ! grep -q "^$thing[.:]" <<<"$entries" && [ -n "$(properties "$thing" 2>/dev/null)" ]; then
        heading "$thing"
    fi
done

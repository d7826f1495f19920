#!/usr/bin/env bash
# docs.sh - the manual's API section is what the program says, and the program's help covers what it offers.
. "$(dirname "$0")/../tap.sh"
curtain=$OUT/curtain-null

current() { tools/apidoc.sh "$curtain" | diff "$1" -; }
check "docs/api.md is what tools/apidoc.sh writes" current docs/api.md
sed 's/required/needed/' docs/api.md >"$scratch/api.md"
refuse "planted: an old page" "(required)" current "$scratch/api.md"

# Every function the library hands to games has its help.
entries() { "$curtain" help lua | grep -c .; }
headings() { [ "$(grep -c '^### ' docs/api.md)" = "$(entries)" ] && [ "$(entries)" -gt 90 ]; }
check "every entry has its place on the page" headings
unknown() { "$curtain" help lua bullet.fyre; }
refuse "help for what is not there is refused" "bullet.fyre" unknown

commands() {
    local c
    for c in $("$curtain" help | sed -n 's/^  curtain \([a-z]*\) .*/\1/p'); do
        "$curtain" help "$c" | grep -q "^curtain $c" || { echo "help $c says nothing"; return 1; }
    done
}
check "every command has its help" commands
finish

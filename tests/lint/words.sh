#!/usr/bin/env bash
# words.sh - README.md, the manual, menus and messages have none of the words and phrases below, which are wrong in
# every sense. Words that have good uses, too, are left to review: tools/messages.sh lists the texts.
. "$(dirname "$0")/../tap.sh"

# Extended regular expressions, whole words, any case.
cat >"$scratch/words" <<'END'
anew
by turns
tube look
wait for the screen
what fits
a slip
once more
not taken in
is reported from
it is you who
who plays with which
can not stand
stands? here twice
dearest
gone on with
be given along
is no name
the seam
END
wrong="\\b($(paste -sd '|' "$scratch/words"))\\b"

pages() { ! grep -HniE "$wrong" "$@"; }
messages() { ! python3 tools/messages.py "$@" | grep -iE "^[^:]*:[0-9]+:.*$wrong"; }
help() {
    local command
    for command in '' play help config $("$OUT/curtain-null" help | sed -nE 's/^  curtain ([a-z]+) .*/\1/p'); do
        "$OUT/curtain-null" help $command || return
    done >"$scratch/help.md"
    pages "$scratch/help.md"
}
check "README.md and the manual" pages README.md $(tree 'docs/*.md') platform/web/page.html platform/web/player.js
check "menus and messages" messages $(tree 'src/*.[ch]' 'platform/*.[ch]' 'scripts/*.lua')
check "curtain help" help
printf '/* begins anew */\nconst char *c = "begins " "anew";\n' >"$scratch/b.c"
detects "in a message of several literals" "b.c:2: begins anew" messages "$scratch/b.c"
finish

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

pattern() { sed 's/.*/(&)/' "$scratch/words" | paste -sd '|'; }
words() { # FILE...: those of pages, whole; of C and Lua, the texts
    local found pages=() sources=() file
    for file in "$@"; do
        case $file in
        *.md | *.html | *.js) pages+=("$file") ;;
        *) sources+=("$file") ;;
        esac
    done
    found=$({
        [ ${#pages[@]} = 0 ] || grep -Hn '' "${pages[@]}" | sed 's/^\([^:]*:[0-9]*:\)/\1 /'
        [ ${#sources[@]} = 0 ] || python3 tools/messages.py "${sources[@]}"
    } | grep -iE "^[^:]*:[0-9]+:.*\\b($(pattern))\\b")
    echo "$found"
    [ -z "$found" ]
}

check "README.md and the manual" words README.md $(tree 'docs/*.md' 'docs/**/*.md' | sort -u)
check "menus and messages" words $(tree 'src/*.[ch]' 'platform/*.[ch]' 'scripts/*.lua') \
    platform/web/page.html platform/web/player.js
help() {
    local command page=$scratch/help.md
    for command in '' play help config $("$OUT/curtain-null" help | sed -nE 's/^  curtain ([a-z]+) .*/\1/p'); do
        "$OUT/curtain-null" help $command || return
    done >"$page"
    words "$page"
}
check "curtain help" help

printf '/* begins anew */\nconst char *c = "begins " "anew";\n' >"$scratch/b.c"
detects "in a message of several literals" "b.c:2: begins anew" words "$scratch/b.c"
echo 'They fire, By Turns.' >"$scratch/a.md"
detects "in a page" "By Turns" words "$scratch/a.md"
finish

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
is told from
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

# ALLOWED: lines "FILE: TEXT # REASON"; a line that has TEXT in FILE may have such a word. At most 20.
: >"$scratch/allowed"

pattern() { sed 's/.*/(&)/' "$scratch/words" | paste -sd '|'; }
allowed() { # drops what the list allows
    local file text line
    while IFS= read -r line; do
        while IFS= read -r entry; do
            file=${entry%%: *} text=${entry#*: }
            text=${text% # *}
            [[ $line == "$file:"*"$text"* ]] && continue 2
        done <"$scratch/allowed"
        printf '%s\n' "$line"
    done
}
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
    } | grep -iE "^[^:]*:[0-9]+:.*\\b($(pattern))\\b" | allowed)
    echo "$found"
    [ -z "$found" ]
}

check "the list of allowed lines is short" [ "$(wc -l <"$scratch/allowed")" -le 20 ]
check "every allowed line has a reason" sh -c '! grep -v ": .* # ." "$1"' - "$scratch/allowed"
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

# Planted faults.
echo 'The run begins anew.' >"$scratch/a.md"
detects "in a page" "a.md:1: The run begins anew" words "$scratch/a.md"
echo 'They fire, By Turns.' >"$scratch/a.md"
detects "in capitals" "By Turns" words "$scratch/a.md"
printf '/* begins anew */\nint renewed;\nconst char *c = "the game "\n                "begins " /* here */ "anew";\n' \
    >"$scratch/b.c"
detects "in a message of several literals" "b.c:3: the game begins anew" words "$scratch/b.c"
printf '/* begins anew */\nconst char *c = "a renewed manewver";\n' >"$scratch/c.c"
check "not in a comment, and not in a longer word" words "$scratch/c.c"
printf -- '-- anew\nsys.fail("at", "start it anew")\nprint("anew it goes")\n' >"$scratch/d.lua"
detects "in a fault of a script" "d.lua:2: start it anew" words "$scratch/d.lua"
check "other strings of scripts are the game's" sh -c '[ "$(python3 tools/messages.py "$1" | wc -l)" = 1 ]' - \
    "$scratch/d.lua"
cp "$scratch/allowed" "$scratch/before"
echo "$scratch/a.md: By Turns # a title" >>"$scratch/allowed"
check "a line that is allowed" words "$scratch/a.md"
cp "$scratch/before" "$scratch/allowed"
finish

#!/bin/sh
# cookbook.sh - what is made of the cookbook, roms/cookbook: `cookbook.sh` writes all of it anew.
#
#     roms/cookbook/book.txt     the words its window shows, from the first comment of each recipe
#     tests/cookbook/table       what each recipe comes to, which tests/cli/cookbook.sh compares
#     docs/images/cookbook       pictures, at the frames that the table names: FRAME:STEP, which are kept
#     docs/cookbook.md           words, pictures, code and prices
#
# `cookbook.sh --book`, `--table` and `--page` print the first, the second and the last.
set -eu
cd "$(dirname "$0")/../.."
out=${OUT:-build/release}
game=roms/cookbook table=tests/cookbook/table
frames=900

# The list of main.lua: lines "page NAME", and "chapter WORDS" for its comments.
list() {
    sed -n '/^local pages/,/^}/p' $game/main.lua | sed '1d; $d' |
        awk '/^ *--/ { sub(/^ *-- */, ""); print "chapter " $0; next }
             { n = split($0, word, "\""); for (i = 2; i <= n; i += 2) print "page " word[i] }'
}
pages() { list | sed -n 's/^page //p'; }

# A recipe's first comment as one line: TITLE|WORDS.
words() { # NAME
    awk '!/^--/ { exit } { sub(/^-- */, ""); s = s (NR > 1 ? " " : "") $0 }
         END { sub(/^[^ ]* - /, "", s); i = index(s, ": ")
               print substr(s, 1, i - 1) "|" toupper(substr(s, i + 2, 1)) substr(s, i + 3) }' "$game/recipes/$1.lua"
}
code() { awk '/^--/ && !on { next } { on = 1; print }' "$game/recipes/$1.lua"; } # NAME

book() { for page in $(pages); do echo "$page|$(words "$page")"; done; }

# Where the pictures of each page are taken: PAGE:FRAME:STEP.
moments() {
    pages | awk -v table="$table" '
        BEGIN { while ((getline line < table) > 0) { split(line, word, " "); at[word[1]] = word[2] } }
        { print $1 ":" ($1 in at ? at[$1] : "300:40") }'
}

# cookbook [-o DIR]: the program's lines, with the moments second.
run() {
    moments=$(moments)
    export moments
    # shellcheck disable=SC2086
    "$out/cookbook" $game $frames "$@" $moments | awk '
        BEGIN { split(ENVIRON["moments"], list, "\n") }
        { at = list[NR]; sub(/^[^:]*:/, "", at); $1 = $1 " " at; print }'
}

table() {
    echo "# page  pictures  hash after $frames frames  bullets, lasers at most  work: mean, most, least"
    run "$@"
}

comma() { sed -E ':a; s/([0-9])([0-9]{3})($|[ ,;])/\1,\2\3/; ta'; }
# What most pages have as their least work is the book's own, which looks at the buttons: that is not the recipe's.
book_work() { awk '!/^#/ { print $8 }' $table | sort | uniq -c | sort -rn | awk 'NR == 1 { print $2 }'; }
price() { # NAME
    awk -v page="$1" -v book="$(book_work)" '$1 == page {
        if ($4) s = s "at most " $4 " bullet" ($4 > 1 ? "s" : "") "; "
        if ($5) s = s "at most " $5 " laser" ($5 > 1 ? "s" : "") "; "
        printf "%s%.0f units of work a frame, at most %.0f\n", s, $6 - book, $7 - book }' $table | comma
}

page() {
    cat <<END
# The cookbook

Small patterns and effects, one a file in [roms/cookbook/recipes](../roms/cookbook/recipes), to look at and to copy.
\`curtain play roms/cookbook\` shows them: the arrows turn the pages, fire begins one again, and START closes the list,
so that the arrows fly the ship. \`curtain play roms/cookbook --stage flower\` begins at one, and
\`curtain render roms/cookbook --stage flower --frames 300 -o out\` makes a picture of it.

A file returns a task: \`f(e, p)\`, of an enemy \`e\`, with the player \`p\`. Some return a table with that task as
\`run\`, and \`ship\` or others besides; what they fire and who flies stands in
[kinds.lua](../roms/cookbook/kinds.lua). [The guide](README.md) explains what they are written in.

Below each is what it comes to in its first $frames frames: bullets and lasers at most at a time, and how much work it
is in a frame, on average and at most. A unit is about one instruction of Lua, and a call of the engine is 100 or more;
a frame may have 200,000,000. What flies, hits and is drawn comes on top:
[The guide](guide/21-capacities.md) has the prices. \`make cookbook\` writes this page.
END
    list | while read -r what name; do
        if [ "$what" = chapter ]; then
            printf '\n## %s\n' "$name"
            continue
        fi
        both=$(words "$name")
        printf '\n### %s\n\n%s\n\n' "${both%%|*}" "${both#*|}"
        printf '<img src="images/cookbook/%s.png" width="728" alt="%s, three moments">\n\n' "$name" "${both%%|*}"
        printf '```lua\n'
        code "$name"
        printf '```\n\n[%s.lua](../roms/cookbook/recipes/%s.lua): %s.\n' "$name" "$name" "$(price "$name")"
    done
}

case ${1-} in
--book) book ;;
--table) table ;;
--page) page ;;
*)
    mkdir -p docs/images/cookbook tests/cookbook
    [ -f $table ] || : >$table
    book >$game/book.txt
    rm -f docs/images/cookbook/*.png
    table -o docs/images/cookbook >$table.new
    mv $table.new $table
    page >docs/cookbook.md
    ;;
esac

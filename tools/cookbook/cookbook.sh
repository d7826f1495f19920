#!/bin/sh
# cookbook.sh - writes all files generated from the cookbook, roms/cookbook:
#
#     roms/cookbook/book.txt     the text of its window, from the first comment of each recipe
#     tests/cookbook/table       the results of each recipe, which tests/cli/cookbook.sh compares
#     docs/images/cookbook       pictures, taken at the frames in the table (FRAME:STEP), which a rewrite preserves
#     docs/cookbook.md           text, pictures, code and costs
#
# `cookbook.sh --book`, `--table` and `--page` print the first, second and last of them.
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
    echo "# page  pictures  hash after $frames frames  most bullets, lasers  work: mean, most, least"
    run "$@"
}

comma() { sed -E ':a; s/([0-9])([0-9]{3})($|[ ,;])/\1,\2\3/; ta'; }
# The least work of most pages is the book's own, for reading the buttons. It is not part of a recipe's cost.
book_work() { awk '!/^#/ { print $8 }' $table | sort | uniq -c | sort -rn | awk 'NR == 1 { print $2 }'; }
price() { # NAME
    awk -v page="$1" -v book="$(book_work)" '$1 == page {
        if ($4) s = s "up to " $4 " bullet" ($4 > 1 ? "s" : "") "; "
        if ($5) s = s "up to " $5 " laser" ($5 > 1 ? "s" : "") "; "
        printf "%s%.0f units of work per frame on average, %.0f at most\n", s, $6 - book, $7 - book }' $table | comma
}

# The part of canyon's main.lua under the heading NAME.
part() { sed -n "/^-- ---- $1/,/^-- ---- /p" examples/canyon/main.lua | sed '1,2d; $d' | sed '$d'; }

page() {
    cat <<END
# The cookbook

This is a collection of small patterns and effects to look at and copy, one per file in
[roms/cookbook/recipes](../roms/cookbook/recipes). \`curtain play roms/cookbook\` shows the recipes. The arrow keys turn
the pages, and fire restarts a recipe. START closes the list of recipes, so that the arrow keys move the ship. Press
START again to reopen the list.

\`curtain play roms/cookbook --stage flower\` starts at the recipe "flower", and
\`curtain render roms/cookbook --stage flower --frames 300 -o out\` renders it.

Most files return a task \`f(e, p)\`; \`e\` is an enemy and \`p\` the player. Others return a table that holds this task
as \`run\`, along with other fields such as \`ship\`. [kinds.lua](../roms/cookbook/kinds.lua) defines kinds for the
recipes; in your own game, define your own. [The guide](README.md) explains the API.

The line below each recipe shows its cost over the first $frames frames: the maximum number of bullets and lasers at the
same time, and the average and maximum work per frame. A unit of work is about one Lua instruction; an engine call costs
100 or more. A frame can use at most 200,000,000 units. Movement, hit tests and drawing cost extra, and [the
guide](guide/21-capacities.md) lists their costs. \`make cookbook\` writes this page.
END
    list | while read -r what name; do
        if [ "$what" = chapter ]; then
            printf '\n## %s\n' "$name"
            continue
        fi
        both=$(words "$name")
        printf '\n### %s\n\n%s\n\n' "${both%%|*}" "${both#*|}"
        printf '<img src="images/cookbook/%s.png" width="728" alt="%s at three moments">\n\n' "$name" "${both%%|*}"
        printf '```lua\n'
        code "$name"
        printf '```\n\n[%s.lua](../roms/cookbook/recipes/%s.lua): %s.\n' "$name" "$name" "$(price "$name")"
    done
    cat <<END

## A larger field

### A field wider than the screen

The canyon is twice as wide as the screen, and the camera follows the ship. The sea and the clouds are further away than
the cliffs, so they move less. This needs \`field = { w = 480, h = 320, view = { w = 240 } }\` in rom.lua, so it is [a
game](../examples/canyon/rom.lua) and not a page of the book.

<img src="images/canyon.png" width="728" alt="A field wider than the screen at three moments">

\`\`\`lua
$(part 'the camera')
\`\`\`

[main.lua](../examples/canyon/main.lua), and [the guide](guide/12-screen.md#a-field-wider-than-the-screen).
END
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

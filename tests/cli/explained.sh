#!/usr/bin/env bash
# explained.sh - `curtain help lua NAME` explains: every argument and property has a meaning, every entry an example
# that runs and a page of the guide (share/help). A build without help has none of these texts.
. "$(dirname "$0")/../pages.sh"
curtain=$OUT/curtain-null
api=docs/reference/api.md

for page in share/help/*.md; do blocks "$page"; done

headings() { # each names an entry, once
    local name
    cat "$@" | sed -n 's/^## //p' | sort >"$scratch/headings"
    [ -z "$(uniq -d "$scratch/headings")" ] || { echo "twice: $(uniq -d "$scratch/headings")"; return 1; }
    for name in $(cat "$scratch/headings"); do
        grep -qx "### $name" "$api" || { echo "$name is no entry"; return 1; }
    done
}
check "every example is of an entry" headings share/help/*.md

explained() { python3 tests/cli/explained.py "$1"; }
check "every entry is explained" explained "$api"
sed '/^### bullet:turn/,/^  Guide/{/^  Example:/,$d}' "$api" >"$scratch/api.md"
detects "no example" "bullet:turn has no example" explained "$scratch/api.md"

# The tables without help.
texts() { python3 tests/cli/explained.py --texts "$api" >"$scratch/texts" && [ -s "$scratch/texts" ]; }
check "the page has texts" texts
objects() { # FLAG...
    local file
    for file in $(find src/script/api -name '*.c'); do
        gcc -std=c11 -D_DEFAULT_SOURCE $(sed -n 's/^WARN *:= //p' Makefile) -Werror "$@" \
            $(pkg-config --cflags lua5.4 | sed 's/-I/-isystem /g') \
            -c "$file" -o "$scratch/$(basename "$file").o" || return
    done
}
silent() { # no object has a text
    ! LC_ALL=C grep -aoFf "$scratch/texts" "$scratch"/*.c.o | sort -u | head -5 | grep .
}
check "the tables compile without help" objects -DWITHOUT_HELP
check "and have none of its texts" silent
finish

#!/usr/bin/env bash
# stale.sh - lists the measured pages that are older than what they measure.
#
#     tools/docs/stale.sh [TABLE]     TABLE: tools/lab/README.md, whose rows name a page first and its directories last
#
# A page names its commit: "Measured at commit 1234567" or "from commit 1234567". One line for each page with newer
# commits, with another commit's name, or with none; nothing for a page that is up to date.
set -eu
cd "$(git rev-parse --show-toplevel)"
table=${1:-tools/lab/README.md}

rows() { # the page and its directories, which are the last cell
    sed -nE '/^\| \[/s/^\| \[[^]]*\]\(([^)]*)\) .* \| ([^|]*) \|$/\1 \2/p' "$table" | tr -d '`'
}
rows | while read -r page paths; do
    page=$(realpath -m --relative-to=. "$(dirname "$table")/$page")
    read -ra paths <<<"$paths :!roms/*/source/*"
    [ -f "$page" ] || { echo "$page: no such page"; continue; }
    commit=$(sed -nE 's/.*(Measured at|from) commit ([0-9a-f]{7,40}).*/\2/p' "$page" | head -n 1)
    if [ -z "$commit" ]; then
        echo "$page: names no commit"
    elif ! git cat-file -e "$commit^{commit}" 2>/dev/null; then
        echo "$page: this repository has no commit $commit"
    else
        newer=$(git rev-list --count "$commit..HEAD" -- "${paths[@]}")
        [ "$newer" = 0 ] || echo "$page: $newer commits since $commit, the last" \
            "$(git log -1 --format='%h (%cs)' -- "${paths[@]}")"
    fi
done

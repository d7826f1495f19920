#!/usr/bin/env bash
# Writes docs/survive.md: what `curtain survive` finds in every stage and every phase of Glass Tide at every difficulty,
# and on every page of the cookbook. Each run that is found is a demo, and verified. JOBS at a time (2).
set -eu
cd "$(dirname "$0")/.."
curtain=$PWD/${CURTAIN:-build/curtain-null}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
export curtain scratch

# One line: GAME SECTION [OPTION...]
look() {
    local game=$1 section=$2 name=${1##*/}-${2//\//-}
    shift 2
    "$curtain" survive "$game" --all --stage "$section" -o "$scratch/demos/$name" "$@" \
        >"$scratch/$name.table" 2>"$scratch/$name.said" || [ $? = 1 ]
    find "$scratch/demos/$name" -name '*.demo' 2>/dev/null | sort >"$scratch/$name.list"
    "$curtain" verify "$game" - <"$scratch/$name.list" >"$scratch/$name.verified" 2>&1 || [ ! -s "$scratch/$name.list" ]
}
export -f look
# A game's sections: of each two frames are looked at.
sections() {
    "$curtain" survive "$1" --all --frames 2 --difficulty normal --json 2>/dev/null |
        sed 's/^{"section":"\([^"]*\)".*/\1/'
}
phases=$(sections roms/glasstide)
pages=$(sections roms/cookbook)
{
    for phase in $phases; do echo "roms/glasstide $phase"; done
    for page in $pages; do echo "roms/cookbook $page --difficulty normal"; done
} | xargs -P "${JOBS:-2}" -I{} bash -c 'look {}'

# The rows of a game, as a table of the page.
rows() {
    local game=$1 section
    shift
    echo '```text'
    head -n 1 "$scratch/$game-${1//\//-}.table"
    for section; do sed 1d "$scratch/$game-${section//\//-}.table"; done
    echo '```'
    echo
    cat "$scratch/$game"-*.verified | awk '/: holds,/ { n++ } END { print n + 0 " demos hold." }'
}
{
    cat <<'TEXT'
# What can be survived

Written by `make survive`: what `curtain survive` finds in every stage and every phase of a boss of *Glass Tide*, at
every difficulty, and on every page of the cookbook. [Chapter 29 of the manual](manual.md#29-can-it-be-survived) says
what the columns mean, and what they cannot say. Each run that was found is a demo that `curtain verify` was given.

`gap px` is the width of a ship that could still fly through, as far as that was tried (36 px); `last` is how many
seconds sixteen simple bots last, on average; `reaction` is in frames.

TEXT
    echo "## Glass Tide"
    echo
    rows glasstide $phases
    echo
    echo "What is harder where it should be easier:"
    echo
    cat "$scratch"/glasstide-*.said | sed 's/^curtain: /* /' | grep . || echo "Nothing."
    echo
    echo "## The cookbook"
    echo
    rows cookbook $pages
} | sed 's/ *$//' >docs/survive.md

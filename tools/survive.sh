#!/usr/bin/env bash
# What can be survived, and how hard it is: `curtain survive` in every stage and every phase of Glass Tide at every
# difficulty, and on every page of the cookbook; and bots that fly through all of Glass Tide, for its curves. Writes
# docs/measured/survive.md, docs/measured/game.md, and the demo of each phase in tests/demos/phases. JOBS at a time (4);
# ONLY='crab queen' looks at these alone and writes no page.
#
#     tools/survive.sh --pages FOLDER     the pages once more, of what an earlier run left there
set -eu
cd "$(dirname "$0")/.."
curtain=$PWD/${CURTAIN:-build/curtain-null}
phases=tests/demos/phases
export curtain

# One line: FOLDER GAME SECTION DIFFICULTY. A line of JSON, and a demo beside it.
look() {
    local at=$1 game=$2 section=$3 difficulty=$4 name
    name=${game##*/}-${section//[\/:]/-}-$difficulty
    "$curtain" survive "$game" --all --stage "$section" --difficulty "$difficulty" --json --prints seconds \
        -o "$at/demos/${game##*/}" >"$at/$name.all" 2>"$at/$name.said" || [ $? = 1 ]
    # a stage's bosses have the stage's name too
    grep -F "\"section\":\"$section\"," "$at/$name.all" >"$at/$name.json" || true
}
export -f look

# One line: FOLDER SECTION. Bots in all of it, at each difficulty: lines of JSON.
fly() {
    "$curtain" survive roms/glasstide --all --stage "$2" --bots 32 --json \
        >"$1/bots-${2//[\/:]/-}.json" 2>/dev/null || true
}
export -f fly

# The sections of a game at all its difficulties, each GAME SECTION DIFFICULTY: of each two frames are looked at.
sections() { # GAME [OPTION...]
    "$curtain" survive "$@" --all --frames 2 --json 2>/dev/null |
        sed 's,^{"section":"\([^"]*\)"\,"difficulty":"\([^"]*\)".*,'"$1"' \1 \2,'
}

if [ "${1:-}" = --pages ]; then
    exec python3 tools/survive_pages.py "$2"
fi
scratch=$(mktemp -d)
[ -n "${KEEP:-}" ] || trap 'rm -rf "$scratch"' EXIT
mkdir -p "$scratch/demos/glasstide" "$scratch/demos/cookbook"
started=$SECONDS
{
    sections roms/glasstide
    [ -n "${ONLY:-}" ] || sections roms/cookbook --difficulty normal
} >"$scratch/list"
if [ -n "${ONLY:-}" ]; then
    grep -E " (${ONLY// /|})([/:]| )" "$scratch/list" >"$scratch/some" && mv "$scratch/some" "$scratch/list"
fi
# Stages take longest, and hard ones longer: these first.
sort -t ' ' -k 1,1r -k 2,2 "$scratch/list" |
    awk '{ print ($2 ~ /\// ? 1 : 0) ($3 == "abyss" ? 0 : $3 == "hard" ? 1 : 2), $0 }' | sort -s -k 1,1 |
    cut -d ' ' -f 2- | xargs -P "${JOBS:-4}" -I{} bash -c "look $scratch {}"
echo "$(wc -l <"$scratch/list") sections in $((SECONDS - started)) s"
awk '/roms\/glasstide/ { print $2 }' "$scratch/list" | sort -u | xargs -P "${JOBS:-4}" -I{} bash -c "fly $scratch {}"
echo "and bots, after $((SECONDS - started)) s"
if [ -n "${ONLY:-}" ]; then
    cat "$scratch"/*.json | cut -c 1-160
    exit
fi
# The demos of phases stay: of stages they say less than a whole game does.
mkdir -p $phases
rm -f $phases/*.demo
for json in "$scratch"/glasstide-*.json; do
    name=$(basename "$json" .json)
    demo=$scratch/demos/glasstide/${name#glasstide-}.demo
    if grep -q '"section":"[^"]*/' "$json" && [ -f "$demo" ]; then cp "$demo" $phases/; fi
done
find "$scratch/demos" -name '*.demo' | sort >"$scratch/all"
for game in glasstide cookbook; do
    grep "/$game/" "$scratch/all" | "$curtain" verify roms/$game - >"$scratch/$game.verified" 2>&1 || true
done
python3 tools/survive_pages.py "$scratch"

#!/usr/bin/env bash
# docs.sh - docs/reference/api.md is what the program says, and the program's help covers what it offers. README has
# the figures of docs/measured/proof.txt, and the glossary's files exist.
. "$(dirname "$0")/../tap.sh"
curtain=$OUT/curtain-null

current() { tools/apidoc.sh "$curtain" | diff "$1" -; }
check "docs/reference/api.md is what tools/apidoc.sh writes" current docs/reference/api.md
sed 's/required/needed/' docs/reference/api.md >"$scratch/api.md"
detects "an old page" "(required)" current "$scratch/api.md"

# As docs/measured/proof.txt says it: "prove: 24 functions, 124238115279 inputs, 0 misrounded", with commas.
figures() { # README
    local said
    said=$(sed -n 's/^prove: //p' docs/measured/proof.txt | sed -E ':a; s/([0-9])([0-9]{3})($|[ ,])/\1,\2\3/; ta')
    tr '\n' ' ' <"$1" | grep -qF "$said" || { echo "$1 does not say: $said"; return 1; }
}
check "README has the proofs' figures" figures README.md

# The glossary: sorted, every word once, every file there.
glossary() {
    awk '/^## /{ on = $0 == "## Words" } on' "$1" | grep '^| ' | sed '1d' >"$scratch/words"
    cut -d '|' -f 2 "$scratch/words" | tr -d '@' | tr '[:upper:]' '[:lower:]' | sort -fc || return 1
    sed -n 's/.*| `\([^`]*\)` |$/\1/p' "$scratch/words" | while read -r file; do
        [ -f "$file" ] || { echo "there is no $file"; return 1; }
    done
}
check "every word of the glossary lives in a file" glossary docs/internals/glossary.md
sed 's,`fb/stamp.h`,`fb/gone.h`,' docs/internals/glossary.md >"$scratch/glossary.md"
detects "a word without a file" "there is no fb/gone.h" glossary "$scratch/glossary.md"
finish

#!/usr/bin/env bash
# root.sh - the repository's root holds only what belongs there, so that output of a test or a game is never committed.
. "$(dirname "$0")/../tap.sh"

allowed=".ci .clang-format .editorconfig .gitignore CHANGELOG.md CONTRIBUTING.md LICENSE Makefile README.md
    docs examples fb platform roms scripts share src tests tools"

# entries DIR: the names in it that are tracked or staged; without git, all names but that of the build directory.
entries() {
    if [ "$(git -C "$1" rev-parse --show-prefix 2>/dev/null || echo none)" = "" ]; then
        git -C "$1" ls-files | cut -d / -f 1 | sort -u
    else
        ls -A "$1" | grep -vx build
    fi
}

root() { # DIR
    local name bad=0
    while IFS= read -r name; do
        printf '%s\n' $allowed | grep -qxF -- "$name" && continue
        echo "$name: unexpected file in the repository's root; remove it, or list it in tests/lint/root.sh"
        bad=1
    done < <(entries "$1")
    for name in $allowed; do
        [ -e "$1/$name" ] && continue
        echo "$name: listed in tests/lint/root.sh, but missing"
        bad=1
    done
    return $bad
}
check "the root holds what belongs there" root .

git clone -q . "$scratch/root"
echo 1 >"$scratch/root/keys.demo"
git -C "$scratch/root" add keys.demo
detects "a stray file" "keys.demo: unexpected file" root "$scratch/root"
finish

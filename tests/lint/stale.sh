#!/usr/bin/env bash
# stale.sh - `make docs-stale` lists the pages that are older than what they measure, and its table names what exists.
. "$(dirname "$0")/../tap.sh"

missing() { # pages or directories of the table that are not there
    sed -nE '/^\| \[/s/^\| \[[^]]*\]\(([^)]*)\) .* \| ([^|]*) \|$/tools\/lab\/\1 \2/p' tools/lab/README.md | tr -d '`' |
        xargs ls -d >/dev/null
}
check "every page and directory of tools/lab/README.md is there" missing

# A repository with a commit for each page, then one that changes engine/.
mkdir "$scratch/repo" && cd "$scratch/repo" || exit 2
git init -q . && git config user.name - && git config user.email -
save() { git add -A && git commit -qm "$1" && git rev-parse --short HEAD; }
mkdir engine other && echo 1 | tee engine/a >other/b
before=$(save before)
for page in old fresh; do printf '# A page\n\nMeasured at commit %s (2026-01-01).\n' "$before" >$page.md; done
echo "Measured at commit 0123456789ab." >lost.md
echo "# No commit" >none.md
for row in old:engine fresh:other lost:other none:other gone:other; do
    printf '| [%s.md](%s.md) | `make x` | | `%s` |\n' "${row%:*}" "${row%:*}" "${row#*:}"
done >table
echo 2 >engine/a
after=$(save after)
same "old pages, lost commits and pages without a commit are listed" "old.md: 1 commits since $before, the last $after
lost.md: this repository has no commit 0123456789ab
none.md: names no commit
gone.md: no such page" "$("$repo/tools/docs/stale.sh" table | sed 's/ (20[0-9-]*)$//')"
finish

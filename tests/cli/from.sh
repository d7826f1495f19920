#!/usr/bin/env bash
# from.sh - the migration pages, docs/guide/34 and 35: their examples run, and every Curtain name in their tables
# exists.
. "$(dirname "$0")/../pages.sh"

both=(docs/guide/34-coming-from.md docs/guide/35-coming-from-danmokou.md)
for page in "${both[@]}"; do blocks "$page"; done
there() { tests/cli/from.py "$OUT/curtain-null" "$@"; }
check "every name in the tables is Curtain's" there "${both[@]}"
sed 's/`bullet.fire /`bullet.fyre /' "${both[@]}" >"$scratch/from.md"
detects "a name that does not exist" "Curtain has no bullet.fyre" there "$scratch/from.md"
finish

#!/usr/bin/env bash
# from.sh - the migration pages, docs/guide/34 and 35: their examples run, and every Curtain name in their tables
# exists.
. "$(dirname "$0")/../pages.sh"

both=(docs/guide/34-coming-from.md docs/guide/35-coming-from-danmokou.md)
for page in "${both[@]}"; do blocks "$page"; done
there() { tests/cli/from.py "$OUT/curtain-null" "$@"; }
check "every name in the tables is Curtain's" there "${both[@]}"
cat "${both[@]}" >"$scratch/pages.md"
planted() { # WORDS IN WHAT
    sed "s|$2|$3|" "$scratch/pages.md" >"$scratch/from.md"
    ! cmp -s "$scratch/pages.md" "$scratch/from.md" || { echo "nothing is planted"; return 0; }
    there "$scratch/from.md"
}
while read -r want was is; do
    detects "$is" "Curtain has no $want" planted "$want" "$was" "$is"
done <<'END'
bullet.fyre `bullet.fire `bullet.fyre
bullet.clean `bullet.clear `bullet.clean
b:delete `b:remove() `b:delete()
b.angle `b.dir` `b.angle`
e:fly `e:move `e:fly
e.armor `e.rate` `e.armor`
p.invincible `p.safe` `p.invincible`
clouds `cloud` `clouds`
survival `survive `survival
spritesheets `sheets` `spritesheets`
--hardness `--difficulty` `--hardness`
END
detects "hardly a name" "0 names" there README.md
finish

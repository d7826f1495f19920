#!/usr/bin/env bash
# from.sh - docs/guide/34-coming-from.md: its examples run, and every name of Curtain in its tables is one.
. "$(dirname "$0")/../pages.sh"

blocks docs/guide/34-coming-from.md
there() { tests/cli/from.py "$1" "$OUT/curtain-null"; }
check "every name in its tables is Curtain's" there docs/guide/34-coming-from.md
planted() { # WORDS IN WHAT
    sed "s|$2|$3|" docs/guide/34-coming-from.md >"$scratch/from.md"
    ! cmp -s docs/guide/34-coming-from.md "$scratch/from.md" || { echo "nothing is planted"; return 0; }
    there "$scratch/from.md"
}
while read -r want was is; do
    refuse "planted: $is" "Curtain has no $want" planted "$want" "$was" "$is"
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
refuse "planted: hardly a name" "0 names" there README.md
finish

#!/usr/bin/env bash
# survive.sh - `curtain survive`: sets of bullets of which it is known whether they can be survived
# (tests/survive/game/main.lua says why), what it says and writes, and what it refuses.
. "$(dirname "$0")/../tap.sh"
sets=$repo/tests/survive
sandbox
cp -r "$sets/game" planted
mkdir planted/art known
python3 "$repo/tests/cli/png_make.py" planted/art/all.png 16 16 ffffff

# unhurt DEMO: it holds, comes to the end of its stage, and nobody dies in it
unhurt() {
    "$curtain" verify --json planted "$1" >"$1.json" || return 1
    grep -q '"verdict":"holds"' "$1.json" && grep -q '"kind":"clear"' "$1.json" && ! grep -q '"kind":"death"' "$1.json"
}

# known SET BUTTONS: those bring a ship through it
known() {
    local press=()
    [ "$2" = - ] || press=(--press "$2")
    "$curtain" hash planted --stage "$1" --frames 190 "${press[@]}" --record "known/$1.demo" >/dev/null &&
        unhurt "known/$1.demo"
}

# way SET: one is found, and the demo of it is one
way() {
    "$curtain" survive planted --stage "$1" --json -o "$1.demo" >"$1.said" || { cat "$1.said"; return 1; }
    grep -q '"verdict":"survived"' "$1.said" && unhurt "$1.demo"
}

# proved SET: there is none, which is proved: no demo, but a picture
proved() {
    "$curtain" survive planted --stage "$1" --json -o "$1.demo" >"$1.said"
    [ $? = 1 ] || { cat "$1.said"; return 1; }
    grep -q '"verdict":"cannot"' "$1.said" || { cat "$1.said"; return 1; }
    [ ! -e "$1.demo" ] && identify "$1.png" >/dev/null
}

while read -r set buttons; do
    check "$set: the known buttons bring a ship through" known "$set" "$buttons"
    check "$set: a way is found, and its demo holds" way "$set"
done < <(grep -v '^#' "$sets/known")
cannot=$(grep -oE '^  cannot_[a-z_]+' "$sets/game/main.lua")
for set in $cannot; do check "$set: it is proved" proved "$set"; done

# ---- what it says ----

says() { # WORDS ARGUMENT...
    local words=$1
    shift
    "$curtain" survive planted "$@" >said 2>&1
    grep -qF -- "$words" said || { cat said; return 1; }
}
check "of a way: its length" says ": survived: frames" --stage can_gap -o a.demo
check "of a proof: what it rests on" says "flew identically in 8 more runs" --stage cannot_gap -o b.demo
check "where bullets go after the ship, nothing is proved" \
    says "so nothing can be proved" --stage cannot_but_reacts --effort 1 -o c.demo
check "how far it was to look" says "the section continues" --stage can_rest --frames 60 -o d.demo
check "the map" says "map.png" --stage can_zigzag --map map.png -o e.demo
colours() { convert map.png -gravity south -crop x54+0+0 -format %c histogram:info: | grep -c "100: .*$1"; }
same "its legend has the two colours, each a square of 10 px" "1 1" "$(colours 20D050) $(colours 3070FF)"
cp -r planted broken
sed -i 's/can_rest = function() /&wait(20) error("planted fault") /' broken/main.lua
refuse "a script's fault is said as ever" "planted fault" "$curtain" survive broken --stage can_rest
same "the same each time" "$("$curtain" survive planted --stage can_ring --json -o f.demo; sha256sum <f.demo)" \
    "$("$curtain" survive planted --stage can_ring --json -o f.demo; sha256sum <f.demo)"

# ---- difficulties ----

check "an easier difficulty that is harder is reported" says "upside_down: easy is harder than hard" --all \
    --stage upside_down
same "and is exit code 1" 1 "$("$curtain" survive planted --all --stage upside_down >/dev/null 2>&1; echo $?)"
"$curtain" survive planted --all --json --stage can_gap >said 2>/dev/null
same "a JSON line a difficulty" 2 "$(grep -c '"section":"can_gap"' said)"
check "the demos of all go into a folder" eval \
    '"$curtain" survive planted --all --stage can_gap -o all >/dev/null && unhurt all/can_gap-hard.demo'
check "one of the difficulties alone" says "can_gap                  hard" --all --stage can_gap --difficulty hard

# ---- bots that fly on ----

check "bots alone: an easier difficulty that is harder" \
    says "hits per minute, compared with" --all --stage upside_down --bots 8
"$curtain" survive planted --all --stage parts --difficulty hard --bots 16 >said 2>&1
same "a stage is flown in parts" "parts parts:rain parts:rest" "$(awk 'NR > 1 { print $1 }' said | xargs)"
same "before its first mark nobody is hit" 0 "$(awk '$1 == "parts" { print $5 }' said)"
check "in the rain all are, who fly on and are hit again" [ "$(awk '$1 == "parts:rain" { print $5 }' said)" -gt 16 ]
same "after it nobody" 0 "$(awk '$1 == "parts:rest" { print $5 }' said)"
check "one section alone" says "hits per minute:" --stage parts:rain --bots 16
"$curtain" survive planted --stage parts:rain --bots 16 --json >said
same "JSON: the kinds" "4 6 6" "$(grep -o '"of":[0-9]*' said | cut -d: -f2 | xargs)"
check "JSON: their hits" grep -q '"wander":{"lived":[0-9]*,"of":6,"hits":[1-9][0-9]*,"flown":[1-9]' said
same "bots alone: the same each time" "$(sha256sum <said)" \
    "$("$curtain" survive planted --stage parts:rain --bots 16 --json | sha256sum)"

# ---- what it refuses ----

bad() { refuse "$1" "$2" "$curtain" survive "${@:3}"; } # NAME TEXT ARGUMENT...
bad "bots and a demo" "--bots cannot be combined with -o: bots do not search" planted --bots 8 -o a.demo
bad "all of what is not there" "no such stage or boss" planted --all --stage nowhere
finish

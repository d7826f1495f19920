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
    [ ! -e "$1.demo" ] && python3 "$repo/tests/cli/png_read.py" "$1.png" >"$1.text"
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
check "of a way: its length" says "can_gap: survived: frames" --stage can_gap -o a.demo
check "of a way: what it was measured by" says "narrowest gap      at least 4." --stage can_gap -o a.demo
check "of a proof: what it rests on" says "flew identically in 8 more runs" --stage cannot_gap -o b.demo
check "where bullets go after the ship, nothing is proved" \
    says "so nothing can be proved" --stage cannot_but_reacts --effort 1 -o c.demo
check "no demo of it" [ ! -e c.demo ]
check "but a picture" [ -s c.png ]
check "how far it was to look" says "the section continues" --stage can_rest --frames 60 -o d.demo
check "the map" says "map.png" --stage can_zigzag --map map.png -o e.demo
check "which is a PNG" [ -s map.png ]
same "its legend has the two colours, each a square of 10 px, and no more" "100 100" "$(python3 - "$repo" <<'PY'
import sys
sys.path.insert(0, sys.argv[1] + "/tests/golden")
import png
w, h, rows = png.read("map.png")
below = b"".join(rows[h - 54:])
pixels = [below[i:i + 3] for i in range(0, len(below), 3)]
print(pixels.count(b"\x20\xd0\x50"), pixels.count(b"\x30\x70\xff"))
PY
)"
cp -r planted broken
sed -i 's/^boot.run.*/stage.def("fault", function() wait(20) error("planted fault") end)\n&/
    s/stages = names/stages = { "fault" }/' broken/main.lua
refuse "a script's fault is said as ever" "planted fault" "$curtain" survive broken --stage fault
same "and is exit code 2" 2 "$("$curtain" survive broken --stage fault >/dev/null 2>&1; echo $?)"
refuse "and of bots that fly on" "planted fault" "$curtain" survive broken --stage fault --bots 4
same "and is exit code 2 of theirs" 2 "$("$curtain" survive broken --stage fault --bots 4 >/dev/null 2>&1; echo $?)"
same "the same each time" "$("$curtain" survive planted --stage can_ring --json -o f.demo; sha256sum <f.demo)" \
    "$("$curtain" survive planted --stage can_ring --json -o f.demo; sha256sum <f.demo)"

# ---- difficulties ----

sed -i 's/^  sheets/  difficulties = { "easy", "hard" }, difficulty = "easy",\n&/' planted/rom.lua
cat >>planted/main.lua <<'LUA'
stage.def("upside_down", function()
  for i = 1, board.difficulty() == "easy" and 30 or 2 do
    bullet.fire { kind = "orb", x = i * 3, y = -8, speed = 2 }
    wait(2)
  end
  wait(90)
  stage.clear()
end)
LUA
sed -i 's/^boot.run/table.insert(names, "upside_down")\n&/' planted/main.lua
python3 - <<'PY'
text = open("planted/main.lua").read()
at = text.index("table.insert(names")
end = text.index("\n", text.index("boot.run", at)) + 1
open("planted/main.lua", "w").write(text[:at] + text[end:] + text[at:end])
PY
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
same "bots alone: and is exit code 1" 1 \
    "$("$curtain" survive planted --all --stage upside_down --bots 8 >/dev/null 2>&1; echo $?)"
cat >>planted/main.lua <<'LUA'
stage.def("parts", function()
  wait(120)
  stage.mark("rain")
  for i = 1, 120 do
    bullet.fire { kind = "orb", x = 4 + i * 53 % 232, y = -8, speed = 4 }
    wait(2)
  end
  wait(90)
  stage.mark("rest")
  wait(120)
  stage.clear()
end)
table.insert(names, "parts")
LUA
python3 - <<'PY'
text = open("planted/main.lua").read()
at = text.index("boot.run")
end = text.index("\n", at) + 1
open("planted/main.lua", "w").write(text[:at] + text[end:] + text[at:end])
PY
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
bad "no such folder" "nowhere: no such file or folder" nowhere
bad "no such stage" "nowhere" planted --stage nowhere
bad "no such difficulty" 'unknown difficulty "mild"' planted --difficulty mild
bad "an effort that is none" "--effort: expected a whole number from 1 to 1000" planted --effort 0
bad "bots that are none" "--bots: expected a whole number from 1 to 1000" planted --bots 0
bad "bots and a demo" "--bots cannot be combined with -o: bots do not search" planted --bots 8 -o a.demo
bad "bots and effort" "--bots cannot be combined with --effort" planted --bots 8 --effort 2
bad "several lengths" "--frames: survive takes one number" planted --frames 60,90
bad "a length of nothing" "--frames: survive takes one number" planted --frames 0
bad "all of it and a map" "--all cannot be combined with --map" planted --all --map a.png
bad "all of what is not there" "no such stage or boss" planted --all --stage nowhere
bad "a map that cannot be written" "cannot be written" planted --stage can_rest --frames 9 --map planted/rom.lua/a.png
bad "a demo that cannot be written" "planted/rom.lua/a.demo" planted --stage can_rest --frames 9 \
    -o planted/rom.lua/a.demo
refuse "a map for another command" "--map does not work with hash (only with survive)" \
    "$curtain" hash planted --map a.png
finish

#!/usr/bin/env bash
# new.sh - curtain new: the games it writes are those of examples/, named by their folder, and pass check; no folder is
# written over, and where there is no room nothing is left behind.
. "$(dirname "$0")/../tap.sh"
sandbox

# What is in a game's folder but for id, title, and what is for editors.
plain() { (cd "$1" && find . -type f ! -name '.*' | sort | while read -r f; do
    echo "$f"
    sed -E '1,4s/id = "[^"]*"/id/; 1,4s/title = "([^"\\]|\\.)*"/title/; 1s/^# .*/#/' "$f" | cksum
done); }
for from in first pattern shooter bulletml; do
    check "a new $from" "$curtain" new "$from" --from "$from"
    check "it is examples/$from" diff <(plain "$repo/examples/$from") <(plain "$from")
    check "it packs, and runs" "$curtain" hash "$from" --frames 60 --every 60
    check "its test holds" "$curtain" test "$from"
done
check "without --from it is the shooter" "$curtain" new plain
check "the API is beside it, for editors" diff <("$curtain" help lua --annotations) plain/.curtain.lua
check "and what they read first, as the guide has it" python3 - "$repo/docs/guide/26-editors.md" <<'PY'
import json, re, sys
text = re.findall(r"```\n(\{.*?\})\n```", open(sys.argv[1], encoding="utf-8").read(), re.S)
assert json.load(open("plain/.luarc.json")) in [json.loads(t) for t in text]
PY

# ---- names ----

named() { # DIR ID TITLE: rom.lua has these, the packer takes them, and check has nothing to say
    "$curtain" new "$1" >said || { cat said; return 1; }
    grep -qF "id = \"$2\", title = \"$3\"," "$1/rom.lua" || { grep -m1 title "$1/rom.lua"; return 1; }
    "$curtain" check "$1" && "$curtain" pack "$1" -o named.rom && "$curtain" hash named.rom --frames 30 --every 30
}
check "a name with blanks" named "Star Fall 2" star_fall_2 "Star Fall 2"
check "with letters that the font has not" named 弾幕 game_c59a975f "Lantern Night"
check "with quotes" named 'a "b" c'"'s" a_b_c_s 'a \"b\" c'"'s"
many() { printf "$1%.0s" $(seq "$2"); }
check "longer than an id" named "$(many x 60)" "$(many x 31)" "$(many x 60)"
check "longer than a title, cut between two letters" named "$(many ü 60)" game_c293e7c5 "$(many ü 31)"
check "the last of a path, which is made" named deep/er/Moth moth Moth
check "that begins with a dash" bash -c "'$curtain' new -- -dash && grep -q 'id = \"dash\"' ./-dash/rom.lua"
mkdir hollow
check "a folder that is there, and empty" named hollow hollow hollow
ids() { sed -nE '1,4s/.*id = "([^"]*)".*/\1/p' "$1/rom.lua"; }
"$curtain" new 幕弾 >said
check "two names that leave nothing over are two ids" test "$(ids 弾幕)" != "$(ids 幕弾)"
next() { # what is said can be done
    local line n=0
    while read -r line; do
        eval "$line" || return
        n=$((n + 1))
    done < <("$curtain" new "$1" | sed -n 's/^  \(curtain [a-z]* *\(\x27.*\x27\|[^ ]*\)\)  .*/\1/p')
    [ $n = 3 ] || { echo "$n lines"; return 1; }
}
curtain() {
    [ "$1" != play ] || set -- hash "${@:2}" --frames 9
    "$curtain" "$@" >/dev/null
}
check "what it says next can be typed" next "what's next"

# ---- what is refused ----

again=$(cksum plain/main.lua)
input_error "a folder that has files" 'plain: this folder is not empty; choose a new or empty one' new plain
same "nothing in it was touched" "$again" "$(cksum plain/main.lua)"
: >file
input_error "a file" 'file: a file with this name exists; choose another name' new file
input_error "a folder without a name" 'new: "." is not a valid game name; expected a folder to create' new .
input_error "nothing" 'new: "" is not a valid game name; expected a folder to create' new ''
input_error "part of a game's name" '--from: expected bulletml, first, pattern or shooter, got "sho"' new a --from sho
input_error "another game" '--from: expected bulletml, first, pattern or shooter, got "shoter"' new a --from shoter
help_names_all() {
    local game
    for game in $("$curtain" new a --from none 2>&1 | sed 's/.*expected //;s/, got.*//;s/,//g;s/ or / /'); do
        "$curtain" help new | tr '\n' ' ' | grep -q "[ ,]$game (" || { echo "the help lacks $game"; return 1; }
    done
}
check "its help names all of them" help_names_all
check "nothing of these is there" test ! -e a
line=$("$curtain" new told 2>&1 >/dev/full)
same "standard output is full: the game is there, and that is said" '3 curtain: cannot write to standard output yes' \
    "$? $line $([ -f told/main.lua ] && echo yes)"

if small_disk full size=64k; then
    mkdir full/empty
    "$curtain" new full/game >said 2>&1
    same "a full disk" 3 $?
    check "which file, and why, is said in a line" grep -Exq \
        'curtain: full/game/[a-z./]+: cannot be written \(No space left on device\)' said
    "$curtain" new full/empty >said 2>&1
    same "and nothing of it is left" 'full full/empty' "$(find full | tr '\n' ' ' | sed 's/ $//')"
fi

# ---- an id that is missing ----

cp -r plain copy
check "a copy is the same game" test "$(ids copy)" = plain
sed -i 's/id = "plain", //' copy/rom.lua
missing="rom.lua: no id, so the folder's name is used: if you rename the folder, the game loses its demos, saves and \
scores; add id = \"copy\""
same "check says when an id is missing" "$missing"$'\n'"1 problem 1" "$("$curtain" check copy) $?"
sed -i 's/title = "plain"/id = "copy", &/' copy/rom.lua
check "and nothing when it is as it says" "$curtain" check copy
finish

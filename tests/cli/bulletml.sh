#!/usr/bin/env bash
# bulletml.sh - BulletML documents in a game's folder: what packs, what pack and check say of what is wrong, what
# curtain bulletml says, and that the Lua it prints fires what the document does.
. "$(dirname "$0")/../tap.sh"
near=$repo/tests/cli/bulletml_near.py
sandbox
gallery=$repo/examples/bulletml

# ---- packing ----

cp -r "$gallery" g
check "the gallery packs" "$curtain" pack g -o g.rom
same "each document is a lump" "$(cd "$gallery/bulletml" && ls | sed 's,\(.*\).xml,bulletml/\1,')" \
    "$("$curtain" list g.rom | grep -o '^bulletml/[a-z]*')"
doc() { printf '<bulletml type="vertical"><action label="top">\n%s\n</action></bulletml>\n' "$1"; }
doc '<fire><bullet/></fire>' >'g/bulletml/[Ä] two  words.xml'
mkdir g/bulletml/deep
doc '<fire><bullet/></fire>' >g/bulletml/deep/one.xml
echo rubbish >g/bulletml/notes.md
"$curtain" pack g -o names.rom
same "other letters of a name become _, folders stay" "bulletml/____ _two__words bulletml/deep/one" \
    "$("$curtain" list names.rom | grep -oE '^bulletml/(_|deep)[^ ]*' | sed 's/____/____ /' | paste -sd ' ')"
packs() { doc "$1" >g/bulletml/a.xml; "$curtain" pack g -o g.rom; }
bad() { refuse "pack: $1" "g: bulletml/a.xml:$2" packs "$3"; }
bad "an element that is none" "2:1: <fyre> is not a BulletML element (did you mean <fire>?)" '<fyre/>'
rm -r g

# ---- check ----

cp -r "$gallery" g
check "check has nothing to say" "$curtain" check g
sed -i '8s/14/0.5/' g/bulletml/lotus.xml
refuse "check: what is hardly meant" \
    "g/bulletml/lotus.xml:8:7: <wait>: a wait of 0.5 frames has no effect: the action continues immediately" \
    bash -c "'$curtain' check g | sed 's,^,g/,' ; false"
sed -i 's/ bulletml = 8192,//' g/rom.lua
refuse "check: no room to run them" 'rom.lua: documents in bulletml/ are not packed' \
    "$curtain" check g
"$curtain" pack "$gallery" -o with.rom
sed -i 's/bullet.documents()/{}/; s/bullet.ml {/print {/' g/main.lua
"$curtain" pack g -o without.rom
same "such a game has none in it" 0 "$("$curtain" list without.rom | grep -c ^bulletml/)"
rm -r g/bulletml
sed -i 's/lua_kib = 2048/lua_kib = 2048, bulletml = 64/' g/rom.lua
refuse "check: room for nothing" \
    'board.bulletml is set, but the game has no document bulletml/NAME.xml' "$curtain" check g

# ---- curtain bulletml ----

same "what it says" "$gallery/bulletml/gulls.xml: 1 top action, 6 other actions, 3 fires, 2 bullets, 51 elements
  uses \$rank, \$1 to \$2, type=\"horizontal\" (left is up)
  top actions: top
  other actions: cry
  fires: pair
  bullets: gull, feather" "$("$curtain" bulletml "$gallery/bulletml/gulls.xml")"
doc '<repeat><times>0</times><action><fyre/></action></repeat>' >bad.xml
doc '<repeat><times>0</times><action/></repeat>' >zero.xml
refuse "what is wrong" "curtain: bad.xml:2:33: <fyre> is not a BulletML element" "$curtain" bulletml bad.xml
check "what is hardly meant is no failure" "$curtain" bulletml zero.xml
says() { "$curtain" bulletml "$@" 2>&1; }
same "it is named" "zero.xml:2:1: <repeat>: times is 0, but a repeat runs at least once" "$(says zero.xml | head -n 1)"
same "one that is wrong does not end it" 1 "$(says bad.xml zero.xml | grep -c 'zero.xml: 1 top action')"

# ---- as Lua ----

mkdir -p pair/bulletml
cp -r "$gallery/art" pair/
sed 's/id = "gallery"/id = "pair"/; s/tasks = 64/tasks = 2048/; s/dip = {/dip = { way = { "document", "lua" },/' \
    "$gallery/rom.lua" >pair/rom.lua
cat >pair/main.lua <<'LUA'
local play = require "played"
bullet.def("orb", { sprite = "orb", hit = "none", graze = false })
player.def("kite", { sprite = "kite", hit = { circle = 2 } })
enemy.def("orb", { sprite = "orb", hit = { circle = 2 }, touch = false })
stage.def("one", function()
  local e = enemy.spawn { kind = "orb", x = 120, y = 60 }
  wait(30)
  if board.dip("way") == "lua" then
    play(e, { rank = 0.6 })
  else
    bullet.ml { name = "it", x = 120, y = 60, kind = "orb", rank = 0.6 }
  end
  wait(forever)
end)
boot.run { stages = { "one" }, players = { "kite" } }
LUA
alike() { # DOCUMENT PX
    local way
    cp "$1" pair/bulletml/it.xml && "$curtain" bulletml "$1" --lua >pair/played.lua || return 1
    for way in document lua; do
        "$curtain" hash pair --stage one --invincible --dip way=$way --frames 60:460:40 --trace bullets >$way.txt ||
            return 1
    done
    python3 "$near" document.txt lua.txt "$2"
}
for name in carousel clockwork orrery loom gulls peacock; do # without $rand, which is another's there
    check "the Lua of $name fires what it does" alike "$gallery/bulletml/$name.xml" 5
done
cat >all.xml <<'XML'
<bulletml type="horizontal"><action label="top"><repeat><times>40</times><action>
<actionRef label="two words"><param>5</param></actionRef><wait>4+$rank*2</wait></action></repeat></action>
<action label="two words"><fire><direction type="absolute">$1*36</direction><speed>1.5</speed>
<bullet><action><wait>20</wait>
<changeDirection><direction type="relative">90</direction><term>20</term></changeDirection>
<wait>30</wait><changeDirection><direction type="aim">0</direction><term>1</term></changeDirection>
<repeat><times>3</times>
<action><changeSpeed><speed>0.5</speed><term>10</term></changeSpeed><wait>10</wait><changeSpeed><speed type="relative">1
</speed><term>10</term></changeSpeed><wait>20</wait></action></repeat><vanish/></action></bullet></fire>
<fire><direction type="sequence">-$1*7</direction><speed type="sequence">0.1</speed><bulletRef label="end"><param>-2
</param></bulletRef></fire><fireRef label="end"/></action>
<fire label="end"><direction type="aim">10</direction><bullet><speed>2</speed></bullet></fire>
<bullet label="end"><direction type="sequence">0-(3-$2)*(4/2)</direction><action><accel><horizontal>$1</horizontal>
<vertical type="sequence">0.02</vertical><term>60</term></accel><wait>30</wait><changeSpeed><speed type="sequence">0.01
</speed><term>30</term></changeSpeed><changeDirection><direction type="sequence">1</direction><term>40</term>
</changeDirection></action></bullet></bulletml>
XML
check "all of the language" alike all.xml 5

finish

#!/usr/bin/env bash
# check.sh - curtain check: every kind of finding, planted, with its file, line and words, and exit code 1; what is no
# game's folder, exit code 2; and what is fine is let through: the games and examples here.
. "$(dirname "$0")/../tap.sh"
sandbox

eval "bare_$(declare -f game)" # tap.sh's, whose rom.lua asks for more than the scripts here need: they name it all
game() {
    bare_game "$1"
    printf '%s local rooms = { "spark", "motion", "laser", "curve", "option", "parts", "pierce" }\n' \
        "$(cat "$1/main.lua")" >named.lua
    luac5.4 -p named.lua 2>/dev/null && cp named.lua "$1/main.lua"
    return 0
}
idle='boot.run is not called and no task is started' # most games here: a note that finds leaves out
finds() { # NAME DIR [OPTION...], standard input: exactly these lines, in this order
    local name=$1 want got code
    shift
    want=$(cat)
    got=$("$curtain" check "$@" 2>&1)
    code=$?
    same "$name" "$want"$'\n'"exit 1" "$(grep -v "$idle" <<<"$got")"$'\n'"exit $code"
}
fine() { # NAME DIR [OPTION...]: no finding, two lines and perhaps the note on most games here
    local name=$1 got
    shift
    got=$("$curtain" check "$@" 2>&1)
    got=$(grep -v "$idle" <<<"$got"$'\n'"exit $?")
    local played='[0-9]+ demos?, [0-9]+ stages? (or|and) phases?, [0-9]+ forced runs?'
    played="$played; sampled [0-9]+ frames? for contrast"
    played="$played; theme contrast [0-9]+\.[0-9]{2} \(ink\), [0-9]+\.[0-9]{2} \(accent\)"
    local lua='Lua RAM [0-9]+ % of [0-9]+ KiB(, board.lua_kib = [0-9]+ is enough)?'
    local ram='RAM [0-9]+ KiB: [a-z_]+ [0-9]+(, [a-z_]+ [0-9]+)*'
    local all="^$1: no problems: [0-9]+ scripts?, [0-9]+ sprites?; played $played; $lua"$'\n'"$ram"$'\n''exit 0$'
    check "$name (${got%%$'\n'*})" eval '[[ $got =~ $all ]]'
}
png() { python3 "$repo/tests/cli/png_make.py" "$@"; }
lua() { # NAME, standard input: main.lua of a game whose two sprites are used; then the findings after a line of ----
    local text
    text=$(cat)
    { echo 'local used = { "dot", "dart" }' && sed '/^----$/,$d' <<<"$text"; } | game l
    finds "$1" l < <(sed '1,/^----$/d' <<<"$text")
    rm -rf l
}
good() { # NAME, standard input: main.lua, and nothing is found
    { echo 'local used = { "dot", "dart" }' && cat; } | game l
    fine "$1" l
    rm -rf l
}

# ---- what is fine ----

cd "$repo" || exit 2
for dir in roms/*/rom.lua examples/*/rom.lua; do
    dir=${dir%/rom.lua}
    case $dir in roms/glasstide | roms/cookbook) long || continue ;; esac # half a minute of playing
    fine "$dir" "$dir"
done
cd "$scratch" || exit 2
good 'locals, upvalues, methods, labels, attribs' <<'LUA'
local t <const>, n = { deep = {} }, 3
function t:add(k) self.n = (self.n or 0) + k return self end
function t.deep.f(...) return select("#", ...) end
for i = 1, n do
  for k, v in pairs { a = i } do t[k] = v end
  if i == 2 then goto on end
  repeat local last = i until last
  ::on::
end
local function fib(k) return k < 2 and k or fib(k - 1) + fib(k - 2) end
local bullet = { fier = fib }
print(bullet.fier(3), t:add(1).n, #t, ("%d %%p %5.1f"):format(1, 2), 1 // 1, 0 / 1)
do local _ENV = { x = 1 } y = x end
LUA
good 'tables of the API that a game adds to' <<'LUA'
function hud.lives(p) return hud.own and p end
hud.own, pad.shaken = true, false
print(hud.lives(1), pad.shaken, pad["shaken"], hud.banks.plain)
local function extend(t, name) t[name] = print end
extend(score, "show")
score.show(1)
LUA
good 'globals that are made through _G' <<'LUA'
rawset(_G, "speed", 3)
print(speed)
LUA
good 'names that are asked for first, lists, and locals that are something else later' <<'LUA'
if rom.has("logo") then sprite.put { sprite = "logo", x = 1, y = 1 } end
local b = bullet.group("x")
b = {}
print(#b, #query.near { what = "bullet", x = 1, y = 1, radius = 3 })
for _, e in ipairs(query.near { what = "enemy", x = 1, y = 1, radius = 3 }) do print(e) end
enemy.each(nil, function(e) e = { e } for k in pairs(e) do print(k) end end)
for _, row in ipairs(score.rows("easy")) do print(row.name) end
on.phase(function(_, id) print(#id) end)
LUA

# ---- scripts ----

mkdir -p tongues/lang
game tongues <<'LUA'
local used = { "dot", "dart" }
print(used, text.lang("Hello"), text.lang("World"))
talk.def("hello", { name = "Hello" })
talk.def("world", { name = "World" })
task.go(function()
  say("hello", "World")
  say("world", "Hello")
  print(choose({ "a" }, { title = "World" }))
end)
LUA
printf '# Deutsch\nHello = Gr\303\274\303\237e\n' >tongues/lang/de.txt
printf 'Hello = Allo\nWorld = Monde\n' >tongues/lang/fr.txt
lacks="note: $("$curtain" help lang | wc -l) strings of the program's screens are not translated"
finds 'words that a language lacks, and letters that the fonts lack' tongues <<TEXT
lang/de.txt: $lacks (curtain help lang prints all)
lang/de.txt:2: no font in the game has a glyph for "ü", U+00FC and 1 more character: a box is drawn instead
lang/de.txt:2: no font in the game has a glyph for "G", U+0047 and 4 more characters: a box is drawn instead
lang/fr.txt: $lacks (curtain help lang prints all)
lang/fr.txt:1: no font in the game has a glyph for "A", U+0041 and 3 more characters: a box is drawn instead
lang/fr.txt:2: no font in the game has a glyph for "M", U+004D and 4 more characters: a box is drawn instead
main.lua:2: no translation for "World" in lang/de.txt
main.lua:4: no translation for "World" in lang/de.txt
main.lua:6: no translation for "World" in lang/de.txt
main.lua:8: no translation for "World" in lang/de.txt
8 problems
TEXT
rm -r tongues
lua 'characters without a glyph' <<'LUA'
text.put { col = 1, row = 1, text = "A" }
local title, note = "弾幕 été", "plain"
print("弾幕", title, note)
----
main.lua:2: no font in the game has a glyph for "A", U+0041: a box is drawn instead
main.lua:3: note: no font in the game has a glyph for "弾", U+5F3E and 3 more characters; no run shows this text
1 problem
LUA
lua 'spells whose bonus stays, where that of another falls' <<'LUA'
enemy.def("foe", { sprite = "dot", hit = "none" }) local function idle() wait(forever) end
boss.def("b", { title = "B", kind = "foe", x = 1, y = 1, phases = {
  { id = "a", spell = "Falls", bonus = 9, bonus_to = 3, time = 9, hp = 9, run = idle },
  { id = "b", spell = "Stays", bonus = 9, time = 9, hp = 9, run = idle },
  { id = "c", spell = "Lasts", bonus = 9, survive = true, time = 9, run = idle },
  { id = "d", bonus = 5, time = 9, hp = 9, run = idle } } })
----
main.lua:5: spell "Stays": its bonus does not decrease, unlike the bonus of other spells (set bonus_to)
1 problem
LUA
lua 'undeclared globals' <<'LUA'
local count = 1
counter = conut
print(wiat, bulet.fire, _G.first, test)
zzz = 1
local function f() return inner, count end
local inner = f
print(inner)
----
main.lua:3: undeclared global "counter" (did you mean "count"?)
main.lua:3: undeclared global "conut" (did you mean "count"?)
main.lua:4: undeclared global "wiat" (did you mean "wait"?)
main.lua:4: undeclared global "bulet" (did you mean "bullet"?)
main.lua:4: undeclared global "first"
main.lua:4: undeclared global "test" (test is reserved for a later version)
main.lua:5: undeclared global "zzz" (scripts cannot create globals; write "local zzz")
main.lua:6: undeclared global "inner"
8 problems
LUA
lua 'fields nobody put there' <<'LUA'
print(bullet.fier, string.trim, rom.titel, menu["choos"], math.sing(1))
bullet:fire { kind = "x" }
on.hti(print)
----
main.lua:2: bullet has no "fier" (did you mean "fire"?)
main.lua:2: string has no "trim"
main.lua:2: rom has no "titel" (did you mean "title"?)
main.lua:2: menu has no "choos" (did you mean "choose"?)
main.lua:2: math has no "sing" (did you mean "sin"?)
main.lua:3: bullet:fire: call it with a dot, as bullet.fire
main.lua:4: on has no "hti" (did you mean "hit"?)
7 problems
LUA
lua 'what the sandbox lacks' <<'LUA'
print(os.time(), debug.traceback, next({}), unpack)
print(math.random(6), math.exp(1), math.pow, table.getn)
print(string.pack)
----
main.lua:2: os is not available (use board.frame() for time and save.set for saved data)
main.lua:2: debug is not available (use print and board.note)
main.lua:2: next is not available (use pairs, whose order is always the same)
main.lua:2: unpack is not available (use table.unpack)
main.lua:3: math.random is not available (use rng.int, rng.number, rng.pick or rng.chance)
main.lua:3: math.exp is not available (results differ between machines)
main.lua:3: math.pow is not available (use x * x or math.sqrt)
main.lua:3: table.getn is not available (use #t)
main.lua:4: string.pack is not available (byte layouts differ between machines; use string.char)
9 problems
LUA
lua 'what is refused when a script is loaded, all of it' <<'LUA'
print(2 ^ 3, "2 ^ 3", [[
__gc]], { __mode = "k" })
print(4
  ^ 5, "\95_gc")
----
main.lua:2: operator ^ is not available (results differ between machines); use x*x or math.sqrt
main.lua:2: __gc is not available (finalizers run at different times on different machines)
main.lua:3: __mode is not available (weak tables hold different entries on different machines)
main.lua:5: operator ^ is not available (results differ between machines); use x*x or math.sqrt
main.lua:5: __gc is not available (finalizers run at different times on different machines)
5 problems; the game was not run because it cannot be packed
LUA
lua 'things that are no tables' <<'LUA'
for k in pairs(bullet.group("x")) do print(k) end
local shots = shot.fire { kind = "x" }
task.go(function() for _, s in ipairs(shots) do print(s) end end)
print(#player.get(1))
bullet.each("x", function(b) print(#b) end)
on.hit(function(_, by) print(#by) end)
boss.def("b", { title = "B", kind = "e", x = 1, y = 1,
  phases = { { id = "a", hp = 1, time = 9, run = function(e) print(#e) end } } })
----
main.lua:2: pairs: bullet.group returns a handle of kind group, not a table (bullet.each visits each member)
main.lua:2: bad argument #1 to 'pairs' (table expected, got number)
main.lua:4: ipairs: shot.fire returns a handle of kind shot, not a table
main.lua:5: #: player.get returns a handle of kind player, not a table
main.lua:6: #: bullet.each passes a handle to its function, not a table
main.lua:7: #: on.hit passes a handle to its function, not a table
main.lua:9: #: boss.def passes a handle to its function, not a table
7 problems
LUA
lua 'divisions by nothing' <<'LUA'
local n = 3
print(0/0, -(0.0/0), 1/0)
print(function() return n / 0, n // 0, n % (0) end)
----
main.lua:3: 0/0 is NaN: it equals nothing, and the board rejects it
main.lua:3: division by 0: the board rejects infinite values (use math.huge to compare)
main.lua:4: division by 0: the result is infinite or NaN
main.lua:4: // 0 is an error when both operands are integers
main.lua:4: % 0 is an error when both operands are integers
5 problems
LUA
lua 'formats that differ between machines' <<'LUA'
print(function(t) return ("%d: %-8p"):format(1, t), string.format("%.3a %%p", 1) end)
----
main.lua:2: %p is not available (addresses differ between runs)
main.lua:2: %a is not available (its output differs between machines; use %.17g)
2 problems
LUA
lua 'pools that are full, in the line that asked; sparks are not missed' <<LUA
bullet.def("d", { sprite = "dot", hit = "none" })
spark.def("s", { sprite = "dot", life = 900 })
local function fire(turn)
  bullet.fire { kind = "d", x = 9, y = 9, speed = 0, motion = motion.def { { turn = turn, over = 900 } } }
end
task.go(function()
  spark.burst { kind = "s", x = 9, y = 9, n = 65535 }
  for i = 1, 40 do fire(i / 10) end
  wait(10)
  pattern.ring { kind = "d", x = 9, y = 9, speed = 0, n = 300 }
end)
----
main.lua:5: motion pool full (16): bullets with a new motion fly straight; raise \`board.motions\` in rom.lua
main.lua:11: bullet pool full (256): new bullets are dropped; raise \`board.bullets\` in rom.lua
2 problems
LUA
good 'a full pool that a script asks for' <<'LUA'
task.go(function()
  for i = 1, 300 do motion.def { { wait = i } } end
  print(board.refused("motions"))
end)
LUA
lua 'a fault in a line that has another finding' <<'LUA'
bullet.def("d", { sprite = "dot", hit = { circle = 9 } }) local t = nil print(t.x)
----
main.lua:2: bullet "d": its hit circle (18 x 18 px) is larger than its sprite "dot" (8 x 8 px)
main.lua:2: attempt to index a nil value (local 't')
2 problems
LUA
lua 'a fault whose line has a finding already' <<'LUA'
task.go(function() wait(20) print(nothing) end)
----
main.lua:2: undeclared global "nothing"
1 problem
LUA

echo 'print("dot", "dart")' | game s
mkdir -p s/stages s/std
echo 'local x = = 1' >s/stages/one.lua
printf '\n\nprint(bullet.fier, x' >s/stages/two.lua
printf '\33Lua' >s/stages/three.lua
echo 'return {}' >'s/stages/my file.lua'
echo 'return {}' >s/std/nothing.lua
printf '%s\n' 'require "stages/one"' 'require "stages/noen"' 'require "stages/two.lua"' 'require "stages.two"' \
    'print(hud.own)' >>s/main.lua
finds 'syntax errors in several files, and the others still read' s <<'END'
main.lua:3: require: no script stages/noen.lua in the game
main.lua:4: require: no script stages/two.lua.lua in the game; write require "stages/two"
main.lua:5: require: no script stages.two.lua in the game; write require "stages/two"
main.lua:6: hud has no "own"
stages/my file.lua: expected a name of letters, digits, _ - and . only
stages/one.lua:1: unexpected symbol near '='
stages/three.lua:1: expected Lua source, got compiled Lua
stages/two.lua:3: ')' expected near <eof>
std/nothing.lua: the standard library has no script with this name
9 problems; the game was not run because it cannot be packed
END

# ---- rom.lua and the art ----

game a <<'LUA'
bullet.def("b", { sprite = "dto", hit = "none", blend = "glwo" })
palette.load("dsuk")
sprite.put { sprite = "bead" .. 1, x = 1, y = 1 }
task.go(function() board.attract("demo") end)
print(("tail%d"):format(2))
boot.run { stages = { "one" }, players = { "p" }, demo = "attract" }
LUA
cat >a/rom.lua <<'LUA'
return {
  id = "probe", title = "Probe", screen = { w = 64, h = 64 },
  palettes = { dusk = "art/dusk.png" }, blends = { glow = "add" },
  sheets = {
    all = { file = "art/all.png" },
    far = { file = "art/far.png", bank = 2 },
    gone = {
      file = "art/gone.png" },
  },
  sprites = {
    dot = { sheet = "all", x = 0, y = 0, w = 8, h = 8 },
    bead1 = { sheet = "all", x = 0, y = 0, w = 8, h = 8 },
    tail7 = { sheet = "all", x = 0, y = 0, w = 8, h = 8 },
    lonely = { sheet = "all", x = 8, y = 8, w = 8, h = 8 },
    wide = { sheet = "all", x = 8, y = 0, w = 8, h = 8,
      frames = 3 },
  },
}
LUA
png a/art/all.png 16 16 ffffff 3 2 123456 4 2 123456 12 12 eeeeee 1 9 998877
png a/art/left.png 8 8 ffffff
png a/art/dusk.png 8 8 ffffff
cp a/rom.lua a/art/far.png
echo 'a line' >a/left.txt
echo 'return {}' >a/never.lua
finds 'missing and unused art, files and names' a <<'END'
art/all.png: pixel 3,2: colour #123456 is not in bank 0; 2 such pixels in total
art/dusk.png: 8x8 pixels, expected 16x16: one row per bank, one column per shade
art/far.png: not a PNG
art/left.png: not listed in rom.lua
left.txt: packed, but not read by any script
main.lua:1: unknown sprite "dto" (did you mean "dot"?)
main.lua:1: unknown blend "glwo" (did you mean "glow"?)
main.lua:2: unknown palette "dsuk" (did you mean "dusk"?)
main.lua:4: board.attract: demos/demo.demo does not exist
main.lua:6: boot.run: demo: demos/attract.demo does not exist
never.lua: no script requires it
rom.lua:3: blend "glow" is not used by any script
rom.lua:3: palette "dusk" is not used by any script
rom.lua:6: sheet "far" has no sprites
rom.lua:7: sheet "gone" has no sprites
rom.lua:8: art/gone.png does not exist
rom.lua:11: sprite "dot" is not used by any script
rom.lua:14: sprite "lonely" is not used by any script
rom.lua:15: sprite "wide": 3 frames of 8x8 at 8,0 do not fit in the sheet of 16x16 pixels
rom.lua:15: sprite "wide" is not used by any script
20 problems; the game was not run because it cannot be packed
END

echo 'print("dot", "dart")' | game r
sed -i 's/bullets = 256/bulets = 256/' r/rom.lua
finds 'an unknown name in rom.lua' r <<END
rom.lua:3: board.bulets: unknown key (did you mean "bullets"?)
1 problem; the game was not run because it cannot be packed
END
echo 'print("dot", "dart")' | game r
png r/art/all.png 16 16 ffffff 1 1 ff0000
finds 'a colour of another bank' r <<'END'
art/all.png: pixel 1,1: colour #ff0000 is not in bank 0 but in bank 1
1 problem
END
fine 'unless the nearest will do' r --nearest
png r/art/font.png 128 48 ffffff 100 40 010203
sed -i '4s/^/font = "art\/font.png", /' r/rom.lua
png r/art/all.png 16 16 ffffff 15 15 ff0000
finds 'a colour of the font; one that no sprite shows is none' r <<'END'
art/font.png: pixel 100,40: colour #010203 is not in bank 0
1 problem
END
rm -rf r

# What may be put together counts as used, and so does what a text or a switch spells.
game u <<'LUA'
local kinds = { heron = 1 }
local function put(name) sprite.put { sprite = name, x = 1, y = 1 } end
for i = 1, 2 do put("bead" .. i) end
for kind in pairs(kinds) do put(kind) put(kind .. "_bead") end
put(("tail%d"):format(1))
put(("%s_wing"):format("left"))
put(board.dip("hull"))
print(rom.text("cast.txt"))
require("part" .. "one")
LUA
cat >u/rom.lua <<'LUA'
return { id = "u", screen = { w = 64, h = 64 }, sheets = { all = { file = "art/all.png" } },
  dip = { hull = { "wood", "iron" } },
  sprites = {
    bead1 = { sheet = "all", w = 8, h = 8 }, bead2 = { sheet = "all", w = 8, h = 8 },
    heron = { sheet = "all", w = 8, h = 8 }, heron_bead = { sheet = "all", w = 8, h = 8 },
    tail1 = { sheet = "all", w = 8, h = 8 }, left_wing = { sheet = "all", w = 8, h = 8 },
    wood = { sheet = "all", w = 8, h = 8 }, iron = { sheet = "all", w = 8, h = 8 },
    queen = { sheet = "all", w = 8, h = 8 }, king = { sheet = "all", w = 8, h = 8 },
    logo = { sheet = "all", w = 8, h = 8 },
    unbead = { sheet = "all", w = 8, h = 8 } } }
LUA
echo 'the queen and the kings' >u/cast.txt
echo 'return {}' >u/partone.lua
finds 'names that scripts put together' u <<'END'
rom.lua:8: sprite "king" is not used by any script
rom.lua:10: sprite "unbead" is not used by any script
2 problems
END

# ---- the run ----

game m <<'LUA'
print("dot", "dart")
task.go(function()
  local t = {}
  for i = 1, 262 do t[i] = ("x"):rep(1500) wait(2) end
  wait(forever)
end)
LUA
sed -i 's/lua_kib = 1024/lua_kib = 512/' m/rom.lua
got=$("$curtain" check m)
much='(38[4-9]|39[0-9]|4[0-9][0-9]) KiB' more='(704|768|832|896)'
check "Lua RAM above 75 % in 600 frames ($(head -1 <<<"$got"))" \
    grep -Eq "^rom.lua:3: board.lua_kib = 512: 600 frames without input used $much of it, more than 75 %; raise it to \
$more$" <<<"$got"
sed -i 's/lua_kib = 512/lua_kib = 1024/' m/rom.lua
sed -i 's/262 do/26200 do/;s/wait(2)//' m/main.lua
at_once='(most of it allocated in one frame: infinite loop, missing wait?)'
finds 'out of Lua RAM is one finding' m <<END
main.lua:4: out of Lua memory (1024 KiB); raise \`board.lua_kib\` in rom.lua $at_once
1 problem
END

game faint <<'LUA'
bullet.def("dot", { sprite = "dot", hit = { circle = 2 } })
bullet.def("ink", { sprite = "dart", hit = { circle = 2 } })
for i = 0, 15 do sprite.put { sprite = "dot", x = 4 + 8 * (i % 4), y = 4 + 8 * (i // 4), layer = "back" } end
for i = 1, 10 do bullet.fire { kind = "dot", x = 5 + i, y = 6 + i, speed = 0 } end
for i = 1, 10 do bullet.fire { kind = "ink", x = 44 + i, y = 50, speed = 0 } end
LUA
mkdir faint/demos
"$curtain" hash faint --frames 700 --record faint/demos/idle.demo >/dev/null 2>&1
finds 'bullets that cannot be seen' faint <<'END'
demos/idle.demo: bullets "dot" in bank 0 are hard to see: 60 of 60 in 6 sampled frames; the first is at 6,7 in frame 0
1 problem
END
sed -i 's/layer = "back"/layer = "back", hidden = true/' faint/main.lua
"$curtain" hash faint --frames 700 --record faint/demos/idle.demo >/dev/null 2>&1
fine 'the same over nothing' faint

# A stage by itself; what a demo was told of already is not told again.
sed -i 's/sprites = 16/sprites = 64/' faint/rom.lua
cat >>faint/main.lua <<'LUA'
player.def("ship", { sprite = "dot", hit = { circle = 2 } })
stage.def("night", function()
  for i = 0, 15 do sprite.put { sprite = "dot", x = 4 + 8 * (i % 4), y = 4 + 8 * (i // 4), layer = "back" } end
  for k = 1, 6 do
    for i = 1, 10 do bullet.fire { kind = "dot", x = 5 + i, y = 6 + i, speed = 0 } end
    wait(100)
    bullet.clear { all = true }
  end
end)
boot.run { stages = { "night" }, players = { "ship" } }
LUA
rm -r faint/demos
finds 'bullets that cannot be seen in a stage without a demo' faint <<'END'
night: bullets "dot" in bank 0 are hard to see: 50 of 60 in 6 sampled frames; the first is at 6,7 in frame 120
1 problem
END
mkdir faint/demos
"$curtain" hash faint --frames 700 --stage night --record faint/demos/n.demo >/dev/null 2>&1
finds 'told once, for the demo' faint <<'END'
demos/n.demo: bullets "dot" in bank 0 are hard to see: 50 of 60 in 6 sampled frames; the first is at 6,7 in frame 120
1 problem
END

# Translucent pictures: without the blend "alpha", and with one for which the palette has no colours.
bare_game faded <<'LUA'
print("dot", "dart") task.go(function() sprite.put { sprite = "dot", x = 9, y = 9, alpha = 4 } end)
LUA
sed -i 's/items = 128/transforms = true, items = 128/' faded/rom.lua
faded() { "$curtain" check faded 2>&1 | grep -c "$1"; }
same 'translucent pictures without a blend' 1 \
    "$(faded 'note: blends: translucent pictures are drawn as dots; add `alpha = { mix = 50 }`')"
sed -i 's/  sheets/  blends = { alpha = { mix = 50 } },\n  sheets/' faded/rom.lua
same '... with one' 0 "$(faded 'note: blends')"
sed -i 's/mix = 50/ramp = "max"/' faded/rom.lua
same '... with one that mixes nothing' 1 \
    "$(faded 'note: blends.alpha: over black, .* in bank 0 have the wrong colours')"

# Rooms that no script can use, with what they take, which grows with them; a name in a script keeps one.
bare_game rooms <<'LUA'
print("dot", "dart", "laser")
LUA
sed -i 's/items = 128/values = { bullet = 2 }, frozen = true, hp = true, items = 128/' rooms/rom.lua
sed 's/1[0-9]* KiB/N KiB/;s/[2-9][0-9]* KiB/N KiB/' >wanted <<'END'
rom.lua:3: board.sparks: no script uses spark; remove this entry from rom.lua to save 15 KiB of RAM
rom.lua:3: board.curve_points: no script uses curve; remove this entry from rom.lua to save 17 KiB of RAM
rom.lua:3: board.options: no script uses option; remove this entry from rom.lua to save 8 KiB of RAM
rom.lua:3: board.hp: no script uses hp; remove this entry from rom.lua to save 9 KiB of RAM
rom.lua:3: board.frozen: no script uses frozen; remove this entry from rom.lua to save 9 KiB of RAM
rom.lua:3: board.bodies: no script uses parts; remove this entry from rom.lua to save 9 KiB of RAM
rom.lua:3: board.pierce: no script uses pierce; remove this entry from rom.lua to save 18 KiB of RAM
rom.lua:3: board.values.bullet: no script uses value; remove this entry from rom.lua to save 18 KiB of RAM
8 problems
END
rooms() { "$curtain" check rooms | grep -v "$idle" | sed 's/[1-9][0-9]* KiB/N KiB/'; }
same 'capacities that nobody uses' "$(cat wanted)" "$(rooms)"
takes() { "$curtain" check rooms | sed -n "s/.*board.$1:.*save \([0-9]*\) KiB of RAM/\1/p"; }
before=$(takes sparks)
sed -i 's/sparks = 64/sparks = 4096/' rooms/rom.lua
check 'what they take grows with them' test "$(takes sparks)" -gt $((before + 64))
check 'and is theirs alone' test "$(takes options)" -lt "$(takes sparks)"
echo 'local function kept(e) e.parts = "pierce" return e.frozen, option, value, curve end' >>rooms/main.lua
sed -i '/pierce/d;/parts/d;/frozen/d;/option/d;/value/d;/curve/d;s/8 problems/2 problems/' wanted
same 'what a script names is kept' "$(cat wanted)" "$(rooms | grep -v undeclared | sed 's/^3 /2 /')"

game d <<'LUA'
print("dot", "dart") task.go(function() while true do wait(1) if pad.down("fire") then error("fired") end end end)
LUA
mkdir d/demos
"$curtain" hash d --frames 700 --record d/demos/idle.demo >/dev/null 2>&1
fine 'a demo that holds' d
cp d/demos/idle.demo d/demos/spoilt.demo
printf '\377' | dd of=d/demos/spoilt.demo bs=1 seek=100 conv=notrunc 2>/dev/null
head -c 1000 d/demos/idle.demo >d/demos/cut.demo
finds 'damaged demos' d <<'END'
demos/cut.demo: truncated: no end mark
demos/spoilt.demo: damaged record at byte 8 (CRC)
2 problems
END
rm d/demos/*
"$curtain" hash d --frames 90 --press fire@60 --record fire.demo >/dev/null 2>&1
sed -i 's/task.go/board.note(7) &/; s/fired"/fired twice"/' d/main.lua
cp fire.demo d/demos
finds 'a demo of another build: only its fault' d <<'END'
main.lua:1: fired twice
1 problem
END
rm d/demos/*
"$curtain" hash d --frames 90 --record idle.demo >/dev/null 2>&1
python3 "$repo/tests/cli/demo_repair.py" idle.demo d/demos/forged.demo $(($(stat -c %s idle.demo) - 81)) # the last row
finds 'a demo that does not hold' d <<'END'
demos/forged.demo: playback diverges at frame 90 (see curtain verify d d/demos/forged.demo)
1 problem
END

# ---- an example of the guide ----

sample() { sed -n '/^A game with mistakes:$/,/^|/s/^    //p' "$repo/docs/guide/19-errors.md"; }
cp -r "$repo/examples/first" mygame
python3 - mygame <<'PY'
import sys
# One orb of 12 x 12 px, all in a colour of bank 0 but 17 pixels.
folder = sys.argv[1]
open(folder + "/rom.lua", "w").write('''return {
  id = "mygame", title = "First Light",
  sheets = {
    bullets = { file = "art/bullets.png" },
  },
  palette = "art/palette.png",
  sprites = {
    orb  = { sheet = "bullets", x = 16, y = 0, w = 12, h = 12 },
    dart = { sheet = "bullets", x = 0, y = 0, w = 8, h = 8 } } }
''')
open(folder + "/main.lua", "w").write('''local count = 1

print(conut)
local six = math.random(6)
bullet.fier { kind = "orb", x = 1, y = 1 }
for b in pairs(bullet.group()) do print(b, count) end
bullet.def("orb", { sprite = "obr", hit = "none" })
print(six ^ 2, "orb")
''')
PY
mkdir mygame/stages
echo 'return {}' >mygame/stages/one.lua
rm mygame/art/*.png
png mygame/art/palette.png 16 16 ffffff
png mygame/art/draft.png 8 8 ffffff
png mygame/art/bullets.png 32 32 ffffff 20 3 ff00aa \
    $(for x in {0..15}; do echo "$((x % 8)) $((4 + x / 8)) ff00aa"; done)
finds 'what the guide shows' mygame < <(sample)

# ---- hit shapes larger than pictures ----

game l <<'LUA'
local used = { "dot", "dart" } -- 8 x 8 and 8 x 4 px
bullet.def("even", { sprite = "dot", hit = { circle = 4 } })
bullet.def("wide", { sprite = "dot", hit = { circle = 4.125 } })
bullet.def("high", { sprite = "dart", hit = { box = { 8, 5 } } })
bullet.def("turned", { sprite = "dart", hit = { box = { 4, 8 } }, turns = true })
bullet.def("long", { sprite = "dart", hit = { capsule = { 5, 2 } }, turns = true })
bullet.def("short", { sprite = "dart", hit = { capsule = { 4, 2 } }, turns = true })
shot.def("many", { sprite = "dot", hit = { circles = { { -4, 0, 1 }, { 3, 0, 1 } } } })
shot.def("few", { sprite = "dot", hit = { circles = { { 14, 0, 1 }, { 20, 0, 1 } } } })
for i = 1, 2 do
  enemy.def("foe " .. i, { sprite = "dart", hit = { capsule = { 4, 1, i * 90 - 90 } } })
end
enemy.def("air", { sprite = "dot", hit = "none" })
LUA
finds 'hit shapes larger than pictures' l <<'END'
main.lua:3: bullet "wide": its hit circle (8.25 x 8.25 px) is larger than its sprite "dot" (8 x 8 px)
main.lua:4: bullet "high": its hit box (8 x 5 px) is larger than its sprite "dart" (8 x 4 px)
main.lua:6: bullet "long": its hit capsule (9 x 4 px) is larger than its sprite "dart" (8 x 4 px)
main.lua:8: shot "many": its combined hit circles (9 x 2 px) are larger than its sprite "dot" (8 x 8 px)
rom.lua: enemy "foe 2": its hit capsule (2 x 6 px) is larger than its sprite "dart" (8 x 4 px)
5 problems
END
rm -r l

# ---- blends of ramps ----

cp -R "$repo/examples/first" ramps
sed -i 's/font = /blends = { shine = { ramp = "add" } }, font = /' ramps/rom.lua
sed -i 's/bullet.def("orb", {/bullet.def("orb", { blend = "shine", bank = 0,/' ramps/main.lua
same 'a ramp from dark to bright' '0' "$("$curtain" check ramps >/dev/null 2>&1; echo $?)"
sed -i 's/blend = "shine", bank = 0/blend = "shine", bank = 8/' ramps/main.lua
finds 'a bank that is none' ramps <<'END'
main.lua:1: bullet "orb": its blend "shine" needs a dark-to-light bank, but colour 7 in bank 8 is darker than colour 6
1 problem
END
rm -r ramps

# ---- what only playing finds ----

# What play brings about only now and then is forced: each of these is reached, and what comes after it.
player() { # standard input: a script of a game with two ships and two difficulties
    rm -rf forced
    cp -R "$repo/examples/first" forced
    sed -i 's/^return {/return { difficulties = { "easy", "hard" }, players = 2,/' forced/rom.lua
    sed -i 's/^boot.run.*/require "more"\nplayer.def("other", { sprite = "ship", hit = { circle = 2 } })\n/' \
        forced/main.lua
    echo 'boot.run { stages = { "one" }, players = { "ship", "other" }, continues = 2 }' >>forced/main.lua
    cat >forced/more.lua
}
reaches() { # NAME LINE
    player <<<"$2"
    got=$("$curtain" check forced 2>&1)
    check "$1" grep -q '^more.lua:1: a player has no property "pwoer"$' <<<"$got"
}
while IFS='|' read -r name text; do reaches "$name" "$text"; done <<'END'
a death|on.death(function(p) print(p.pwoer) end)
a hit|on.hit(function(p) print(p.pwoer) end)
a graze|on.graze(function(p) print(p.pwoer) end)
an extra life|on.extend(function(p) print(p.pwoer) end)
a continue|on.continue(function(p) print(p.pwoer) end)
the end of a game|on.game_over(function() print(player.get(1).pwoer) end)
another ship|on.death(function(p) if p.kind == "other" then print(p.pwoer) end end)
another difficulty|on.death(function(p) if board.difficulty() == "hard" then print(p.pwoer) end end)
a second player|on.start(function() if player.get(2).alive then print(player.get(1).pwoer) end end)
END
# The screens that the title opens: pages of the game's own, and its screens in place of the library's.
started() { # TEXT START: reaches TEXT, in a game that START begins
    player <<<'return function() print(player.get(1).pwoer) end'
    sed -i 's/^boot.run.*//' forced/main.lua
    printf '%s\n' 'local broken = require "more"' "$2" >>forced/main.lua
    got=$("$curtain" check forced 2>&1)
    check "$1" grep -q '^more.lua:1: a player has no property "pwoer"$' <<<"$got"
}
run='boot.run { stages = { "one" }, players = { "ship", "other" }'
pages="{ name = 'a', show = print }, { name = 'b', show = print }"
started 'and the last of several' "$run, pages = { $pages, { name = 'how', show = broken } } }"
started 'each entry of the pause menu' "$run, pause = { { 'A', print }, { 'B', broken } } }"
started 'the screen music' "$run, screens = { music = broken }, music = { room = true } }"
started 'the screen history' "boss.def('b', { title = 'B', kind = 'jelly', x = 60, y = 60, phases = {
  { id = 'p', spell = 'S', hp = 9, time = 300, run = function() wait(forever) end } } })
stage.def('two', function() boss.fight('b') end)
${run/one/two}, screens = { history = broken } }"
started 'a late phase of a boss' "boss.def('b', { title = 'B', kind = 'jelly', x = 60, y = 60, phases = {
  { id = 'p', hp = 9, time = 3000, run = function() wait(forever) end },
  { id = 'q', hp = 9, time = 60, run = broken } } })
stage.def('two', function() boss.fight('b') end)
${run/one/two} }"
for screen in missions mission; do
    started "the screen $screen" "mission.def('m', { title = 'M', stage = 'one', goal = { grazes = 60 } })
$run, screens = { $screen = broken } }"
done
player <<'LUA'
on.extend(function(p) print(p.first) end)
on.death(function(p) print(p.second) end)
LUA
finds 'and what comes after a fault' forced <<'END'
more.lua:1: a player has no property "first"
more.lua:2: a player has no property "second"
2 problems
END
cp -R "$repo/examples/first" unstarted
sed -i '/^boot.run/d' unstarted/main.lua
line='boot.run { stages = { "one" }, players = { "ship" } }'
finds 'a game that nobody can start' unstarted <<END
main.lua: boot.run is not called, so the game cannot be played; end this script with $line
1 problem
END
echo 'print("dot", "dart", ("x"):rep(3))' | game idle
got=$("$curtain" check idle 2>&1)
same 'one without ships and stages may be so' 0 $?
check '... and it is noted' grep -q "^main.lua: note: $idle, so nothing will happen$" <<<"$got"

# ---- text ----

printf 'return { licence = "(c) Enrique Garc\303\255a" }\n' >garcia.lua
echo 'local garcia = require "garcia" print("dot", "dart", garcia.licence)' | game unseen
cp garcia.lua unseen/
got=$("$curtain" check unseen 2>&1)
same 'text that no run shows is no problem' 0 $?
check '... but noted' grep -q '^garcia.lua:1: note: no font in the game has a glyph for .*; no run shows this text$' \
    <<<"$got"
game seen <<'LUA'
local g = require "garcia" print("dot", "dart")
task.go(function() wait(30) text.put { col = 1, row = 1, text = g.licence:match "Garc.*" } wait(forever) end)
LUA
cp garcia.lua seen/
finds 'what a run shows is one' seen <<'END'
garcia.lua:1: no font in the game has a glyph for "í", U+00ED: a box is drawn instead
1 problem
END

# ---- what is no game ----

mkdir empty
usage_errors 2 <<'END'
check none|none: no such folder
check d/main.lua|d/main.lua: expected a game's folder, got a file
check empty|empty: not a game's folder: it has no rom.lua
END
# ---- sounds ----

sounds() { # SOUNDS, standard input: main.lua; a game with these
    { echo 'local used, tune = { "dot", "dart" }, music.name()' && cat; } | game l
    sed -i "s|sounds = .*|sounds = { $1 },|" l/rom.lua
}
sounds 'hit = { mml = "t200 @noise o6 c8" }, boom = { mml = "t200 @noise o6 c8" }' <<'LUA'
music.play("tide")
on.start(function()
  sound.play("bom")
  sound.stop("zzz")
  music.play("tied")
end)
LUA
finds 'names that rom.lua has not, and one that no script has' l <<'EOF'
main.lua:4: sound.play: unknown sound "bom" (did you mean "boom"?)
main.lua:5: sound.stop: unknown sound "zzz"
main.lua:6: music.play: unknown music "tied" (did you mean "tide"?)
rom.lua:9: sound "boom" is not used by any script
4 problems
EOF
rm -rf l
loud='{ mml = "t60 @pulse V127 o4 [c1]9", limit = 8 }'
sounds "$(printf "%s = $loud, " hit graze kill item bomb menu shot time)" <<'LUA'
music.play("tide")
task.go(function()
  for name in ("hit graze kill item bomb menu shot time"):gmatch "%a+" do sound.play(name, { pan = -1 }) end
end)
LUA
finds 'a mix that is too loud' l <<'EOF'
600 frames without input: the mix exceeds full scale in 590 of 600 frames, first in frame 0: too loud
1 problem
EOF
rm -rf l
long='mml = "t60 @sine V30 o4 c1"'
first="limit = 8, priority = 5"
sounds "hit = { $long, limit = 8 }, boom = { $long, limit = 1, priority = 5 }, bell = { $long, $first }" <<'LUA'
music.play("tide", { again = true })
task.go(function()
  while true do
    sound.play("hit")
    sound.play("boom")
    wait(5)
    for _ = 1, 7 do sound.play("bell") wait(1) end
    sound.stop("bell")
    wait(8)
  end
end)
LUA
finds 'sounds that others take the voice of' l <<'EOF'
600 frames without input: sound "hit" is cut off 30 of 30 times, first in frame 11: other sounds take its voice
1 problem
EOF
rm -rf l
finish

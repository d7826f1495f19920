#!/usr/bin/env bash
# bench.sh - `curtain bench`: which runs it plays, the sections that frames are put to, the dearest lines and what is
# counted of them, capacities and what would do, JSON, and bad input. No verdict depends on a time.
. "$(dirname "$0")/../tap.sh"
sandbox

field() { jq -r "$@" <json; } # FILTER: of what was printed
counts() { jq -c '[.lines[] | [.line, .instructions]]' "$1"; } # JSON
of() { field ".$1[] | select(.name == \"$2\") | $3"; } # rooms|sections NAME FILTER
bench() { "$curtain" bench "$@" --json >json 2>err; }
says() { grep -qE -- "$1" out || { cat out; return 1; }; }

# ---- a game without sections or demos ----

game plain <<'LUA'
bullet.def("orb", { sprite = "dot", hit = { circle = 2 } })
task.go(function()
  while true do
    local n = 0
    for i = 1, 500 do n = n + i end
    wait(1)
  end
end)
task.go(function()
  while true do
    bullet.fire { kind = "orb", x = 32, y = 2, speed = 1 }
    wait(2)
  end
end)
LUA
check "a game is measured" bench plain
same "from its start, without sections" "[1,1800,[null]]" "$(field -c '[.runs, .all.frames, [.sections[].name]]')"
same "the dearest line" "main.lua:5 for i = 1, 500 do n = n + i end" "$(field '.lines[0] | .line + " " + .text')"
same "two instructions for each turn of a loop" true "$(field '.lines[0].instructions >= 1000 * 1800')"
same "half of the frames fire" true "$(field '[.lines[] | select(.line == "main.lua:11")][0].calls >= 900 * 100')"
same "all lines together are the scripts' work" true "$(field '([.lines[].work] | add) == .work and .work == .all.lua')"
same "times add up" true "$(field '.all | .mean - (.tick + .draw + .sound) | . >= -2 and . <= 2')"
same "a room, and how much of it was used" "256 63" \
    "$(of rooms board.bullets '[.asked, .most] | join(" ")')"
same "what none is there of keeps its part" true "$(of rooms board.lasers '.most == 0 and .would_do == .asked')"
same "the sum of the parts is the RAM of the board, the picture and the memory to draw it" true \
    "$(field '(.ram_parts | add) == .ram_sum and .ram_sum - .ram_parts.picture - .ram_parts.drawing == .ram')"
cp json first
check "once more" bench plain
same "the same counts" "$(counts first)" "$(counts json)"

# What would do really does: the same run, with the same state in the end.
"$curtain" hash plain --frames 1800 --every 1800 --parts | tail -n 1 | grep -oE ' bullets=[0-9a-f]+' >was
would=$(of rooms board.bullets .would_do)
same "less would do" true "$([ "$would" -lt 256 ] && echo true)"
sed "s/bullets = 256/bullets = $would/" plain/rom.lua >rom.lua && cp -r plain less && mv rom.lua less/rom.lua
"$curtain" hash less --frames 1800 --every 1800 --parts | tail -n 1 | grep -oE ' bullets=[0-9a-f]+' >is
check "and does" cmp was is
sed "s/bullets = 256/bullets = 16/" plain/rom.lua >less/rom.lua
check "where it is too little" bench less
same "it says how often" true "$(of rooms board.bullets '.refused > 100 and .would_do == 16')"

"$curtain" pack plain -o plain.rom >out
check "pack prints the parts" says '^plain\.rom: RAM [0-9]+ KiB: lua_kib 1024, ([a-z]+ [0-9]+, )*bullets [0-9]+, '

# Two programs of 520 steps need more than 64 times 16: the second has no room, though only half of what was asked is
# used.
game steps <<'LUA'
bullet.def("orb", { sprite = "dot", hit = { circle = 2 } })
for i = 1, 2 do
  local steps = {}
  for k = 1, 260 do
    steps[2 * k - 1] = { speed = i + k / 256, over = 1 }
    steps[2 * k] = { wait = k }
  end
  motion.def(steps)
end
LUA
sed -i "s/motions = 16/motions = 64/" steps/rom.lua
check "a game whose motions have too many steps" bench steps
same "keeps what it asked for" '[64,33,1,64]' \
    "$(of rooms board.motions '[.asked, .most, .refused, .would_do]' | jq -c)"

# ---- stages, bosses, demos ----

game whole <<'LUA'
player.def("ship", { sprite = "dot", hit = { circle = 1 } })
bullet.def("orb", { sprite = "dot", hit = { circle = 2 } })
enemy.def("lead", { sprite = "dot", hit = { circle = 4 }, hp = 1000 })
boss.def("queen", { title = "Queen", kind = "lead", x = 32, y = 10, phases = {
  { id = "ring", hp = 1000, time = 120, run = function(e)
    while true do pattern.ring { kind = "orb", from = e, n = 12, speed = 1 } wait(10) end
  end },
  { id = "rest", hp = 1000, time = 60, run = function() wait(forever) end },
} })
stage.def("one", function() wait(60) boss.fight("queen") end)
stage.def("two", function() wait(90) end)
boot.run { stages = { "one", "two" }, players = { "ship" } }
LUA
check "a game with sections" bench whole
same "each is there" "one queen/rest queen/ring two" "$(field '[.sections[].name // empty] | sort | join(" ")')"
same "a phase has those of its time" true "$(of sections queen/ring '.frames >= 119 and .frames <= 122')"
same "what a pattern costs is its line's" true \
    "$(field '[.lines[] | select(.text | test("pattern.ring"))][0].calls > 0')"
check "one of them" bench whole --stage queen/ring
same "alone" "queen/ring" "$(field '[.sections[].name // empty] | join(" ")')"
"$curtain" hash whole --stage two --frames 200 --record two.demo >/dev/null
check "a demo" bench whole --demo two.demo
same "all of it" "1 200 two.demo" "$(field '[.runs, .all.frames, .all.worst_run] | join(" ")')"
mkdir whole/demos && cp two.demo whole/demos
check "demos of the game come first, then what they do not come to" bench whole
same "so two is the demo's" "two.demo" "$(of sections two .worst_run)"
same "and one is not" "one" "$(of sections one .worst_run)"
rm -r whole/demos

# ---- as text ----

"$curtain" bench whole --stage queen/ring --slower 50 >out 2>err
check "a table" says '^section +frames +Lua +tick +draw +sound +mean +99 % +worst +mean +worst +late  slowest frame$'
check "a line a section" says \
    '^queen/ring +1[12][0-9] +[0-9]+( +[0-9]+\.[0-9]{3}){6} +[0-9]+% +[0-9]+% +[0-9]+  [0-9]+ of queen/ring$'
check "on a slower machine" says '^ +milliseconds +50x slower$'
same "and nothing else is said" "" "$(cat err)"

# ---- bad input ----

echo 'task.go(function() wait(30) local x; x.y = 1 end)' >>plain/main.lua
refuse "a script's fault" "main.lua:15: attempt to index a nil value" "$curtain" bench plain
same "and where" "curtain: start: frame 30: " "$(grep -o "^curtain: start: frame 30: " .said)"
finish

-- Bosses: what a phase is worth, and what loses it; last phases; the safe and the armoured part; casts with one bar or
-- one each; talks; the history of spells; what boss.def refuses. A boss flies in over 60 frames.
--board: bodies backgrounds
bullet.def('dot', { sprite = 'dot', hit = { circle = 4 } })
player.def('ship', { sprite = 'dot', hit = { circle = 2 }, lives = 3, safe = 9 })
player.def('other', { sprite = 'dot', hit = { circle = 2 } })
enemy.def('e', { sprite = 'dot', hit = { box = { 8, 8 } }, touch = false, hp = 5 })
local sys, made = string.sys, 0
bg.def('hall', function() made = made + 1 end)
bg.def('yard', function() end)
local function idle() wait(forever) end
local function down(frames) return function(e) wait(frames) e.hp = 0 end end
local function hit()
  local p = player.get(1)
  bullet.fire { kind = 'dot', x = p.x, y = p.y, speed = 0 }
end
local function phase(t)
  local p = { id = 'a', hp = 10, time = 50, rest = 0, run = idle }
  for k, v in pairs(t) do p[k] = v end
  return p
end
local function talk(word)
  return { talk = function(e) print(word, e.alive, e.safe == forever) wait(3) end }
end
local function one(...) return { title = 'B', kind = 'e', x = 50, y = 40, phases = { ... } } end
local function two(...)
  local iris = { name = 'iris', title = 'Iris', kind = 'e', x = 30, y = 40 }
  local opal = { name = 'opal', title = 'Opal', kind = 'e', x = 90, y = 40, portrait = 'wink', portrait_left = true }
  return { title = 'B', portrait = 'arrow', phases = { ... }, cast = { iris, opal } }
end
local function each_bar(runs) return phase { hp = { iris = 4, opal = 4 }, run = runs } end
on.phase(function(_, id, won, captured) print(id, won, captured) end)

boss.def('bonus', one(phase { bonus = 700, bonus_to = 200, run = down(10) }))
boss.def('survived', one(phase { bonus = 701, bonus_to = 200, survive = true }))
boss.def('timeout', one(phase { bonus = 700, time = 5 }))
boss.def('death', one(
  phase { bonus = 700, run = function(e) hit() wait(5) e.hp = 0 end },
  phase { id = 'c', bonus = 3, run = down(5) }
))
boss.def('bomb', one(phase { bonus = 700, run = function(e)
  sys.emit('bomb', player.get(1), false)
  wait(5)
  e.hp = 0
end }))
boss.def('last', one(phase { run = down(2) }, phase { id = 'l', last = true, run = down(2) }))
boss.def('not last', one(
  phase { time = 5 }, phase { id = 'b', run = down(2) },
  phase { id = 'l', last = true }, { talk = function() print 'end' end }
))
boss.def('hit in last', one(phase { id = 'l', last = true, bonus = 5, run = function() hit() wait(forever) end }))
boss.def('safe', one(phase { safe = 6, time = 20, run = function(e)
  for i = 1, 8 do
    e:hurt(1)
    print(e.hp)
    wait(1)
  end
end }))
boss.def('armour', one(phase { hp = 100, safe = 2, armour = 3, run = function(e)
  for i = 1, 7 do
    e:hurt(8)
    print(e.hp)
    wait(1)
  end
  e.hp = 0
end }, phase { id = 'c', hp = 100, run = function(e)
  e:hurt(8)
  print(e.hp, e.rate)
  e.hp = 0
end }))
boss.def('in armour', one(
  phase { hp = 100, armour = 30, run = function(e) e:hurt(8) print(e.hp) e.hp = 0 end },
  phase { id = 'c', hp = 100, run = function(e) e:hurt(8) print(e.hp) e.hp = 0 end }
))
boss.def('home', one(
  phase { time = 15, rest = 9, run = function(e) e:wander { w = 80, h = 40, every = 3, over = 3 } end },
  phase { id = 'c', time = 2, run = function(e) print(e.x, e.y) end }
))
boss.def('talks', one(
  talk 'first', talk 'second', phase { run = down(2) }, talk 'between', phase { id = 'c', run = down(2) }, talk 'end'
))
boss.def('warning', { title = 'B', kind = 'e', x = 50, y = 40, warning = 30, phases = { phase { run = down(1) } } })
local halls = {}
for i, bg in ipairs { 'hall', 'hall', 'yard', 'hall' } do
  halls[i] = phase { id = 'p' .. i, bg = bg, rest = 20, run = down(20) }
end
boss.def('halls', one(table.unpack(halls)))
boss.def('hall', one(phase { bg = 'hall', run = down(40) }))
boss.def('spells', one(
  phase { run = down(2) }, phase { id = 's', spell = 'S', run = down(2) }, phase { id = 'lost', spell = 'L', time = 2 }
))
boss.def('portraits', two(
  phase { id = 'p1', spell = 'S', hp = { opal = 5 } },
  phase { id = 'p2', spell = 'S', hp = 9 },
  phase { id = 'p3', spell = 'S', hp = { opal = 5 }, portrait = 'dot', portrait_left = false },
  phase { id = 'p4', spell = 'S', hp = { opal = 5 }, cut_in = false }
))
boss.def('one bar', two(phase { run = function(i, o)
  o:hurt(4)
  wait(1)
  print(i.hp, o.hp)
  i:hurt(3)
  o:hurt(9)
end }))
boss.def('bars', two(each_bar {
  iris = function(e)
    sprite.put { sprite = 'dot', x = 9, y = 9 }
    for _ = 1, 2 do
      wait(1)
      e:hurt(2)
      print('iris', e.hp, e.safe == forever)
    end
    wait(1)
    print 'not here'
  end,
  opal = function(e)
    for _ = 1, 4 do
      wait(1)
      e:hurt(1)
      print('opal', e.hp, board.live 'sprites')
    end
  end,
}))
boss.def('any', two(phase { hp = { iris = 5, opal = 7 }, down = 'any', run = function(_, o) o:hurt(7) end }))
boss.def('a bar for one', two(phase { hp = { iris = 5 }, run = function(i, o)
  print(o.safe == forever)
  o:hurt(50)
  wait(2)
  i:hurt(5)
end }))
boss.def('removed', two(each_bar(function(i, o)
  i:remove()
  wait(2)
  o:hurt(4)
end)))
boss.def('both home', two(
  phase { rest = 9, time = 4, run = function(i, o) i.x, i.y, o.x = 5, 5, 5 end },
  phase { id = 'c', time = 2, run = function(i, o) print(i.x, i.y, o.x, o.y) end }
))
local put, shown = sprite.put, {}
local function hurt(e, n)
  e:hurt(n)
  wait(8)
  print(shown.arrow.hidden, shown.wink.hidden)
end
local wounded = one(
  phase { run = function(e) hurt(e, 9) e:hurt(1) end },
  phase { id = 'c', run = function(e) hurt(e, 1) hurt(e, 5) e:hurt(4) end }
)
wounded.hurt, wounded.broken = 'arrow', 'wink'
boss.def('wounded', wounded)
local declared = one(phase { spell = 'S', run = down(20) })
declared.portrait, declared.cut_in = 'arrow', 'wink'
boss.def('declared', declared)
local clocked = {}
stage.def('clock', function()
  task.go(function()
    boss.fight('bonus', clocked)
    print('over', board.frame())
  end)
  stage.at(70)
  print('at', board.frame())
end)

local function fight(name, args)
  sys.join(1, 'ship')
  local won, frame = boss.fight(name, args), board.frame()
  wait(1) -- for the handler
  print(won, frame)
  print(player.get(1).score, player.get(1).lives)
end

--each: a bonus falls while the phase lasts
fight 'bonus'
--> a true true
--> true 72
--> 590 2
fight 'survived'
--> a true true
--> true 111
--> 200 2

--each: time, a death in the phase, or a bomb loses the bonus
fight 'timeout'
--> a false false
--> false 126
--> 0 2
fight 'death'
--> a true false
--> c true true
--> true 73
--> 3 1
fight 'bomb'
--> a true false
--> true 67
--> 0 2

--each: a last phase comes after phases that were won, and a hit ends it at no cost
fight 'last'
--> a true true
--> l true true
--> true 67
--> 0 2
fight 'not last'
--> a false false
--> b true true
--> end
--> false 71
--> 0 2
fight 'hit in last'
--> l false false
--> false 122
--> 0 2

--each: the start of a phase may be safe or armoured
fight 'safe'
--> 10
--> 10
--> 10
--> 10
--> 10
--> 10
--> 9
--> 8
--> a false false
--> false 141
--> 0 2
fight 'armour'
--> 100
--> 100
--> 98
--> 96
--> 94
--> 86
--> 78
--> 92 1.0
--> a true true
--> c true true
--> true 70
--> 0 2
fight 'in armour'
--> 98
--> 92
--> a true true
--> c true true
--> true 63
--> 0 2

--case: a boss flies home between phases
fight 'home'
--> a false false
--> 50.0 40.0
--> c false false
--> false 147
--> 0 2

--case: talks come between phases
fight 'talks'
--> first true true
--> second true true
--> a true true
--> between true true
--> c true true
--> end true true
--> true 86
--> 0 2

--case: a warning comes before the fight
fight 'warning'
--> a true true
--> true 93
--> 0 2

--case: a background stays while phases share it, and the one before comes back
bg.show('yard', { over = 0 })
task.go(function()
  while true do
    wait(40)
    print(made)
  end
end)
fight 'halls'
--> 0
--> 1
--> p1 true true
--> 1
--> p2 true true
--> 1
--> p3 true true
--> 2
--> p4 true true
--> true 205
--> 0 2

--case: the background that is shown already stays
bg.show('hall', { over = 0 })
fight 'hall'
print(made)
--> a true true
--> true 102
--> 0 2
--> 1

--case: damage to all phases shows: hurt below a half, broken below a quarter
function sprite.put(t)
  shown[t.sprite] = put(t)
  return shown[t.sprite]
end
boss.fight('wounded')
wait(2)
print(shown.arrow.alive)
--> true true
--> a true true
--> false true
--> true false
--> c true true
--> false

--case: a boss with cut_in shows that picture instead of its portrait
function sprite.put(t)
  shown[t.sprite] = put(t)
  return shown[t.sprite]
end
boss.fight('declared')
wait(1)
print(shown.arrow, shown.wink ~= nil)
--> a true true
--> nil true

--case: a phase has its own portrait, or its leader's, or the boss's
boss.each(function(b)
  for _, p in ipairs(b.name == 'portraits' and b.phases or {}) do print(p.portrait, p.portrait_left, p.cut_in) end
end)
--> wink true true
--> arrow false true
--> dot false true
--> wink true false

--each: the stage's clock stops in a fight, or keeps running
stage.play('clock', sys.scope())
wait(140)
--> over 72
--> a true true
clocked.clock = true
stage.play('clock', sys.scope())
wait(140)
--> at 71

--each: casts
fight 'one bar'
--> 6 6
--> a true true
--> true 63
--> 0 2
fight 'bars'
--> iris 2 false
--> opal 3 1
--> iris 0 false
--> opal 2 1
--> opal 1 0
--> opal 0 0
--> a true true
--> true 66
--> 0 2
fight 'any'
--> a true true
--> true 62
--> 0 2
fight 'a bar for one'
--> true
--> a true true
--> true 64
--> 0 2
fight 'removed'
--> a true true
--> true 64
--> 0 2
fight 'both home'
print(enemy.count())
--> a false false
--> 30.0 40.0 90.0 40.0
--> c false false
--> false 136
--> 0 2
--> 0

--case: tries and captures of spells are counted for each ship
fight 'spells'
sys.leave(1)
sys.join(1, 'other')
boss.fight('spells')
for _, id in ipairs { 'a', 's', 'lost' } do print(boss.history('spells', id)) end
print(boss.history('spells', 's', { ship = 'ship' }))
print(boss.history('spells', 's', { ship = 'other' }))
--> a true true
--> s true true
--> lost false false
--> false 129
--> 0 2
--> a true true
--> s true true
--> lost false false
--> 0 0
--> 2 2
--> 2 0
--> 1 1
--> 1 1

--load: phases
boss.def('b', one({ talk = idle }))
--! boss.def: phases: expected at least one phase
boss.def('b', one(phase {}, phase {}))
--! boss.def: duplicate phase "a"
boss.def('b', one(phase { hp = { iris = 3 } }))
--! boss.def: phase "a": hp: expected a whole number from 1 to 2147483647, got a table
boss.def('b', one(phase { armor = 3 }))
--! boss.def phase "a": unknown argument "armor" (did you mean "armour"?)

boss.def('b', one(phase { bonus = 5, bonus_to = 7 }))
--! boss.def: phase "a": bonus_to: 7 is greater than `bonus` (5)
boss.def('b', one(phase { spell = 'S', cut_in = true }))
--! boss.def: phase "a": `cut_in` requires a portrait (`portrait = SPRITE`)
boss.def('b', one(phase { portrait = 'none' }))
--! boss.def phase "a": unknown sprite "none" (declare it in rom.lua)
boss.def('b', one({ talk = idle, id = 'x' }, phase {}))
--! boss.def talk: unknown argument "id" (arguments: talk)
boss.def('b', one({ talk = idle }, { hp = 5 }))
--! boss.def phase "#2": id: expected a string, got nil
boss.def('b', one(phase { music = 'x' }))
--! boss.def phase "a": unknown music "x" (declare it in rom.lua)
boss.def('b', one(3))
--! boss.def phase "#1": expected a table of named arguments, got 3

--load: casts
boss.def('b', two(phase { hp = { irs = 3 } }))
--! boss.def: phase "a": hp: no member of the cast is named "irs" (did you mean "iris"?)
boss.def('b', two(phase { hp = { iris = 0 } }))
--! boss.def: phase "a": hp: iris: expected a whole number from 1 to 2147483647, got 0
boss.def('b', two(phase { hp = {} }))
--! boss.def: phase "a": hp: expected { NAME = value }, got {}
boss.def('b', two(phase { hp = { 5, 6 } }))
--! boss.def: phase "a": hp: expected { NAME = value } with names from the cast
boss.def('b', two(phase { run = { opal = 5 } }))
--! boss.def: phase "a": run: opal: expected a function, got 5
boss.def('b', { title = 'B', kind = 'e', x = 5, y = 5, cast = {}, phases = { phase {} } })
--! boss.def: kind: set it on each member of the cast instead
boss.def('b', { title = 'B', cast = { { name = 'i', title = 'I', kind = 'e', x = 5, y = 5 } }, phases = {} })
--! boss.def: cast: expected at least two members, got 1
boss.def('b', { title = 'B', x = 5, y = 5, phases = { phase {} } })
--! boss.def: kind: expected a name, got nil

--each: fights and their history
task.go(function() boss.fight('bonus') end)
wait(1)
boss.fight('bonus')
--! boss.fight: boss "bonus": "bonus" is still fighting; for two bosses at once, declare one with `cast = { .. }`
boss.history('bonus', 'aa')
--! boss.history: unknown phase "aa" (did you mean "a"?)
boss.history('bonus', 'a', { difficulty = 'norml' })
--! boss.history: unknown difficulty "norml" (did you mean "normal"?)

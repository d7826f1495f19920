-- Rules of scoring, the tally of a stage, score tables, and what is unlocked.
--board: items=16
player.def('ship', {
  sprite = 'dot', hit = { circle = 3 }, lives = 5, safe = 0, collect_line = 100,
  registers = { chain = { max = 5 }, best = 0, value = 100 },
})
player.def('barge', { sprite = 'dot', hit = { circle = 3 }, registers = { chain = 0, value = 7 } })
game.def { registers = { rank = { start = 2, max = 9 } } }
bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })
for kind, worth in pairs { foe = 30, ace = 500, trio = 500, lord = 0 } do
  enemy.def(kind, { sprite = 'dot', hit = 'none', hp = 9, score = worth })
end
item.def('gem', { sprite = 'dot', radius = 5, gives = { score = { 100, 300 } } })
score.rule { on = 'kill', kind = 'foe', gain = { chain = 1 }, points = 10, times = 'chain', most = { best = 'chain' } }
score.rule { on = 'kill', kind = 'ace', set = { chain = 0 } }
score.rule { on = 'kill', kind = 'trio', times = 3 }
score.rule { on = 'kill', kind = 'lord', gain = { rank = 3 }, points = 10, times = 'rank', most = { best = 'rank' } }
score.rule { on = 'take', kind = 'gem', times = function(p) return p.value / 200 end }
score.rule { on = 'graze', points = 'value', gain = { value = 10 } }
score.rule { name = 'cancel', gain = { chain = 2 }, points = 5, times = 'chain' }
score.tally {
  { label = 'GRAZE', value = 'value', points = 2, stage = true },
  { label = 'NONE', value = function() end, points = 1 },
  { label = 'FIRST', value = function(p) return p.index == 1 end, points = 5 },
  { label = 'LIVES', value = 'lives', points = 1000, last = true },
}
unlock.def('all', { when = { clear = true } })
unlock.def('half', { when = { clear = 'one', continues = 1 }, title = 'Half of It' })
unlock.def('rich', { when = { ship = 'barge', score = 900 } })
unlock.def('odd', { when = function(run) return run.scores[1] == 7 end, hint = 'Be odd' })
stage.def('one', function() end)
local sys = string.sys
local p, q
local function join()
  sys.join(1, 'ship')
  sys.join(2, 'barge')
  p, q = player.get(1), player.get(2)
end
local function kill(kind, by)
  local e = enemy.spawn { kind = kind, x = 50, y = 50 }
  if by then e:hurt(9, by) else e:kill() end
end
local function start_game() boot.run { stages = { 'one' }, players = { 'ship' } } end

--case: a rule counts first, then gives points to the player who did it
join()
for _, by in ipairs { p, p, p, q } do kill('foe', by) end
kill('foe')
wait(1)
print(p.score, p.chain, p.best, q.score, q.chain)
kill('ace', p)
wait(1)
print(p.score, p.chain, p.best)
--> 220 4 4 40 1
--> 720 0 4

--case: without points, what a thing gives itself is multiplied, at any height
join()
kill('trio', p)
q.x, q.y = 30, 300
p.x, p.y = 100, 50
item.drop { kind = 'gem', from = p, speed = 0 }
wait(1)
print(p.score, q.score)
--> 1650 0

--case: points may be a register
join()
bullet.fire { kind = 'dot', from = p, dx = 12, dir = 0, speed = 0 }
wait(1)
print(p.score, p.value)
--> 110 110

--case: both players count on a register of the run
join()
sys.start(task.scope())
for _, by in ipairs { p, p, q } do kill('lord', by) end
wait(1)
print(p.score, q.score, game.rank, p.best)
--> 130 90 9 8

--case: score.count does a named rule n times; a register stops at its max
join()
for i = 1, 4 do bullet.fire { kind = 'dot', x = 60 + i, y = 40, dir = 0, speed = 0 } end
score.count('cancel', bullet.clear(), 2)
score.count('cancel', 0, p)
print(p.score, q.score, q.chain)
score.count('cancel', 1000000, p)
print(p.score, p.chain)
sys.leave(2)
score.count('cancel', 3, q)
print(q.score)
--> 0 160 8
--> 25000000 5
--> 160

--case: a tally gives each line's points, the last stage's too
join()
sys.emit('stage', 'one', 'start')
wait(1)
p.value, q.value = 150, 7
for _, last in ipairs { false, true } do
  for _, who in ipairs { p, q } do
    for _, line in ipairs(sys.scoring.tally(who, last)) do print(who.index, line.label, line.value, line.points) end
    print(who.score)
  end
end
--> 1 GRAZE 50 100
--> 1 FIRST nil 5
--> 105
--> 2 GRAZE 0 0
--> 0
--> 1 GRAZE 50 100
--> 1 FIRST nil 5
--> 1 LIVES 4 4000
--> 4210
--> 2 GRAZE 0 0
--> 2 LIVES 2 2000
--> 2000

--case: a table is by score, and a ship's has its rows alone
local function show(...)
  for i, r in ipairs(score.rows(...)) do print(i, r.name, r.score, r.ship, r.stage, r.clear, r.continues) end
end
print(score.enter('hard', { name = 'A', score = 9, ship = 'ship', stage = 2, continues = 1 }))
score.enter('hard', { name = 'B', score = 12, ship = 'barge', stage = 3, clear = true })
print(score.enter('hard', { name = 'C', score = 12 }))
show('hard')
show('hard', 'ship')
show('easy')
--> 1
--> 1
--> 1 B 12 barge nil true 0
--> 2 C 12 nil nil false 0
--> 3 A 9 ship 2 false 1
--> 1 A 9 ship 2 false 1

--case: a run earns what its conditions name, once
local function earn(run)
  local base = { cleared = {}, difficulty = 'normal', continues = 0, ships = { 'ship' }, scores = { 5 } }
  for k, v in pairs(run) do base[k] = v end
  print('earned', table.unpack(sys.unlock.earn(base)))
end
earn { stage = 'one' }
earn { stage = 'one', cleared = { one = true }, continues = 2 }
earn { stage = 'one', cleared = { one = true }, continues = 1 }
earn { clear = true }
earn { ships = { 'ship', 'barge' }, scores = { 9000, 899 } }
earn { ships = { 'ship', 'barge' }, scores = { 9000, 900 } }
print(sys.unlock.closed('odd'), sys.unlock.closed('all'), unlock.has('odd'))
earn { scores = { 7 }, stage = 'one' }
earn { scores = { 7 } }
earn { clear = true }
print(save.get('unlock/odd'), unlock.has('odd'))
--> earned
--> earned
--> earned Half of It
--> earned All
--> earned
--> earned Rich
--> Be odd nil false
--> earned
--> earned Odd
--> earned
--> true true

--load: arguments of rules
score.rule { on = 'kil', points = 1 }
--! score.rule: unknown event "kil" (did you mean "kill"?)
score.rule { points = 1 }
--! score.rule: expected either on (an event) or name (for score.count)
score.rule { name = 'kill', points = 1 }
--! score.rule: name: "kill" is an event; write on = "kill"
score.rule { on = 'kill', kind = 'fow', points = 1 }
--! score.rule: unknown enemy kind "fow" (did you mean "foe"?)
score.rule { on = 'death', kind = 'foe', points = 1 }
--! score.rule: kind: only for kill, graze and take
score.rule { on = 'graze', times = 2 }
--! score.rule: points: a required argument is missing (the event has none of its own)
score.rule { on = 'kill', points = true }
--! score.rule: points: expected a number, a register or a function, got boolean
score.rule { on = 'kill', gain = { chain = 0.5 } }
--! score.rule: gain: expected { REGISTER = n, .. }, whole numbers, got float
score.rule { on = 'kill' }
--! score.rule: expected one of points, times, gain, most, set
score.rule { on = 'kill', gain = { chian = 1 } }
sys.scoring.expect()
--! main.lua:186: score.rule: unknown register "chian" (did you mean "chain"?)
score.tally { { label = 'A', value = 'graze', points = 1 } }
sys.scoring.expect()
--! main.lua:189: score.tally: unknown register "graze" (did you mean "grazes"?)
score.tally { { label = 'A', value = 3, points = 1 } }
--! score.tally: line 1: value: expected a property, a register or a function, got number
score.tally {}
--! score.tally: expected at least one line, such as { label = "Bombs", value = "bombs", points = 1000 }
score.count('cancle', 1)
--! score.count: unknown rule "cancle" (did you mean "cancel"?)
score.enter('t', { name = 'A', score = 1, stage = 15 })
--! score.enter: stage: expected a whole number from 1 to 14, got 15

--load: arguments of unlocks
unlock.def('a', { when = true })
--! unlock.def: when: expected a table or a function, got boolean
unlock.def('a', { when = { cleared = true } })
--! unlock.def when: unknown argument "cleared" (did you mean "clear"?)
unlock.has('b')
--! unlock.has: unknown unlock "b" (known: all, half, rich, odd)
unlock.def('all', { when = {} })
--! unlock.def: unlock "all" is declared twice
unlock.def('a name of five and twenty', { when = {} })
--! unlock.def: name: expected a string of 1 to 24 bytes, got "a name of five and twenty"
unlock.def('a', { when = { clear = 'too' } })
start_game()
--! main.lua:212: unlock.def: unknown stage "too" (known: one)
unlock.def('a', { when = { spell = 'iris' } })
start_game()
--! main.lua:215: unlock.def: spell: expected "boss/id", a boss and the id of its phase, got "iris"
unlock.def('a', { when = { spell = 'iris/rain' } })
start_game()
--! main.lua:218: unlock.def: unknown boss "iris" (known: none)
stage.def('two', print, { needs = 'c' })
start_game()
--! main.lua:221: stage.def: unknown unlock "c" (known: all, half, rich, odd)

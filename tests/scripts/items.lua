-- Items: what they give, to whom they fly, where they come from.
--board: items=64 hp freeze
player.def('ship', { sprite = 'dot', hit = { circle = 3 }, lives = 5, safe = 0,
  registers = { power = { start = 4, max = 8 }, fuel = 2 }, collect_line = 100, collect_full = 'power' })
player.def('barge', { sprite = 'dot', hit = { circle = 3 }, registers = { fuel = 1 }, magnet = 0 })
item.def('gem', { sprite = 'dot', radius = 5, magnet = false, gives = { score = { 100, 300 } } })
item.def('cell', { sprite = 'dot', radius = 5, gives = { score = 7, power = 3, fuel = -9 }, full = 'power' })
item.def('heart', { sprite = 'dot', radius = 5, magnet = false, gives = { lives = 2 } })
item.def('rock', { sprite = 'dot', radius = 5, magnet = false, gravity = 0 })
item.def('note', { sprite = 'dot', radius = 4, magnet = false, gives = { score = 3 }, on_take = function(p, i)
  print('note', p.score, i.kind, i.alive, i.x)
end })
bullet.def('dot', { sprite = 'dot', hit = { circle = 3 }, hp = 1, drops = { rock = 2, gem = 1 } })
shot.def('bolt', { sprite = 'dot', hit = { circle = 3 } })
enemy.def('foe', { sprite = 'dot', hit = 'none', hp = 9, drops = { rock = 1, cell = 2 } })
spark.def('glow', { sprite = 'dot', life = 9 })
local wins
boss.def('b', { title = 'B', kind = 'foe', x = 100, y = 60, phases = { {
  id = 'p', hp = 5, time = 30, rest = 0, drops = { gem = 2 }, clear = { items = 'rock', spark = 'glow' },
  run = function(e)
    for i = 1, 4 do bullet.fire { kind = 'dot', x = 20 * i, y = 90, speed = 0 } end
    wait(5)
    if wins then e:hurt(9) end
    wait(forever)
  end,
} } })
on.extend(function(p) print('extend', p.lives) end)
on.hit(function() print 'hit' end)
on.death(function() print 'death' end)
on.phase(function(_, _, won) print('phase', won, bullet.group().count, board.live 'sparks') end)
local on_take
on.take(function(p, i) if on_take then on_take(p, i) end end)

local function two(kind)
  local p, q = player.get(1), player.get(2)
  string.sys.join(1, 'ship')
  if kind then string.sys.join(2, kind) end
  p.x, p.y, q.x, q.y = 100, 200, 40, 200
  return p, q
end
local function ship() return two() end
local function drop(kind, x, y, tag) return item.drop { kind = kind, x = x, y = y, speed = 0, tag = tag } end
local function give(kind, p, n) item.drop { kind = kind, from = p, n = n, speed = 0 } end
local function fire(x, tag) return bullet.fire { kind = 'dot', x = x, y = 50, speed = 0, tag = tag } end
local function foe(drops) return enemy.spawn { kind = 'foe', x = 50, y = 50, drops = drops } end
local function list()
  item.each(nil, function(i) print(i.kind, i.x, i.vx, i.vy) end)
  item.group():remove()
end

--case: points depend on the height: the most from the line up
local p = ship()
p.y = 210 -- half way from the line at 100 to the bottom at 320
give('gem', p)
wait(1)
print(p.score)
p.y = 100
give('gem', p)
wait(1)
print(p.score)
--> 200
--> 500

--case: registers stop at 0 and at their maximum, and then an item gives only points
local p, q = two('barge')
give('cell', p, 3)
wait(1)
print(p.score, p.power, p.fuel)
q.fuel = 20
give('cell', q)
wait(1)
print(q.score, q.fuel)
--> 21 8 0
--> 7 11

--case: lives
local p = ship()
give('heart', p, 2)
wait(1)
p.lives = 98
give('heart', p)
wait(1)
print(p.lives)
--> extend 8
--> extend 8
--> extend 99
--> 99

--case: the kind's handler runs first, then on.take; what is taken can be read, but not written
local p = ship()
on_take = function(_, i)
  print('on.take', i.x, i.tag)
  i:remove()
  i:pull()
  i.x = 3
end
drop('note', 101, 200, 'a')
drop('note', 99, 200)
wait(1)
print(item.group().count)
--> note 3 note false 101.0
--> on.take 101.0 a
--> note 6 note false 99.0
--> on.take 99.0 nil
--> 0

--case: an item that a handler removes is not taken
local p = ship()
on_take = function()
  print 'take'
  item.group():remove()
end
give('gem', p, 3)
wait(1)
print(item.group().count, p.score)
--> take
--> 0 209

--case: a player who is hit takes items first, and dies then
local p = ship()
on_take = function() print 'take' end
give('rock', p)
bullet.fire { kind = 'dot', from = p, speed = 0 }
wait(3)
--> hit
--> take
--> death

--case: what leaves the field is taken on its way
ship().x = 232
on_take = function(_, i) print('take', i.x) end
item.drop { kind = 'rock', x = 200, y = 200, dir = 0, speed = 500 }
item.drop { kind = 'rock', x = 200, y = 100, dir = 0, speed = 500 }
wait(1)
print(item.group().count)
--> take 700.0
--> 0

--case: the magnet attracts within its radius
ship().power = 0
drop('cell', 100, 176, 'in')
drop('cell', 100, 175, 'out')
wait(1)
item.each(nil, function(i) print(i.tag, i.vy > 1) end)
--> in true
--> out false

--case: above the line, or with a full register, a player attracts all items that can be
local p = ship()
drop('cell', 10, 300)
drop('gem', 10, 300)
local function attracted()
  wait(1)
  item.each(nil, function(i) print(i.kind, i.vy < -1) end)
end
p.y = 101
attracted()
p.power = 8
attracted()
item.group():remove()
p.power = 0
p.y = 100
drop('cell', 10, 300)
attracted()
--> cell false
--> gem false
--> cell true
--> gem false
--> cell true

--case: the nearest player attracts; of two as near, the first
local p, q = two('ship')
p.y, q.y, q.x = 60, 60, 140
drop('cell', 121, 60)
drop('cell', 120, 60)
wait(1)
item.each(nil, function(i) print(i.vx > 0) end)
--> true
--> false

--case: pull: to the nearest player, to a given one, to nobody
drop('rock', 50, 50, 'r')
item.group():pull()
wait(1)
local function each(f) item.each('r', f) end
each(function(i) print('nobody', i.vx, i.vy) end)
local p, q = two('ship')
each(function(i) i:pull() end)
wait(1)
each(function(i)
  print('to 2', i.vx < 0)
  i:pull(1)
end)
wait(1)
each(function(i) print('to 1', i.vx > 0) end)
--> nobody 0.0 0.0
--> to 2 true
--> to 1 true

--case: what flies to a player who dies or leaves stops; what flies to the other one does not
local p, q = two('ship')
for i = 1, 2 do
  drop('rock', 50, 50, 'to ' .. i)
  item.each('to ' .. i, function(one) one:pull(i) end)
end
wait(1)
bullet.fire { kind = 'dot', from = p, speed = 0 }
wait(1)
item.each(nil, function(i) print(i.tag, i.vx, i.vy > 1) end)
string.sys.leave(2)
wait(1)
item.each(nil, function(i) print(i.tag, i.vx, i.vy) end)
--> hit
--> death
--> to 1 0.0 false
--> to 2 -0.39910888671875 true
--> to 1 0.0 0.0
--> to 2 0.0 0.0

--case: drops are spread in the order of their names; an enemy's own come before those of its kind
foe():kill(1)
list()
foe({ gem = 1, heart = 0 }):kill()
foe():remove()
list()
foe({}):kill()
list()
wait(1)
foe():kill() -- in the slot of the one before
print(item.group().count)
--> cell 50.0 -0.51303100585938 -1.4095458984375
--> cell 50.0 0.0 -1.5
--> rock 50.0 0.51303100585938 -1.4095458984375
--> gem 50.0 0.0 -1.5
--> 3

--case: a bullet drops items when it is shot, and not when it is cleared
fire(50):clear()
fire(90)
shot.fire { kind = 'bolt', x = 90, y = 50, speed = 0 }
wait(1)
list()
--> gem 90.0 -0.51303100585938 -1.4095458984375
--> rock 90.0 0.0 -1.5
--> rock 90.0 0.51303100585938 -1.4095458984375

--case: a clear makes each bullet an item at rest
fire(10, 'a')
fire(20)
fire(30)
print(bullet.clear { x = 30, y = 50, radius = 5, items = 'rock' })
print(bullet.group('a'):clear { items = 'gem' })
bullet.each(nil, function(b) b:clear { items = 'heart', spark = 'glow' } end)
list()
print(board.live 'sparks')
fire(80)
wait_for(bullet.sweep { x = 50, y = 50, radius_to = 60, over = 4, items = 'rock' })
print(item.group().count, bullet.group().count)
--> 1
--> 1
--> rock 30.0 0.0 0.0
--> gem 10.0 0.0 0.0
--> heart 20.0 0.0 0.0
--> 1
--> 1 0

--each: a phase that is beaten drops items and makes its bullets items; one that is not only clears them
wins = true
boss.fight 'b'
list()
wait(1)
--> rock 20.0 0.0 0.0
--> rock 40.0 0.0 0.0
--> rock 60.0 0.0 0.0
--> rock 80.0 0.0 0.0
--> gem 100.0 -0.38822937011719 -1.4488830566406
--> gem 100.0 0.38822937011719 -1.4488830566406
--> cell 100.0 -0.51303100585938 -1.4095458984375
--> cell 100.0 0.0 -1.5
--> rock 100.0 0.51303100585938 -1.4095458984375
--> phase true 0 4

boss.fight 'b'
list()
wait(1)
--> phase false 0 4

--case: frozen items keep their place and speed; they are taken, but not attracted
item.drop { kind = 'gem', x = 50, y = 50, speed = 2 }
local function show() item.each(nil, function(i) print(i.kind, i.y, i.age, i.frozen) end) end
item.group().frozen = 3
wait(3)
show()
wait(1)
show()
item.group():remove()
local p = ship()
drop('cell', 100, 185)
give('rock', p)
item.group().frozen = 9
wait(3)
show()
--> gem 50.0 0 0
--> gem 48.039993286133 1 0
--> cell 185.0 0 6

--load: item.def and player.def
item.def('x', { sprite = 'dot', radius = 3, gives = { score = { 9, 3 } } })
--! item.def: gives.score: first 9 is greater than last 3 (did you mean { 3, 9 }?)
item.def('x', { sprite = 'dot', radius = 3, gives = { power = 1.5 } })
--! item.def: gives.power: expected a whole number from -2147483647 to 2147483647, got 1.5
item.def('x', { sprite = 'dot', radius = 3, gives = { pow = 1 } }) string.sys.join(1, 'ship')
--! item.def: item "x": unknown register "pow" (add registers = { pow = 0 } to player.def or game.def)
item.def('x', { sprite = 'dot', radius = 3, full = 'fuel' }) string.sys.join(1, 'ship')
--! item.def: full: register "fuel" has no max (write registers = { fuel = { max = n } } in player.def or game.def)
player.def('x', { sprite = 'dot', hit = { circle = 1 }, registers = { a = 3 }, collect_full = 'a' })
--! player.def: collect_full: register "a" has no max (write registers = { a = { max = n } })
player.def('x', { sprite = 'dot', hit = { circle = 1 }, collect_full = 'a' })
--! player.def: collect_full: unknown register "a" (add registers = { a = 0 } to player.def)
player.def('x', { sprite = 'dot', hit = { circle = 1 }, registers = { ab = 1 }, collect_full = 'a' })
--! player.def: collect_full: unknown register "a" (did you mean "ab"?)

--each: arguments
item.drop { kind = 'gam', x = 1, y = 1 }
--! item.drop: unknown item kind "gam" (did you mean "gem"?)
item.drop { kind = 'foe', x = 1, y = 1 }
--! item.drop: unknown item kind "foe" (found enemy kind "foe")
enemy.spawn { kind = 'foe', x = 1, y = 1, drops = { gem = -1 } }
--! enemy.spawn: drops.gem: expected a whole number from 0 to 65535, got -1
enemy.spawn { kind = 'foe', x = 1, y = 1, drops = { gems = 1 } }
--! enemy.spawn: unknown item kind "gems" (did you mean "gem"?)
enemy.spawn { kind = 'foe', x = 1, y = 1, drops = { 'gem' } }
--! enemy.spawn: drops: expected { NAME = n }, got a list
print(item.group().x)
--! items: x cannot be read from a group (only `count` can)

-- Bullets that meet bullets: what a pair of tags clears, whom it reports, and who takes part.
--board: meet freeze hp
spark.def('ping', { sprite = 'dot', life = 300, drag = 1 })
spark.def('pong', { sprite = 'wink', life = 300 })
bullet.def('dot', { sprite = 'dot', hit = { circle = 4 }, vanish = 'pong', cloud = 'wink' })
bullet.def('still', { sprite = 'dot', hit = { circle = 4 }, swept = false })
bullet.def('rock', { sprite = 'dot', hit = { box = { 6, 6 } }, clearable = false })
bullet.def('bar', { sprite = 'dot', hit = { capsule = { 12, 2 } } })
bullet.def('shade', { sprite = 'dot', hit = { circle = 9 }, harmless = true })
shot.def('eraser', { sprite = 'dot', hit = { circle = 3 }, cancels = true })
player.def('ship', { sprite = 'dot', hit = { circle = 2 }, lives = 3 })
on.hit(function() print 'hit' end)
on.graze(function() print 'graze' end)
local function tell(a, b) print(a.tag, a.x, b.tag, b.x) end
bullet.meet('none 1', 'none 2', { clear = 'none', on_meet = tell })
bullet.meet('first 1', 'first 2', { clear = 'first' })
bullet.meet('second 1', 'second 2', { clear = 'second', spark = 'ping' })
bullet.meet('both 1', 'both 2', { clear = 'both', on_meet = tell })
bullet.meet('all 1', 'all 2', { clear = 'both', all = true })
bullet.meet('own 1', 'own 2', { clear = 'both', on_meet = function(a) a:remove() end })
bullet.meet('group 1', 'group 2', { clear = 'both', on_meet = function() bullet.group('group 1'):remove() end })
bullet.meet('same', 'same', { on_meet = tell })
bullet.meet('two', 'ways', { on_meet = tell })
bullet.meet('ways', 'two', { on_meet = tell })

local function fire(tag, x, more)
  local t = { kind = 'dot', x = x or 50, y = 50, speed = 0, dir = 0, tag = tag }
  for k, v in pairs(more or {}) do t[k] = v end
  return bullet.fire(t)
end
local function pair(name) return fire(name .. ' 1'), fire(name .. ' 2') end
local function alive(name, a, b) print(name, a.alive, b.alive) end

--case: which of the two is cleared; a kind that is not clearable only by `all`
for _, name in ipairs { 'none', 'first', 'second', 'both', 'own' } do
  local a, b = pair(name)
  wait(1)
  alive(name, a, b)
  bullet.group():remove()
end
print(board.live 'sparks', 'sparks')
for _, name in ipairs { 'both', 'all' } do
  local a, b = fire(name .. ' 1'), fire(name .. ' 2', 52, { kind = 'rock' })
  b.hp = 9
  wait(1)
  alive(name, a, b)
end
--> none 1 50.0 none 2 50.0
--> none true true
--> first false true
--> second true false
--> both 1 50.0 both 2 50.0
--> both false false
--> own false false
--> 5 sparks
--> both 1 50.0 both 2 52.0
--> both false true
--> all false false

--case: one that is cleared meets no more, one that stays meets all that touch it
local function left(name, n_first, n_second)
  for _ = 1, n_first do fire(name .. ' 1') end
  for _ = 1, n_second do fire(name .. ' 2') end
  wait(1)
  print(name, bullet.group(name .. ' 1').count, bullet.group(name .. ' 2').count)
end
left('first', 5, 1)
left('second', 1, 3)
left('all', 5, 3)
--> first 0 1
--> second 1 2
--> all 2 0

--case: the nearest is met; a pair of one tag is reported once, a pair declared both ways twice
fire('none 2', 50)
fire('none 2', 56)
fire('none 2', 53)
fire('none 1', 59)
fire('none 1', 51.5)
wait(1)
bullet.group():remove()
for i = 1, 3 do fire('same', 50 + i) end
wait(1)
bullet.group():remove()
for i = 1, 2 do
  fire('two', 50 + i)
  fire('ways', 52 + i)
end
wait(1)
--> none 1 59.0 none 2 56.0
--> none 1 51.5 none 2 50.0
--> same 51.0 same 52.0
--> two 51.0 ways 53.0
--> two 52.0 ways 53.0
--> ways 53.0 two 52.0
--> ways 54.0 two 52.0

--case: what a handler removes meets no more
fire 'group 1'
fire('group 1', 90)
fire 'group 2'
local b = fire('group 2', 90)
wait(1)
print(b.alive, bullet.group().count)
--> true 1

--case: bullets meet on their way, or where a kind that is not swept is
local function moving(kind, to, speed)
  local a, b = fire('all 1', 50, { speed = 90, kind = kind }), fire('all 2', to, { dir = 180, speed = speed })
  wait(1)
  alive(kind, a, b)
  bullet.group():remove()
end
moving('dot', 100, 0)
moving('still', 100, 0)
moving('still', 180, 80)
--> dot false false
--> still true true
--> still false false

--case: a capsule lies along `dir`
local a, b = fire('all 1', 50, { kind = 'bar' }), fire('all 2', 60)
wait(1)
alive('along', a, b)
a, b = fire('all 1', 50, { kind = 'bar', dir = 90 }), fire('all 2', 60)
wait(1)
alive('across', a, b)
--> along false false
--> across true true

--case: a delayed bullet meets nothing, as the first or the second
for _, first in ipairs { 5, 0 } do
  local a, b = fire('all 1', 50, { delay = first }), fire('all 2', 50, { delay = 5 - first })
  wait(5)
  alive('delayed', a, b)
  wait(1)
  alive('not delayed', a, b)
end
--> delayed true true
--> not delayed false false
--> delayed true true
--> not delayed false false

--case: a frozen bullet meets others where it is
local a, b = fire('all 1', 50, { speed = 9 }), fire('all 2', 60)
a.frozen = 3
wait(3)
alive('frozen', a, b)
wait(1)
alive('moves', a, b)
a, b = fire('all 1', 50, { speed = 3 }), fire('all 2', 60)
b.frozen = forever
wait(2)
alive('moves to a frozen one', a, b)
--> frozen true true
--> moves false false
--> moves to a frozen one false false

--case: a bullet meets others on its way out of the field
fire('none 1', 280, { speed = 60 })
fire('none 2', 300)
wait(1)
bullet.group():remove()
fire('none 1', 300)
fire('none 2', 280, { speed = 60 })
wait(1)
--> none 1 340.0 none 2 300.0
--> none 1 300.0 none 2 340.0

--case: tags can be taken off and put on
local a, b = fire 'all 1', fire 'all 2'
b.tag = nil
wait(1)
alive('no tag', a, b)
b.tag = 'all 2'
wait(1)
alive('tag', a, b)
--> no tag true true
--> tag false false

--case: shots come first
local a, b = fire 'both 1', fire('both 2', 57)
shot.fire { kind = 'eraser', x = 43, y = 50, speed = 0 }
wait(1)
alive('shot', a, b)
--> shot false true

--case: a harmless bullet neither hits nor grazes
string.sys.join(1, 'ship')
local p = player.get(1)
p.x, p.y, p.safe = 100, 50, 0
local b = fire('x', 100, { kind = 'shade' })
fire('x', 114, { kind = 'shade' })
wait(3)
print 'another kind'
b.kind = 'dot'
wait(1)
--> another kind
--> hit

--load: arguments
bullet.meet('a', 'b', { clear = 'frist' })
--! bullet.meet: clear: expected none, first, second or both, got "frist"
bullet.meet('a', 'b', {})
--! bullet.meet: expected `clear` or `on_meet` (without either, a meeting has no effect)
bullet.meet('a', 'b', { clear = 'none', all = true, on_meet = print })
--! bullet.meet: all: requires `clear`
bullet.meet('same', 'same', { clear = 'first' })
--! bullet.meet: tags "same" and "same" are already declared as a pair
for i = 1, 17 do bullet.meet('a', 'b' .. i, { clear = 'both' }) end
--! bullet.meet: too many pairs of tags (at most 16)

--each: after scripts have loaded
bullet.meet('a', 'b', { clear = 'both' })
--! bullet.meet: can only be called while scripts load

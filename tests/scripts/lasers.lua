-- Lasers: whom they hit and when, what they follow, what a clear leaves of them, and what finds them.
--board: lasers=8 curve_points=256 items=64 freeze orbit
laser.def('ray', { strip = 'dot', width = 10, hit = { share = 0.5 } })
laser.def('wall', { strip = 'dot', width = 8, hit = { share = 1 }, clearable = false, graze = 0 })
laser.def('mist', { strip = 'dot', width = 8, hit = 'none' })
laser.def('lance', { strip = 'dot', width = 6, hit = { share = 1 }, damage = 3, every = 4 })
spark.def('glint', { sprite = 'dot', life = 50 })
item.def('gem', { sprite = 'dot', radius = 3, gravity = 0 })
bullet.def('orb', { sprite = 'dot', hit = 'none' })
enemy.def('fly', { sprite = 'dot', hp = 100, hit = { circle = 5 }, touch = false })
enemy.def('box', { sprite = 'dot', hp = 100, hit = { box = { 10, 10 } }, touch = false })
player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 16, safe = 0, lives = 90 })
on.graze(function(_, l) print('graze', l.kind, l.state) end)
on.hit(function(p, l)
  print('hit', l.kind, l.state)
  p.safe = 1
end)

local function ship()
  string.sys.join(1, 'ship')
  local p = player.get(1)
  p.x, p.y = 120, 200
  return p
end

-- A beam that is dangerous at once and stays.
local function beam(t)
  t.kind, t.hold, t.warn, t.grow = t.kind or 'wall', forever, 0, 0
  return laser.beam(t)
end

local function take_items()
  item.each(nil, function(i) print(i.x, i.y, i.vx, i.vy) end)
  item.group():remove()
end

--case: a field that is emptied has no lasers, and no points of theirs
beam { x = 1, y = 1, length = 9 }
laser.curve { kind = 'ray', x = 50, y = 50, speed = 1, points = 40 }
print(board.live 'lasers', board.live 'laser_heads', board.live 'laser_points')
string.sys.wipe()
print(board.live 'lasers', board.live 'laser_heads', board.live 'laser_points')
--> 2 2 2
--> 0 0 0

--each: a beam hits what it passes between two frames, but not when a script turns it
ship().y = 190
beam { x = 120, y = 10, dir = 114, length = 200, spin = -16, width = 2 }
wait(6)
--> hit wall on

ship().y = 190
local b = beam { x = 120, y = 10, dir = 114, length = 200, width = 2 }
wait(3)
b.dir = 66
wait(5)
print(b.dir // 1)
--> 66.0

--case: a beam follows an entity, turns with it, and ends with it
local e = enemy.spawn { kind = 'fly', x = 50, y = 50 }
local o = bullet.fire { kind = 'orb', x = 60, y = 100, dir = 10, speed = 2 }
local a = beam { follow = e, dx = 3, dy = 4, length = 50 }
local b = beam { follow = o, dir = 40, length = 50, turns = true }
wait(1)
print(a.x, a.y)
e.x = 80
o.dir = 130
wait(1)
print(a.x, b.x == o.x, b.y == o.y, (b.dir - o.dir + 0.5) // 1)
e:remove()
wait(2)
print(a.alive, b.alive)
o:remove()
wait(2)
print(b.alive)
--> 53.0 54.0
--> 83.0 true true 30.0
--> false true
--> false

--case: a beam is where the curve is that it follows, though that has the higher slot
local first = beam { x = 1, y = 1, length = 5 }
local c = laser.curve { kind = 'ray', x = 20, y = 50, dir = 10, speed = 3, points = 9 }
first:remove()
local b = beam { follow = c, dy = 2, length = 50 }
for _ = 1, 30 do
  wait(1)
  assert(b.x == c.x and b.y == c.y + 2)
end

--case: a curve goes round a laser the same way, whichever of the two has the lower slot
local around = motion.def { { orbit = 30, spin = 3, over = forever } }
local function pair(swaps)
  local first = swaps and beam { x = 1, y = 1, length = 5 }
  local c = laser.bolt { kind = 'ray', x = 60, y = 50, dir = 40, speed = 2, length = 9 }
  if first then first:remove() end
  return laser.curve { kind = 'ray', x = 90, y = 50, speed = 1, motion = around, around = c, points = 9 }
end
local a, b = pair(false), pair(true)
for _ = 1, 60 do
  wait(1)
  assert(a.x == b.x and a.y == b.y)
end

--case: a bolt comes out of its place and ends when all of it has left the field
local b = laser.bolt { kind = 'ray', x = 20, y = 30, dir = 0, speed = 4, length = 30 }
wait(5)
print(b.x, b.y, #query.near { what = 'laser', x = 20, y = 30, radius = 0 })
wait(10)
print(b.x, b.y, #query.near { what = 'laser', x = 20, y = 30, radius = 0 })
wait(63)
print(b.alive)
wait(1)
print(b.alive)
--> 40.0 30.0 1
--> 80.0 30.0 0
--> true
--> false

--each: a bolt hits what it passes, however fast it is, and not while it is delayed
ship()
laser.bolt { kind = 'wall', x = 120, y = 20, dir = 90, speed = 400, length = 4 }
wait(2)
--> hit wall on

ship()
laser.bolt { kind = 'wall', x = 120, y = 200, dir = 90, speed = 0, length = 4, delay = 3 }
wait(3)
print 'delay is over'
wait(1)
--> delay is over
--> hit wall on

--case: a write of a curve's place moves all of it, and passes nothing
ship()
local c = laser.curve { kind = 'wall', x = 60, y = 100, dir = 0, speed = 2, points = 10 }
wait(20)
c.y = 300
wait(5)
c:shift(7, -30)
wait(5)
print(c.x, c.y)
print(#query.near { what = 'laser', x = c.x - 18, y = 270, radius = 0 }, 'its end')
print(#query.near { what = 'laser', x = c.x - 24, y = 270, radius = 0 }, 'beyond its end')
--> 127.0 270.0
--> 1 its end
--> 0 beyond its end

--case: it grazes every `graze` frames, and a kind with `graze = 0` never
local p = ship()
beam { kind = 'ray', x = 132, y = 10, length = 250 }
beam { kind = 'wall', x = 108, y = 10, length = 250 }
wait(25)
print(p.grazes)
--> graze ray on
--> graze ray on
--> graze ray on
--> graze ray on
--> 4

--case: a laser with `damage` hits all enemies it touches every `every` frames, and no players
local p = ship()
local a = enemy.spawn { kind = 'fly', x = 120, y = 60 }
local b = enemy.spawn { kind = 'box', x = 127, y = 100 }
local c = enemy.spawn { kind = 'box', x = 129, y = 130 }
local s = laser.beam { kind = 'lance', follow = p, dir = 270, length = 180, hold = 9, warn = 0, grow = 0 }
print(s.by == p)
for _, frames in ipairs { 1, 3, 1, 3, 1, 9 } do
  wait(frames)
  print(a.hp, b.hp, c.hp)
end
--> true
--> 97 97 100
--> 97 97 100
--> 94 94 100
--> 94 94 100
--> 91 91 100
--> 91 91 100

--case: a clear takes lasers that it touches, whole, but not fixed ones or those of players
local function four()
  beam { kind = 'ray', x = 10, y = 50, dir = 0, length = 120 }
  beam { kind = 'wall', x = 10, y = 60, dir = 0, length = 120 }
  beam { kind = 'lance', x = 10, y = 70, dir = 0, length = 120 }
  beam { kind = 'mist', x = 10, y = 90, dir = 0, length = 120, tag = 'm' }
  wait(1)
end
local function taken(n)
  print(n, laser.group().count, board.live 'sparks')
end
four()
taken(bullet.clear { lasers = false })
taken(bullet.clear { x = 133, y = 55.5, radius = 2, spark = 'glint' })
taken(laser.clear { x = 200, y = 90, w = 130, h = 2 })
taken(laser.clear { x = 200, y = 90, w = 133, h = 2, every = 30, spark = 'glint' })
taken(laser.clear { x = 60, y = 10, to_x = 60, to_y = 300, width = 0, all = true })
laser.group():clear { spark = 'glint', every = 60 }
taken(0)
four()
taken(laser.group('m'):clear {})
laser.each(nil, function(l) l:clear {} end)
taken(0)
--> 0 4 0
--> 1 3 10
--> 0 3 10
--> 1 2 14
--> 1 1 14
--> 0 0 16
--> 1 3 16
--> 0 0 16

--case: a clear leaves items along a laser, the first half a spacing from its start
beam { kind = 'ray', x = 10, y = 50, dir = 0, length = 40 }
bullet.clear { items = 'gem' }
take_items()
print 'every 25'
beam { kind = 'ray', x = 10, y = 90, dir = 90, length = 100, tag = 't' }
laser.group('t'):clear { items = 'gem', every = 25 }
take_items()
print 'shorter than a spacing'
beam { kind = 'ray', x = 10, y = 20, dir = 0, length = 3 }:clear { items = 'gem' }
take_items()
print 'a sweep'
local w = beam { x = 30, y = 200, dir = 0, length = 50 }
wait(1)
bullet.sweep { x = 30, y = 200, radius = 4, radius_to = 9, over = 1, items = 'gem' }
bullet.sweep { x = 30, y = 200, radius = 4, radius_to = 9, over = 1, all = true, lasers = false }
wait(1)
print(w.alive)
bullet.sweep { x = 30, y = 200, radius = 4, radius_to = 9, over = 1, items = 'gem', all = true }
wait(1)
take_items()
--> 16.0 50.0 0.0 0.0
--> 28.0 50.0 0.0 0.0
--> 40.0 50.0 0.0 0.0
--> every 25
--> 10.0 102.5 0.0 0.0
--> 10.0 127.5 0.0 0.0
--> 10.0 152.5 0.0 0.0
--> 10.0 177.5 0.0 0.0
--> shorter than a spacing
--> 10.0 20.0 0.0 0.0
--> a sweep
--> true
--> 36.0 200.0 0.0 0.0
--> 48.0 200.0 0.0 0.0
--> 60.0 200.0 0.0 0.0
--> 72.0 200.0 0.0 0.0

--case: a curve leaves items along its bends
local bend = motion.def { { wait = 9 }, { dir = 90 } }
laser.curve { kind = 'ray', x = 20, y = 40, dir = 0, speed = 4, points = 31, motion = bend }
wait(31)
laser.clear { items = 'gem', every = 20 }
take_items()
--> 56.0 118.0 0.0 0.0
--> 56.0 98.0 0.0 0.0
--> 56.0 78.0 0.0 0.0
--> 56.0 58.0 0.0 0.0
--> 54.0 40.0 0.0 0.0
--> 34.0 40.0 0.0 0.0

--case: queries find a laser by its shape, and sort by its nearest point
local function found(list)
  local tags = {}
  for i, l in ipairs(list) do tags[i] = l.tag end
  print(#list > 0 and table.concat(tags, ' ') or 'none')
end
beam { kind = 'ray', x = 10, y = 50, dir = 0, length = 120, tag = 'a' }
beam { kind = 'mist', x = 100, y = 90, dir = 90, length = 60, tag = 'b' }
laser.bolt { kind = 'ray', x = 200, y = 60, dir = 180, speed = 20, length = 20, tag = 'c' }
wait(2)
found(query.near { what = 'laser', x = 100, y = 75, radius = 16 }) -- b is 15 - 4 px away, a 25 - 5
found(query.near { what = 'laser', x = 100, y = 75, radius = 20 })
found(query.near { what = 'laser', x = 150, y = 60, radius = 90 }) -- c is at 10, a at 22, b at 58
found(query.near { what = 'laser', x = 150, y = 60, radius = 90, tag = 'b' })
found(query.box { what = 'laser', x = 100, y = 200, w = 6, h = 105 }) -- from 147.5; b ends at 154
found(query.box { what = 'laser', x = 100, y = 207, w = 6, h = 105 })
found(query.line { what = 'laser', x = 0, y = 0, to_x = 240, to_y = 0, width = 89 })
found(query.line { what = 'laser', x = 0, y = 150, to_x = 240, to_y = 150, width = 2 })
--> b
--> b a
--> c a b
--> b
--> b
--> none
--> none
--> b

--case: properties
local b = laser.beam { kind = 'ray', x = 50, y = 40, length = 60, hold = forever, tag = 'one', bank = 3 }
local c = laser.curve { kind = 'ray', x = 50, y = 40, dir = 0, speed = 5, points = 8 }
print(b.form, b.state, b.x, b.y, b.dir, b.length, b.width, b.spin, b.kind, b.tag, b.bank, b.age)
print(c.form, c.state, c.speed, c.vx, c.length)
b.x, b.length, b.width, b.spin, b.tag, b.bank = 55, 20, 4, 2, 'two', 1
b.speed = 9 -- has no effect
print(b.x, b.length, b.width, b.tag, b.bank, b.speed)
print(laser.group('one').count, laser.group('two').count, laser.group().count)
ship()
b:aim(10)
print((b.dir - angle.of(65, 160) + 0.5) // 1)
--> beam warn 50.0 40.0 90.0 60.0 10.0 0.0 ray one 3 0
--> curve on 5.0 5.0 0.0
--> 55.0 20.0 4.0 two 1 0.0
--> 0 1 2
--> 10.0

--case: a curve that is frozen, turned and shifted
local c = laser.curve { kind = 'ray', x = 50, y = 40, dir = 0, speed = 5, points = 8 }
wait(1)
c.frozen = 2
wait(2)
print(c.x, c.length, c.age)
wait(1)
c.vx = 3
wait(1)
laser.group():shift(1, 2)
laser.group().width = 7
print(c.x, c.y, c.width)
--> 55.0 5.0 1
--> 64.0 42.0 7.0

--case: fade ends a laser as it would itself, one that warns at once
local b = laser.beam { kind = 'ray', x = 50, y = 40, length = 60, hold = forever }
local c = laser.curve { kind = 'ray', x = 50, y = 40, dir = 0, speed = 5, points = 8 }
c:fade()
b:fade()
print(c.state)
wait(12)
print(b.alive, c.alive)
wait(1)
print(c.alive)
--> fade
--> false true
--> false

--case: tasks of a laser pause while it is frozen, and end with it
local c = laser.curve { kind = 'ray', x = 50, y = 50, speed = 1 }
task.own(c, function()
  for i = 1, forever do
    print(i)
    wait(1)
  end
end)
wait(2)
c.frozen = 4
print 'frozen'
wait(5)
print 'not frozen'
wait(1)
c:remove()
print 'removed'
wait(2)
--> 1
--> 2
--> frozen
--> 3
--> not frozen
--> 4
--> removed

--case: patterns fire lasers
pattern.ring { kind = 'ray', fire = 'curve', x = 120, y = 100, n = 3, speed = 2, points = 9 }
pattern.fan { kind = 'ray', fire = 'bolt', x = 120, y = 100, n = 2, spread = 40, speed = 2, length = 9 }
pattern.line { kind = 'mist', fire = 'beam', x = 120, y = 60, n = 2, width = 40, hold = 9, length = 50 }
laser.each(nil, function(l) print(l.form, l.x) end)
--> curve 120.0
--> curve 120.0
--> curve 120.0
--> bolt 120.0
--> bolt 120.0
--> beam 140.0
--> beam 100.0

--each: arguments
laser.beam { kind = 'rya', x = 1, y = 1, length = 9, hold = 1 }
--! laser.beam: unknown laser kind "rya" (did you mean "ray"?)
pattern.ring { kind = 'ray', x = 1, y = 1, n = 3, speed = 3 }
--! pattern.ring: unknown bullet kind "ray" (found laser kind "ray")
laser.beam { kind = 'ray', x = 1, follow = ship(), length = 9, hold = 2 }
--! laser.beam: `follow` cannot be combined with `x`, `y` or `from`
laser.beam { kind = 'ray', x = 1, y = 1, turns = true, length = 9, hold = 2 }
--! laser.beam: turns: requires `follow`
laser.curve { kind = 'ray', x = 1, y = 1, speed = 1 }.length = 3
--! laser: length: cannot be set on a curve (`points` sets its length)
pattern.stack { kind = 'ray', fire = 'beam', x = 1, y = 1, n = 3, speed_to = 3, length = 9, hold = 1 }
--! pattern.stack: fire: this figure sets speeds, but beams have no speed
print(laser.group().x)
--! lasers: x cannot be read from a group (only `count` can)

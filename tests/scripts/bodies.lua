-- Enemies with parts: where parts are, the damage they pass on, their end; orbits and wandering.
--board: bodies items=16
spark.def('ping', { sprite = 'dot', life = 300 })
item.def('coin', { sprite = 'dot', radius = 3, gives = { score = 1 } })
shot.def('bolt', { sprite = 'dot', hit = { circle = 3 }, damage = 2 })
enemy.def('foe', { sprite = 'dot', hit = { circle = 8 }, hp = 20, touch = false })
enemy.def('tip', { sprite = 'dot', hit = { circle = 4 }, hp = 3, touch = false, spark = 'ping' })
enemy.def('arm', {
  sprite = 'dot', hit = { circle = 4 }, hp = 9, touch = false, spark = 'ping',
  parts = { { kind = 'tip', dy = 10, share = 0.5 } },
})
enemy.def('crab', {
  sprite = 'dot', hit = { circle = 8 }, hp = 50, touch = false,
  parts = {
    { kind = 'arm', dx = -20, share = 1, tag = 'left' },
    { kind = 'arm', dx = 20, dy = 5, hp = 4, rate = 0.5, tag = 'right' },
  },
})
on.kill(function(e) print('kill', e.kind) end)
on.leave(function(e) print('leave', e.kind) end)
local function foe(x, y) return enemy.spawn { kind = 'foe', x = x or 100, y = y or 100 } end
local function waited(m) -- the frames that wait_for takes
  local from = board.frame()
  wait_for(m)
  return board.frame() - from
end
local function part(body, t)
  t.kind, t.follow = t.kind or 'tip', body
  return enemy.spawn(t)
end

--case: an enemy spawns with the parts of its kind
local e = enemy.spawn { kind = 'crab', x = 100, y = 100 }
for _, a in ipairs(e:parts()) do print(a.tag, a.x, a.y, a.hp, a.rate, a.follow == e, #a:parts()) end
local tip = e:parts('left')[1]:parts()[1]
print(tip.x, tip.y, tip.dx, tip.dy, tip.share, tip.rate)
print(e.follow, e.dx, e.share, #e:parts('none'))
--> left 80.0 100.0 9 1.0 true 1
--> right 120.0 105.0 4 0.5 true 1
--> 80.0 110.0 0.0 10.0 0.5 1.0
--> nil nil nil 0

--case: writing a part's place or its distance sets the other
local e = foe()
local c = part(e, { dx = 10 })
c.dx = 30
c.y = 90
print(c.x, c.dy)
e.x = 50
wait(1)
print(c.x, c.y)
c:move { x = 70, y = 100, over = 2 }
wait(2)
print(c.dx, c.dy)
c:shift(1, 2)
wait(1)
print(c.dx, c.dy)
--> 130.0 -10.0
--> 80.0 90.0
--> 20.0 0.0
--> 21.0 2.0

--each: parts leave with their body, and not by themselves
local e = foe()
local c = part(e, { dx = 300 })
wait(5)
print(c.alive, c.x)
e.y = -90
wait(1)
print(e.alive, c.alive)
--> true 400.0
--> leave foe
--> false false

local e = foe()
local c = part(e, {})
local d = part(c, {})
e:remove()
print(c.alive, d.alive, part(e, {}).alive)
--> false false false

--case: `rate` scales damage, and fractions of a hp add up
local e = foe()
e.rate = 0.25
for i = 1, 4 do e:hurt(1) end
print(e.hp)
e.rate = 0
e:hurt(99)
print(e.hp)
e.rate = 3
e:hurt(2)
print(e.hp)
--> 19
--> 19
--> 13

--each: a part passes its share of damage on
local e = foe() -- of the tip's 3 hp only
local c = part(e, { share = 0.5 })
c:hurt(1)
c:hurt(99)
wait(1)
print(c.alive, e.hp)
--> kill tip
--> false 19

local e = foe()
local c = part(e, { share = 1, hp = 9 })
e.rate, e.hp = 0.5, 1
c:hurt(1)
print(e.hp)
c:hurt(1)
print(e.alive, c.alive)
wait(1)
--> 1
--> false false
--> kill foe

local e = foe()
local c = part(e, { dy = 30, share = 1, hp = 5 })
shot.fire { kind = 'bolt', x = 100, y = 150, speed = 10 }
wait(9)
print(c.hp, e.hp)
--> 3 18

--each: parts burst with their body
local e = enemy.spawn { kind = 'crab', x = 100, y = 100, on_death = function(e) print(#e:parts()) end }
e:kill()
print(enemy.count(), board.live('sparks'))
wait(1)
--> 2
--> 0 48
--> kill crab

local e = enemy.spawn { kind = 'foe', x = 100, y = 100, on_death = function(e) e:parts()[1]:kill() end }
part(e, {})
e:kill()
wait(1)
print(board.live('enemies'))
--> kill foe
--> kill tip
--> 0

local e = foe() -- without drops
part(e, { drops = { coin = 3 } })
e:kill()
wait(1)
print(board.live('items'))
part(foe(), { drops = { coin = 3 } }):kill()
wait(1)
print(board.live('items'))
--> kill foe
--> 0
--> kill tip
--> 3

--each: orbits
local e = foe()
e:orbit { x = 100, y = 60, spin = 90, over = 3 }
for _, frames in ipairs { 1, 1, 4 } do
  wait(frames)
  print(e.x, e.y)
end
--> 60.0 60.0
--> 100.0 20.0
--> 140.0 60.0

local e, a = foe(), foe(50, 50) -- around an enemy in a higher slot, until it dies
e:orbit { around = a, radius = 10, dir = 90, spin = 0 }
a:move { x = 60, y = 50, over = 2 }
wait(1)
print(e.x)
a:kill()
wait(3)
print(e.x, e.y)
--> 55.0
--> kill foe
--> 55.0 60.0

local e, a = foe(0, 0), foe(50, 50) -- around each other
e:orbit { around = a, radius = 9, spin = 3 }
a:orbit { around = e, radius = 9, spin = 3 }
wait(50)
print(e.alive, a.alive)
--> true true

--each: what move, orbit and wander return ends with the movement
local e = foe()
print(waited(e:move { x = 90, y = 90, over = 30 }), e.x, e.y)
print(waited(e:orbit { x = 50, y = 90, spin = 6, over = 15 }))
--> 30 90.0 90.0
--> 15
local e = foe()
task.go(function() wait(8) e:wander { w = 9, h = 9, every = 5, over = 3 } end)
print(waited(e:orbit { x = 50, y = 90, spin = 6 }))
local m = e:wander { w = 9, h = 9, every = 5, over = 3 }
wait(12)
print(m.alive)
e.x = 50
print(m.alive, waited(m))
--> 9
--> true
--> false 0
local e = foe()
task.go(function() wait(3) e:kill() end)
print(waited(e:move { dx = 9, dy = 0, over = 50 }))
print(waited(e:move { dx = 9, dy = 0, over = 50 }), enemy.group():move { dx = 1, dy = 1, over = 2 })
--> kill foe
--> 4
--> 0
local a = foe()
local m = a:move { dx = 9, dy = 0, over = 50 }
a:remove()
wait(1)
local b = foe() -- in the same slot
b:move { dx = 9, dy = 0, over = 50 }
print(m.alive)
--> false
local m = foe():move { dx = 9, dy = 0, over = 50 } m.speed = 3
--! a move has no property "speed"

--case: a wanderer stays in its area
local e, least, most = foe(), 999, 0
e:wander { w = 40, h = 0, every = 6, over = 4 }
for i = 1, 150 do
  wait(1)
  least, most = math.min(least, e.x), math.max(most, e.x)
  assert(e.y == 100)
end
print(least >= 80, most <= 120, most - least > 25)
--> true true true

--each: arguments
enemy.spawn { kind = 'foe', x = 1, follow = foe() }
--! enemy.spawn: `follow` cannot be combined with a position or a path
enemy.spawn { kind = 'foe', x = 1, y = 1, share = 1 }
--! enemy.spawn: share: requires `follow`
foe().dx = 3
--! enemy: dx: this enemy is not a part (enemy.spawn { follow = .. } spawns one)
foe():move { x = 1, over = 3 }
--! enemy:move: expected either `x` and `y` or `dx` and `dy`
foe():orbit { spin = 3 }
--! enemy:orbit: expected either `around` (a thing) or `x` and `y`
local e = foe()
e:orbit { around = e, spin = 3 }
--! enemy:orbit: around: an enemy cannot orbit itself
foe():orbit { x = 1, y = 1, spin = 3, radius_to = 9 }
--! enemy:orbit: radius_to: requires `over`
foe():wander { w = 9, h = 9, every = 20, over = 40 }
--! enemy:wander: over: expected at most `every` (20 frames), got 40
local e = foe()
for i = 1, 9 do e = enemy.spawn { kind = 'tip', follow = e } end
--! enemy.spawn: follow: parts nested more than 8 deep
foe()
enemy.group().share = 1 -- of enemies that are no parts, nothing is written
enemy.group().dx = 3
print(enemy.count())
--> 1

--load: arguments of enemy.def
enemy.def('body', { sprite = 'dot', hit = 'none', parts = {} })
--! enemy.def: parts: expected a list of 1 to 64 parts { kind = .., dx = .., dy = .. }, got 0
enemy.def('body', { sprite = 'dot', hit = 'none', parts = { 'foe' } })
--! enemy.def: parts[1]: expected { kind = .., dx = .., dy = .. }, got string
enemy.def('body', { sprite = 'dot', hit = 'none', parts = { { kind = 'foe', shore = 1 } } })
--! enemy.def part: unknown argument "shore" (did you mean "share"?)
local function nested(kind) return { sprite = 'dot', hit = 'none', parts = { { kind = kind } } } end
enemy.def('k0', nested('foe'))
for i = 1, 8 do enemy.def('k' .. i, nested('k' .. i - 1)) end
--! enemy.def: parts: nested more than 8 deep

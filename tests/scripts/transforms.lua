-- Pictures that turn, are scaled and are translucent: what scripts see of them, and what scaled shapes hit.
-- test_transforms.c draws them, test_hits.c tests the shapes at all sizes.
--board: transforms options=8
bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })
shot.def('bolt', { sprite = 'dot', hit = { circle = 1 } })
enemy.def('foe', { sprite = 'arrow', hit = { circle = 8 }, hp = 9, touch = false, turns = true })
enemy.def('post', { sprite = 'arrow', hit = { circle = 8 }, hp = 9, scale_hit = true, scale = 0.5, alpha = 3 })
local bead
option.def('bead', { sprite = 'arrow', turns = true, run = function(o) bead = o end })
player.def('ship', { sprite = 'dot', hit = { circle = 2 }, safe = 0, options = {
  kind = 'bead', levels = { { wide = { { 0, 20 } } } } } })

--case: an enemy turns to where it really moves, and keeps its direction while it stands still
local e = enemy.spawn { kind = 'foe', x = 100, y = 100, dir = 45 }
print(e.dir)
wait(1)
print(e.dir)
e:move { x = 100, y = 140, over = 10 }
wait(2)
print(e.dir)
wait(20)
print(e.dir, e.y)
e:move { dx = -20, dy = 0, over = 2 }
wait(2)
print(e.dir)
e.dir = 22.5
wait(3)
print(e.dir)
e.x = 200
wait(2)
print(e.dir)
--> 45.0
--> 45.0
--> 90.0
--> 90.0 140.0
--> 180.0
--> 22.5
--> 22.5

--case: scale and alpha of an enemy: its kind's, its own, written
local e = enemy.spawn { kind = 'post', x = 9, y = 9 }
local f = enemy.spawn { kind = 'post', x = 9, y = 9, scale = 4, alpha = 8 }
print(e.scale, e.alpha, e.dir, f.scale, f.alpha)
e.scale, e.alpha = 1.125, 0
print(e.scale, e.alpha)
enemy.group().scale = 2
print(e.scale, f.scale)
--> 0.5 3 0.0 4.0 8
--> 1.125 0
--> 2.0 2.0

--case: a sprite turns to where it is put, and to where what it follows flies
local s = sprite.put { sprite = 'arrow', x = 10, y = 10, turns = true, dir = 33.75, scale = 2.5, alpha = 4 }
print(s.dir, s.scale, s.alpha)
s.y = 5
wait(1)
print(s.dir)
wait(1)
s.x, s.alpha, s.scale = 3, 7, 0.25
wait(1)
print(s.dir, s.scale, s.alpha)
s.dir = 11.25
wait(2)
print(s.dir)
local b = bullet.fire { kind = 'dot', x = 100, y = 100, speed = 2, dir = 300 }
local t = sprite.put { sprite = 'arrow', follow = b, turns = true }
wait(2)
print(math.abs(t.dir - 300) < 0.01)
b:remove()
wait(1)
print(t.alive, s.alive)
--> 33.75 2.5 4
--> 270.0
--> 180.0 0.25 7
--> 11.25
--> true
--> false true

--case: an option turns to where it flies
string.sys.join(1, 'ship')
local p = player.get(1)
p.x, p.y = 100, 100
wait(20)
p.x = 110
wait(1)
print(bead.dir)
p.y = 80
wait(1)
print(bead.dir)
wait(5)
bead.dir = 45
wait(1)
print(bead.dir)
--> 0.0
--> 270.0
--> 45.0

--case: without `turns` nothing turns by itself
local s = sprite.put { sprite = 'arrow', x = 10, y = 10 }
local e = enemy.spawn { kind = 'post', x = 100, y = 100 }
e:move { x = 100, y = 140, over = 10 }
s.x = 5
wait(3)
print(s.dir, s.scale, s.alpha, e.dir)
--> 0.0 1.0 8 0.0

--case: the shape of an enemy is scaled only with scale_hit
local function hits(kind, distance, scale)
  local e = enemy.spawn { kind = kind, x = 100, y = 100, scale = scale }
  local s = shot.fire { kind = 'bolt', x = 100, y = 100 + distance, speed = 0 }
  wait(2)
  local hit = not s.alive
  s:remove()
  e:remove()
  return hit
end
print(hits('foe', 9, 4), hits('foe', 9.5, 4))
print(hits('post', 9, 1), hits('post', 9.5, 1), hits('post', 33, 4), hits('post', 33.5, 4))
print(hits('post', 3, 0.25), hits('post', 3.5, 0.25), hits('post', 5), hits('post', 5.5))
--> true false
--> true false true false
--> true false true false

--each: what is refused
enemy.spawn { kind = 'foe', x = 1, y = 1, scale = 1.1 }
--! enemy.spawn: scale: expected a number from 0.25 to 4 in steps of 1/8, got 1.1
enemy.spawn { kind = 'foe', x = 1, y = 1, scale = 0.125 }
--! enemy.spawn: scale: expected a number from 0.25 to 4 in steps of 1/8, got 0.125
enemy.spawn { kind = 'foe', x = 1, y = 1, scale = 0 }
--! enemy.spawn: scale: expected a number from 0.25 to 4 in steps of 1/8, got 0
enemy.spawn { kind = 'foe', x = 1, y = 1, scale = 0 / 0 }
--! enemy.spawn: scale: expected a number from 0.25 to 4 in steps of 1/8, got nan
enemy.spawn { kind = 'foe', x = 1, y = 1, alpha = 9 }
--! enemy.spawn: alpha: expected a whole number from 0 to 8 eighths, got 9
enemy.spawn { kind = 'foe', x = 1, y = 1, alpha = 0.5 }
--! enemy.spawn: alpha: expected a whole number from 0 to 8 eighths, got 0.5
enemy.spawn({ kind = 'foe', x = 1, y = 1 }).scale = 4.125
--! enemy: scale: expected a number from 0.25 to 4 in steps of 1/8, got 4.125
enemy.spawn({ kind = 'foe', x = 1, y = 1 }).scale = 'big'
--! enemy: scale: expected a number from 0.25 to 4 in steps of 1/8, got "big"
enemy.spawn({ kind = 'foe', x = 1, y = 1 }).alpha = -1
--! enemy: alpha: expected a whole number from 0 to 8 eighths, got -1
enemy.spawn({ kind = 'foe', x = 1, y = 1 }).dir = nil
--! enemy: dir: expected a number of degrees, got nil
sprite.put { sprite = 'dot', x = 1, y = 1, turns = 1 }
--! sprite.put: turns: expected true or false, got 1
sprite.put { sprite = 'dot', x = 1, y = 1, layer = 'over', alpha = 7 }
--! sprite.put: alpha: sprites in layer "over" cannot blend
sprite.put({ sprite = 'dot', x = 1, y = 1, layer = 'over' }).alpha = 7
--! sprite: alpha: sprites in layer "over" cannot blend
sprite.put({ sprite = 'dot', x = 1, y = 1, alpha = 7 }).layer = 'over'
--! sprite: layer: sprites in layer "over" cannot blend
sprite.plate({ x = 1, y = 1, w = 9, h = 9 }).scale = 2
--! sprite: scale: a plate has no picture

--load: what is refused in declarations
bullet.def('big', { sprite = 'dot', hit = { circle = 3 }, scale = 2.3 })
--! bullet.def: scale: expected a number from 0.25 to 4 in steps of 1/8, got 2.3
bullet.def('big', { sprite = 'dot', hit = { circle = 4100 }, scale = 2, scale_hit = true })
--! bullet.def: hit: the shape reaches 8200 px from its centre, expected at most 8191
enemy.def('big', { sprite = 'dot', hit = { box = { 4100, 4 } }, scale_hit = true })
--! enemy.def: hit: the shape reaches 8200 px from its centre, expected at most 8191
enemy.def('big', { sprite = 'dot', hit = { circle = 3 }, turns = true })
--! enemy.def: turns: sprite "dot" has no rotations (add `rotations` to it in rom.lua)
option.def('bead', { sprite = 'dot', turns = true })
--! option.def: turns: sprite "dot" has no rotations (add `rotations` to it in rom.lua)

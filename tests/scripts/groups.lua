-- Clears, queries, sweeps and groups: their places, and what they do to what dies meanwhile. test_groups.c has the
-- shapes, against whole numbers.
spark.def('glow', { sprite = 'dot', life = 9 })
bullet.def('dot', { sprite = 'dot', hit = 'none', graze = false })
enemy.def('foe', { sprite = 'dot', hit = 'none', hp = 9 })
motion.def { name = 'fine', fine = true, { accel = 0.01, over = 90 } }
local function fire(x, y, tag) return bullet.fire { kind = 'dot', x = x, y = y or 50, speed = 0, tag = tag } end
local function foe(x, tag, on_death)
  return enemy.spawn { kind = 'foe', x = x, y = 50, tag = tag, on_death = on_death }
end

--case: a place can be an entity, and an offset from it; one that is dead clears and finds nothing
local e = foe(50)
for i = 0, 9 do fire(50 + 10 * i, 50, 'r') end
print(bullet.clear { from = e, dx = 90, radius = 5 }, bullet.clear { from = e, dx = 30, w = 20, h = 0 })
print(bullet.group('r'):clear { from = e, to_x = 60, to_y = 50, width = 1 })
print(#query.near { what = 'enemy', from = e, dx = 3, radius = 3 })
print(#query.box { what = 'player', x = 0, y = 0, w = 1000, h = 1000 })
e:remove()
print(bullet.clear { from = e, radius = 500 }, #query.box { what = 'bullet', from = e, w = 1, h = 1 })
print(bullet.clear { tag = 'x' }, bullet.clear())
--> 1 3
--> 2
--> 1
--> 0
--> 0 0
--> 0 4

--case: a clear leaves a spark for each bullet, if it is given a kind
fire(3):clear {}
fire(3):clear { spark = 'glow' }
for i = 1, 7 do fire(9 * i) end
print(board.live 'sparks', bullet.group():clear { spark = 'glow' }, board.live 'sparks')
--> 1 7 8

--case: a shift stops at the edge of the world, and is exact for a fine bullet
local b, f = fire(100, 9), fire(100, 9)
f.motion = 'fine'
b:shift(16383, -16383)
f:shift(1 / 65536 / 4, 0)
print(b.x, b.y, f.x == 100 + 1 / 65536 / 4)
--> 16383.0 -16374.0 true

--case: an enemy that is shifted continues from its new position
local e = foe(50)
e:move { x = 60, y = 50, over = 10 }
wait(5)
enemy.group():shift(100, 7)
print(e.x, e.y)
wait(5)
print(e.x, e.y)
--> 155.0 57.0
--> 160.0 57.0

--case: a group's verb leaves out what spawns meanwhile and what has died
local seen = 0
local function more()
  seen = seen + 1
  foe(9, 'm', more)
end
local a, c = foe(9, 'm', more)
foe(9, 'm', function()
  c:remove()
  more()
end)
c = foe(9, 'm', more)
enemy.group('m'):kill()
print(seen, a.alive, c.alive, enemy.group('m').count)
enemy.group('m'):hurt(9)
print(seen, enemy.group('m').count)
--> 2 false false 2
--> 4 2

--case: a sweep ends with its time, its owner, or what it follows; the dead start none
local e = foe(50)
local a = bullet.sweep { x = 5, y = 5, radius_to = 9, over = 3 }
local b = bullet.sweep { follow = e, radius_to = 9, over = 9 }
local c
task.own(e, function()
  c = bullet.sweep { x = 9, y = 9, radius_to = 9, over = 9 }
  wait(forever)
end)
wait(3)
print(a.alive, b.alive, c.alive)
wait(1)
print(a.alive, b.alive, c.alive)
e:remove()
wait(1)
print(a.alive, b.alive, c.alive)
print(bullet.sweep { from = e, radius_to = 3, over = 1 }.alive)
print(bullet.sweep { follow = e, radius_to = 3, over = 1 }.alive)
--> true true true
--> false true true
--> false false false
--> false
--> false

--case: on_death gets the player whom the death counts for
local function killer(_, p) print(p and p.index) end
foe(9, nil, killer):hurt(9, 2)
foe(9, nil, killer):hurt(9)
--> 2
--> nil

--case: a long list does not change the caller's locals
for n = 1, 200 do
  fire(n)
  local found, k = query.box { what = 'bullet', x = 100, y = 50, w = 800, h = 9 }, n
  assert(#found == n and k == n)
end

--each: arguments
bullet.clear { x = 1, y = 2 }
--! bullet.clear: shape: expected `radius`, or `w` and `h`, or `to_x`, `to_y` and `width`, got only a place
bullet.clear { radius = 2 }
--! bullet.clear: place: expected `x` and `y`, or `from` (a thing), got neither
bullet.clear { x = 1, radius = 2 }
--! bullet.clear: place: expected either `x` and `y`, or `from`
bullet.group():clear { x = 1, y = 2, h = 4 }
--! group:clear: shape: expected both `w` and `h`, got only `h`
bullet.clear { x = 1, y = 2, to_x = 4, to_y = 9 }
--! bullet.clear: shape: expected all of `to_x`, `to_y` and `width`, got no `width`
query.near { what = 'bullet', radius = 3 }
--! query.near: place: expected `x` and `y`, or `from` (a thing), got neither
query.box { what = 'bullet', x = 1, y = 2, w = 3 }
--! query.box: h: expected a number from 0 to 32767 px, got nil
query.line { what = 'bullets', x = 1, y = 2, to_x = 3, to_y = 2, width = 3 }
--! query.line: what: expected bullet, enemy, item, laser, shot or player, got "bullets"
bullet.sweep { x = 1, radius_to = 3, over = 9 }
--! bullet.sweep: place: expected `x` and `y`, or `from` (a thing), or `follow` (a thing)
bullet.group():shift(1)
--! group:shift: dy: expected a number from -16383 to 16383 px, got nil
print(enemy.group('x').hp)
--! enemies: hp cannot be read from a group (only `count` can)
enemy.group('x').speed = 1
--! a group of enemies has no property "speed"
shot.group('x').speeed = 1
--! a group of shots has no property "speeed" (did you mean "speed"?)

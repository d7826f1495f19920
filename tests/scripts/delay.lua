-- Bullets with a delay: what is read and written of them, and that they touch nothing until they start.
bullet.def('orb', { sprite = 'dot', hit = { circle = 4 }, cloud = 'wink' })
bullet.def('bar', { sprite = 'arrow', hit = { box = { 9, 5 } }, bank = 3 })
bullet.def('star', { sprite = 'dot', hit = { circle = 2 }, bank = 5, cloud = 'arrow' })
player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 16, safe = 0 })
on.hit(function() print('hit') end)
on.graze(function() print('graze') end)
local function fire(t)
  t.kind, t.x, t.y, t.speed = t.kind or 'orb', t.x or 50, 60, 2
  return bullet.fire(t)
end

--case: a delayed bullet stands, has no age, and has its speed
local b = fire { dir = 0, delay = 2 }
for _ = 1, 4 do
  print(b.kind, b.delay, b.age, b.x, b.vx, b.speed)
  wait(1)
end
--> orb 2 0 50.0 2.0 2.0
--> orb 1 0 50.0 2.0 2.0
--> orb 0 0 50.0 2.0 2.0
--> orb 0 1 52.0 2.0 2.0

--case: its kind and velocity can be written, and it can be cleared
local b = fire { kind = 'bar', delay = 10 }
b.kind = 'star'
b.vx, b.vy = 3, 4
print(b.kind, b.bank, b.speed, b.x)
local c = fire { x = 90, delay = 10 }
print(bullet.clear { x = 90, y = 60, radius = 1 }, c.alive, b.alive)
wait(15)
print(b.kind, b.age)
--> star 5 5.0 50.0
--> 1 false true
--> star 5

--case: the frame in which it starts is the first that touches
string.sys.join(1, 'ship')
bullet.fire { kind = 'orb', from = player.get(1), speed = 0, delay = 50 }
bullet.fire { kind = 'bar', from = player.get(1), speed = 3, dx = 12, delay = 50 }
wait(48)
for frame = 48, 51 do
  print(frame)
  wait(1)
end
--> 48
--> 49
--> 50
--> hit
--> graze
--> 51
--> hit

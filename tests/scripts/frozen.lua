-- What is frozen: what scripts see of it, its tasks, and what it hits. test_frozen.c shows that it goes on as it was.
--board: freeze
bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })
shot.def('bolt', { sprite = 'dot', hit = { circle = 3 } })
enemy.def('foe', { sprite = 'dot', hit = { circle = 8 }, hp = 9, touch = false })
player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 20, safe = 0 })
on.hit(function(p)
  print 'hit'
  p.safe = 5
end)
on.graze(function() print 'graze' end)
local function fire(x, y, speed) return bullet.fire { kind = 'dot', x = x, y = y, dir = 0, speed = speed } end
local function ship()
  string.sys.join(1, 'ship')
  local p = player.get(1)
  p.x, p.y = 100, 200
end

--case: it keeps its place, its velocity and its age; it can be written, and unfrozen
local b = fire(20, 20, 2)
local function show() print(b.frozen, b.x, b.vx, b.age) end
wait(1)
b.frozen = 3
show()
wait(2)
show()
wait(1)
show()
wait(1)
show()
bullet.group().frozen = forever
wait(20)
b.vx = 3
wait(1)
print(b.frozen == forever, b.x, b.age)
b.frozen = 0
wait(1)
show()
--> 3 22.0 2.0 1
--> 1 22.0 2.0 1
--> 0 22.0 2.0 1
--> 0 24.0 2.0 2
--> true 24.0 2
--> 0 27.0 3.0 3

--case: frozen and unfrozen in one frame it moves; another bullet in its slot does too
local b = fire(20, 20, 2)
b.frozen = 9
b.frozen = 0
wait(2)
print(b.x)
b.frozen = 50
b:remove()
b = fire(20, 20, 2)
wait(2)
print(b.x, b.frozen)
--> 24.0
--> 24.0 0

--case: its tasks wait, and the tasks of these; they end with it
local n = 0
local function count(by)
  return function()
    while true do
      n = n + by
      wait(1)
    end
  end
end
local b = fire(20, 20, 0)
local e = enemy.spawn { kind = 'foe', x = 20, y = 20, run = count(1) }
local t = task.own(b, count(100))
task.own(t, count(10000))
wait(5)
n = 0
b.frozen, e.frozen = 7, 7
wait(8)
print(n)
wait(1)
print(n)
e.frozen, b.frozen = forever, forever
e:remove()
b:remove()
wait(2)
print(t.alive)
--> 10101
--> 20202
--> false

--each: a bullet hits and grazes where it is, and not on its way
ship()
fire(100, 200, 30).frozen = 9
wait(1)
--> hit

ship()
fire(160, 200, 100).frozen = 3
fire(115, 200, 3).frozen = 9
wait(3)
--> graze

--case: a shot that is frozen hits an enemy that it is in, and another one once it moves
local e = enemy.spawn { kind = 'foe', x = 50, y = 50 }
local function shoot(y)
  local s = shot.fire { kind = 'bolt', x = 50, y = y, speed = 40 }
  s.frozen = 5
  for _, frames in ipairs { 3, 4 } do
    wait(frames)
    print(e.hp, s.alive)
  end
end
shoot(56)
shoot(90)
--> 8 false
--> 8 false
--> 8 true
--> 7 false

--each: arguments
bullet.group().frozen = -1
--! group: frozen: expected forever or a whole number from 0 to 2147483647 frames, got -1

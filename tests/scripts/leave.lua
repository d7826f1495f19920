-- What leaves the field and touches something in the same frame; on.graze runs before on.hit.
--board: margin=0
bullet.def('ball', { sprite = 'dot', hit = { circle = 4 } })
bullet.def('air', { sprite = 'dot', hit = 'none' })
shot.def('bolt', { sprite = 'dot', hit = { circle = 4 }, damage = 2 })
enemy.def('foe', { sprite = 'dot', hit = { circle = 4 }, hp = 2 })
player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 16, lives = 9, safe = 1 })
string.sys.join(1, 'ship')
local p = player.get(1)
p.x, p.y, p.safe = 120, 312, 0
local on_graze, on_hit
on.graze(function()
  print 'graze'
  if on_graze then on_graze() end
end)
on.hit(function(_, t)
  print 'hit'
  p.safe = 9
  if on_hit then on_hit(t) end
end)
on.kill(function() print('kill', board.live 'shots') end)
on.leave(function(e) print('leave', e.alive, e.hp) end)
local function dive(x) return bullet.fire { kind = 'ball', x = x, y = 300, speed = 90 } end
local function slot_of_new_bullet()
  return bullet.fire { kind = 'air', x = 9, y = 9, speed = 0 } & 0xffffff
end

--case: a bullet that hits can be read, but is not alive and not counted; its slot is free in the next frame
local b = dive(120)
on_hit = function(t)
  t.x = 5
  print(t.alive, t.x, t.y, bullet.group().count, t == b)
  print(slot_of_new_bullet(), slot_of_new_bullet())
end
wait(1)
print(b.alive, b.x, slot_of_new_bullet())
--> hit
--> false 120.0 390.0 0 true
--> 1 2
--> false nil 0

--case: a bullet hits the second player on its way out, who plays alone
local q = player.get(2)
string.sys.join(2, 'ship')
string.sys.leave(1)
q.x, q.y, q.safe = 120, 312, 0
dive(120)
wait(1)
print(bullet.group().count)
--> hit
--> 0

--each: handlers that remove bullets do not find those that leave, which hit all the same
dive(130)
dive(120)
on_graze = function()
  bullet.each('x', print)
  print(bullet.clear { x = 9, y = 9, radius = 20 })
end
wait(1)
--> graze
--> 0
--> hit

dive(130)
dive(120)
on_graze = function() print(bullet.clear()) end
wait(1)
--> graze
--> 0

--each: what a handler removes does not hit
dive(130)
local b = dive(120)
on_graze = function()
  b:remove()
  print(b.x)
end
wait(1)
--> graze
--> nil

dive(130)
local e = enemy.spawn { kind = 'foe', x = 120, y = 300 }
e:move { x = 120, y = 390, over = 1 }
on_graze = function() e:remove() end
wait(1)
--> graze

--case: an enemy that is killed on its way out does not leave
for i = 1, 2 do
  enemy.spawn { kind = 'foe', x = 20, y = 9, hp = 2 * i }:move { x = 20, y = -90, over = 1 }
  shot.fire { kind = 'bolt', x = 20, y = -2, speed = 0 }
  wait(1)
end
--> kill 0
--> leave false 2

--case: a shot hits on its way out
enemy.spawn { kind = 'foe', x = 20, y = 9 }
shot.fire { kind = 'bolt', x = 20, y = 60, speed = 100 }
shot.fire { kind = 'bolt', x = 99, y = 60, speed = 100 }
wait(1)
--> kill 0

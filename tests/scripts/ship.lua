-- What the guide says about places, grazes, hits and shots.
bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })
shot.def('bolt', { sprite = 'dot', hit = { circle = 3 } })
enemy.def('wall', { sprite = 'dot', hit = { circle = 9 }, hp = 9 })
player.def('ship', { sprite = 'dot', hit = { circle = 2 }, safe = 0 })
string.sys.join(1, 'ship')
local p = player.get(1)
local saves = false
on.hit(function()
    print 'hit'
    p.safe = saves and 9 or 0
end)
on.death(function() print 'death' end)
local function aim_at_ship() return bullet.fire { kind = 'dot', from = p, speed = 0 } end
local function shoot() return shot.fire { kind = 'bolt', x = 50, y = 50, speed = 0 } end

--case: a ship stays in the field
p.x = -50
print(p.x)
wait(1)
print(p.x)
p.y = 9999
wait(1)
print(p.y == rom.field.h - 8)
--> -50.0
--> 8.0
--> true

--case: a bullet that touches the ship does not graze it, one next to it does
p.safe = 60
local b = aim_at_ship()
wait(3)
print(p.grazes, b.alive)
b.x = p.x + 12
wait(3)
print(p.grazes)
--> 0 true
--> 1

--each: of the hits of a frame only the first is reported
for i = 1, 3 do aim_at_ship() end
wait(1)
--> hit
--> death
saves = true
for i = 1, 3 do aim_at_ship() end
wait(1)
--> hit

--each: one enemy uses a shot up, unless another shot destroyed it
enemy.spawn({ kind = 'wall', x = 50, y = 50 }).safe = forever
local s = shoot()
wait(1)
print(s.alive, enemy.count())
--> false 1
enemy.spawn { kind = 'wall', x = 50, y = 50, hp = 1 }
local a, b = shoot(), shoot()
wait(1)
print(a.alive, b.alive, enemy.count())
--> false true 0

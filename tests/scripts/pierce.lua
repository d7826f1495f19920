-- Shots that go through what they hit: how often each hits, in which frames, and when it is used up.
--board: pierce hp
enemy.def('foe', { sprite = 'dot', hit = { circle = 4 }, hp = 9, touch = false })
bullet.def('nut', { sprite = 'dot', hit = { circle = 4 }, hp = 9 })
bullet.def('wall', { sprite = 'dot', hit = { circle = 4 }, hp = forever })
bullet.def('dot', { sprite = 'dot', hit = { circle = 4 } })
shot.def('one', { sprite = 'dot', hit = { circle = 2 }, pierce = 1 })
shot.def('all', { sprite = 'dot', hit = { circle = 2 }, pierce = forever, every = 10 })
shot.def('once', { sprite = 'dot', hit = { circle = 2 }, pierce = forever, every = forever })
shot.def('broom', { sprite = 'dot', hit = { circle = 2 }, pierce = 2, cancels = true })
local function foe(y) return enemy.spawn { kind = 'foe', x = 50, y = y } end
local function fire(kind, y) return bullet.fire { kind = kind, x = 50, y = y, speed = 0 } end
local function shoot(kind, speed) return shot.fire { kind = kind, x = 50, y = 200, speed = speed, dir = 270 } end

--each: a shot goes through one and is used up by the next
local a, b, c = foe(180), foe(160), foe(140) -- in one frame
local s = shoot('one', 100)
wait(2)
print(a.hp, b.hp, c.hp, s.alive)
--> 8 8 9 false

local a, b = foe(180), foe(160) -- in two
local s = shoot('one', 21)
wait(4)
print(a.hp, b.hp, s.alive)
--> 8 8 false

local a, b = foe(180), foe(160)
a.safe = 9 -- counts as hit all the same
local s = shoot('one', 60)
wait(2)
print(a.hp, b.hp, s.alive)
--> 9 8 false

--each: it hits again after `every` frames, the first time at once
local a = foe(200)
shoot('all', 0)
wait(10)
print(a.hp)
wait(1)
print(a.hp)
wait(10)
print(a.hp)
--> 8
--> 7
--> 6

local a = foe(200)
local s = shoot('one', 0)
wait(6) -- what is usual
print(a.hp, s.alive)
wait(1)
print(a.hp, s.alive)
--> 8 true
--> 7 false

local a = foe(200)
local s = shoot('once', 0)
wait(40)
print(a.hp, s.alive)
--> 8 true

--case: a new enemy in the slot of one that died is hit at once
local a = foe(200)
a.hp = 1
shoot('once', 0)
wait(2)
print(a.alive)
local b = foe(200)
wait(1)
print(b.hp)
--> false
--> 8

--case: at most eight targets are remembered, and a ninth is hit when one has died
local all = {}
for i = 1, 9 do all[i] = foe(200) end
shoot('all', 0)
wait(1)
print(all[8].hp, all[9].hp)
wait(10)
print(all[8].hp, all[9].hp)
all[1]:kill()
wait(2)
print(all[9].hp)
--> 8 9
--> 7 9
--> 8

--each: bullets
local a, b, c = fire('nut', 180), foe(160), fire('nut', 140)
local s = shoot('all', 100)
wait(2)
print(a.hp, b.hp, c.hp, s.alive)
--> 8 8 8 true

local a, b = fire('wall', 180), foe(160)
local s = shoot('all', 100)
wait(2)
print(b.hp, s.alive)
--> 9 false

local a = {}
for i = 1, 5 do a[i] = fire('dot', 200 - 10 * i) end
local s = shoot('broom', 100)
wait(2)
print(bullet.group().count, a[3].alive, a[4].alive, s.alive)
--> 2 false true false

local a = fire('dot', 180)
local s = shoot('all', 100)
wait(2)
print(a.alive, s.alive)
--> true true

--load: arguments
shot.def('bolt', { sprite = 'dot', hit = { circle = 2 }, every = 3 })
--! shot.def: every: requires `pierce`
shot.def('bolt', { sprite = 'dot', hit = { circle = 2 }, pierce = -1 })
--! shot.def: pierce: expected forever or a whole number from 0 to 1000000, got -1

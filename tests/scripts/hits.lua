-- What touches what, and what comes of it. test_hits.c compares all shapes with a reference; here are the kinds that
-- scripts declare, and the events in their order.
bullet.def('ball', { sprite = 'dot', hit = { circle = 4 } })
bullet.def('meek', { sprite = 'dot', hit = { circle = 4 }, graze = false })
bullet.def('late', { sprite = 'dot', hit = { circle = 4 }, swept = false })
bullet.def('bar', { sprite = 'dot', hit = { box = { 20, 4 } } })
bullet.def('pin', { sprite = 'dot', hit = { capsule = { 40, 3 } } })
bullet.def('ring', { sprite = 'dot', hit = { circles = { { -10, 0, 1 }, { 10, 0, 1 } } } })
bullet.def('fan', { sprite = 'dot', hit = { circles = { { 10, 0, 1 }, { 0, 5, 1 } } }, turns = true })
bullet.def('air', { sprite = 'dot', hit = 'none' })
shot.def('bolt', { sprite = 'dot', hit = { box = { 4, 8 } }, damage = 3 })
shot.def('slow', { sprite = 'dot', hit = { box = { 4, 8 } }, swept = false })
enemy.def('foe', { sprite = 'dot', hit = { box = { 10, 10 } }, hp = 1 })
enemy.def('late', { sprite = 'dot', hit = { circle = 5 }, swept = false })
enemy.def('eyes', { sprite = 'dot', hit = { circles = { { -20, 0, 5 }, { 20, 0, 5 } } } })
enemy.def('rod', { sprite = 'dot', hit = { capsule = { 40, 2, 0 } } })
enemy.def('gate', { sprite = 'dot', hit = { box = { 20, 4 } }, touch = false, blocks = true })
player.def('ship', { sprite = 'dot', hit = { circle = 2 }, graze = 16, speed = 4, lives = 9, safe = 1 })
string.sys.join(1, 'ship')
string.sys.join(2, 'ship')
local p, q = player.get(1), player.get(2)
p.x, p.y, q.x, q.y = 60, 200, 180, 200
on.graze(function(who) print('graze', who.index) end)
on.kill(function(_, who) print('kill', who and who.index) end)
on.hit(function(who)
  print('hit', who.index)
  who.safe = 2
end)
local ulp = 1 / 65536

-- Vulnerable from here on, for a frame; says what is left of it.
local function fire(kind, x, y, speed, dir)
  p.safe, q.safe = 0, 0
  return bullet.fire { kind = kind, x = x, y = y, speed = speed or 0, dir = dir }
end
local function foe(kind, x, y, hp)
  p.safe, q.safe = 0, 0
  return enemy.spawn { kind = kind, x = x, y = y, hp = hp }
end
local function shoot(kind, x, y, speed, dir)
  return shot.fire { kind = kind, x = x, y = y, speed = speed or 0, dir = dir or 270 }
end
local function next_scene(name)
  wait(1)
  if name then print(name) end
  bullet.group():remove()
  shot.group():clear()
  enemy.group():remove()
end

--case: a bullet hits on its way, if it is not of a kind that only hits where it is
fire('ball', 60, 170, 60)
next_scene 'swept'
fire('late', 60, 170, 60)
next_scene 'not swept'
fire('late', 60, 170, 30)
next_scene 'not swept, but there'
local b = fire('ball', 60, 100)
b.y = 300
next_scene 'a bullet that a script moves'
fire('ball', 60, 150)
p.y = 100
next_scene()
p.y = 200
next_scene 'a player that a script moves'
--> hit 1
--> swept
--> not swept
--> hit 1
--> not swept, but there
--> a bullet that a script moves
--> a player that a script moves

--case: an enemy hits on its way too
foe('foe', 60, 160):move { x = 60, y = 240, over = 1 }
next_scene 'swept'
foe('late', 60, 160):move { x = 60, y = 240, over = 1 }
next_scene 'not swept'
foe('foe', 60, 160).y = 240
next_scene 'an enemy that a script moves'
foe('foe', 67, 200)
next_scene 'its edge'
--> hit 1
--> swept
--> not swept
--> an enemy that a script moves
--> hit 1
--> its edge

--case: a shot hits on its way too
foe('foe', 100, 70)
shoot('bolt', 100, 100, 60)
next_scene 'swept'
foe('foe', 100, 70)
shoot('slow', 100, 100, 60)
next_scene 'not swept'
--> kill nil
--> swept
--> not swept

--case: a box reaches to its edge, a capsule lies along `dir`
fire('bar', 72, 200)
next_scene 'box'
fire('bar', 72 + ulp, 200)
next_scene 'box, a little further'
fire('pin', 60, 175)
next_scene 'capsule along'
fire('pin', 60, 185, 0, 0)
next_scene 'capsule across'
foe('rod', 60 - 20, 200)
next_scene 'capsule of an enemy'
--> hit 1
--> box
--> graze 1
--> box, a little further
--> hit 1
--> capsule along
--> graze 1
--> capsule across
--> hit 1
--> capsule of an enemy

--case: several circles turn with `dir` if the kind `turns`
fire('ring', 60, 200 - 13, 0, 90)
next_scene 'kept upright: above it'
fire('fan', 60, 200 - 13, 0, 90)
next_scene 'turned: above it'
foe('eyes', 60 - 24, 200)
next_scene 'an enemy, its circle'
foe('eyes', 60, 200)
next_scene 'an enemy, between its circles'
--> graze 1
--> kept upright: above it
--> hit 1
--> turned: above it
--> hit 1
--> an enemy, its circle
--> an enemy, between its circles

--case: a shot hits the enemy that it comes to first, and of those as near the one with the lowest slot
local a, b, c = foe('foe', 100, 50, 9), foe('foe', 100, 90, 9), foe('foe', 100, 50, 9)
shoot('bolt', 100, 110, 70)
wait(1)
print(a.hp, b.hp, c.hp)
b:remove()
shoot('bolt', 100, 110, 70)
wait(1)
print(a.hp, c.hp)
--> 9 6 9
--> 6 9

--case: a shot is used up by its hit, and one that finds its enemy dead goes on
local e = foe('foe', 100, 50, 6)
for _ = 1, 3 do shoot('bolt', 100, 50).tag = 't' end
wait(1)
print(e.alive, board.live 'shots')
next_scene 'a safe enemy uses it up too'
e = foe('foe', 100, 50, 4)
e.safe = 2
shoot('bolt', 100, 50)
wait(1)
print(e.hp, board.live 'shots')
next_scene 'the player who fired it'
foe('foe', 100, 50)
shot.fire { kind = 'bolt', x = 100, y = 50, speed = 0, by = q }
wait(1)
--> kill nil
--> false 1
--> a safe enemy uses it up too
--> 4 0
--> the player who fired it
--> kill 2

--case: a gate takes bullets that come into it, however fast; but they hit players first
local function blocked(gate, kind, x, y, speed)
  foe(gate, 60, 150)
  local b = fire(kind, x, y, speed)
  wait(1)
  print(b.alive)
  next_scene()
end
blocked('gate', 'ball', 60, 100, 60)
blocked('gate', 'ball', 75, 100, 60)
blocked('foe', 'ball', 60, 140, 0)
blocked('gate', 'air', 60, 150, 0)
blocked('gate', 'ball', 60, 100, 100)
--> false
--> true
--> graze 1
--> true
--> true
--> hit 1
--> false

--case: a gate that is shot in the same frame takes no bullets
foe('gate', 100, 150, 1)
local b = fire('ball', 100, 150)
shoot('bolt', 100, 150)
wait(1)
print(b.alive)
--> kill nil
--> true

--case: a bullet grazes each player once; not one of a kind without graze, nor one that hits
fire('ball', 80, 200)
wait(5)
next_scene 'once'
fire('ball', 80 + ulp, 200)
next_scene 'out of reach'
fire('ball', 70, 190, 6, 0)
wait(20)
next_scene 'both'
fire('meek', 75, 200)
next_scene 'without graze'
fire('air', 60, 200)
next_scene 'without a shape'
--> graze 1
--> once
--> out of reach
--> graze 1
--> graze 2
--> both
--> without graze
--> without a shape

--case: players in their order, their bullets by slots; a safe player is not hit
fire('ball', 180, 200)
fire('ball', 60, 215)
fire('ball', 60, 200)
fire('ball', 60, 200)
next_scene 'safe'
local b = fire('ball', 60, 200)
p.safe = 3
wait(3)
--> graze 1
--> hit 1
--> hit 2
--> safe

--load: the argument `hit`
bullet.def('a', { sprite = 'dot', hit = { capsule = { 4, 4, 90 } } })
--! bullet.def: hit.capsule: expected { length, radius }, got a third value (a bullet's capsule lies along its `dir`)
bullet.def('a', { sprite = 'dot', hit = { capsule = { 4 } } })
--! bullet.def: hit.capsule radius: expected a number from 0 to 8191 px, got nil
bullet.def('a', { sprite = 'dot', hit = { capsule = { 8000, 4192 } } })
--! bullet.def: hit: the shape reaches 8192 px from its centre, expected at most 8191
bullet.def('a', { sprite = 'dot', hit = { capsule = { 8000, 4191 } } })
print 'at most'
--> at most
bullet.def('a', { sprite = 'dot', hit = { circles = {} } })
--! bullet.def: hit.circles: expected a list of 1 to 4 circles { x, y, r }
enemy.def('a', { sprite = 'dot', hit = { circles = { { 1, 2 } } } })
--! enemy.def: hit.circles r: expected a number from 0 to 8191 px, got nil
enemy.def('a', { sprite = 'dot', hit = { circles = { { 8000, -100, 100 } } } })
--! enemy.def: hit: the shape reaches 8200 px from its centre, expected at most 8191
player.def('a', { sprite = 'dot', hit = { box = { 4, 4 } } })
--! player.def: hit: expected { circle = r } or { sprite = name }, got a table with key "box"
player.def('a', { sprite = 'dot', hit = 'none' })
--! player.def: hit: expected { circle = r } or { sprite = name }, got "none"
player.def('a', { sprite = 'dot', hit = { circle = 4, box = { 1, 1 } } })
--! player.def: hit: expected { circle = r } or { sprite = name }, got a table with key "box"
player.def('a', { sprite = 'dot', hit = { crcle = 4 } })
--! player.def: hit: expected { circle = r } or { sprite = name }, got a table with key "crcle"
player.def('a', { sprite = 'dot', hit = {} })
--! player.def: hit: expected { circle = r } or { sprite = name }, got an empty table
player.def('a', { sprite = 'dot', hit = 'nine' })
--! player.def: hit: expected { circle = r } or { sprite = name }, got "nine"

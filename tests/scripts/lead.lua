-- Steps that lead a bullet along a curve, and bounces. test_lead.c compares where they lead with formulas.
--board: orbit bullet_values=3
bullet.def('dot', { sprite = 'dot', hit = { circle = 3 } })
bullet.def('red', { sprite = 'dot', hit = 'none', bank = 9 })
enemy.def('foe', { sprite = 'wink', hit = { box = { 9, 9 } }, hp = 50 })
value.def 'tx'
value.def 'ty'
local function dot(t)
  t.kind, t.x, t.y, t.dir, t.speed = 'dot', t.x or 10, t.y or 10, t.dir or 0, t.speed or 1
  t.motion = motion.def(t.motion)
  return bullet.fire(t)
end
local function near(a, b) return math.abs(a - b) < 1e-4 end
local function distance(b, x, y) return math.sqrt((b.x - x) * (b.x - x) + (b.y - y) * (b.y - y)) end

--case: go_to: at a speed, or to values, which are read when it starts; the next step follows
local a = dot { motion = { { go_to = { 40, 50 }, speed = 5 }, { speed = 0 } } }
local b = dot { tx = 90, ty = 70, motion = { { go_to = { 'tx', 'ty' }, over = 20, ease = 'out' },
  { dir = 0, speed = 2 } } }
wait(9)
print(a.x < 40)
b.tx = 5
wait(1)
print(a.x, a.y, a.speed)
wait(1)
print(a.x, a.y, a.speed)
wait(9)
print(b.x, b.y)
wait(1)
print(b.x, b.y)
--> true
--> 40.0 50.0 5.0
--> 40.0 50.0 0.0
--> 90.0 70.0
--> 92.0 70.0

--case: orbit: round an enemy that moves, and on as it flew when that dies
local e = enemy.spawn { kind = 'foe', x = 100, y = 60 }
e:move { x = 140, y = 90, over = 40 }
local b = dot { x = 100, y = 60, dir = 30, around = e, motion = { { orbit = 0, radius_to = 40, spin = 6, over = 20 },
  { orbit = 40, spin = 6, over = forever }, { speed = 9 } } }
print(b.around == e)
for k = 1, 30 do
  wait(1)
  local r, a = k <= 20 and 2 * k or 40, 30 + 6 * k
  assert(near(b.x, e.x + r * angle.cos(a)) and near(b.y, e.y + r * angle.sin(a)))
end
e:remove()
local dir = b.dir
wait(1)
print(b.speed, b.dir == dir)
--> true
--> 9.0 true

--case: orbit: round bullets of lower and higher slots it is a frame behind
local lead, last = {}, {}
for i = 1, 200 do lead[i] = dot { x = 60, y = 60 + i / 4, motion = { { wait = forever } } } end
for i = 1, 50 do
  local other = lead[4 * i]
  last[other] = dot { x = 60, y = 60, around = other, motion = { { orbit = 10, spin = 0, over = forever } } }
end
wait(5)
for a, b in pairs(last) do assert(near(distance(b, a.x - 1, a.y), 10)) end

--case: orbit: without anything to go round it is over; `around` can be written
local b = dot { x = 50, y = 50, tag = 't', motion = { { orbit = 9, over = 5 }, { speed = 2 } } }
local e = enemy.spawn { kind = 'foe', x = 100, y = 60 }
wait(1)
print(b.x, b.motion)
bullet.group('t').around = e
b.motion = motion.def { { orbit = 9, over = 5 } }
wait(1)
print(b.around == e, near(distance(b, 100, 60), 9))
b.around = nil
local x, vx = b.x, b.vx
wait(1)
print(b.around, b.x == x + vx)
--> 52.0 nil
--> true true
--> nil true

--case: a write to place, direction or speed ends the lead, until the next step
local m = { { go_to = { 90, 10 }, over = 8 }, { dir = 90 } }
local a, b = dot { motion = m }, dot { motion = m }
local c = dot { dir = 90, motion = { { wave = 20, every = 8, over = 8 } } }
wait(2)
a.dir = 180
b.x = 100
c.x = 50
print(c.dir, c.speed)
wait(1)
print(a.x, b.x, c.x, c.y)
wait(6)
print(a.dir, b.dir, c.x, c.y)
--> 90.0 1.0
--> 20.0 110.0 50.0 13.0
--> 90.0 90.0 50.0 19.0

--case: bounce: the steps in it run after each bounce, and take their time
local a = dot { x = 5, y = 50, dir = 180, speed = 2, motion = { { bounce = 1, walls = 'left right',
  { bank = 7 }, { wait = 2 }, { kind = 'red' } }, { dir = 90 } } }
wait(2)
for _ = 1, 5 do
  print(a.x, a.y, a.dir, a.kind, a.bank)
  wait(1)
end
--> 1.0 50.0 180.0 dot 0
--> 1.0 50.0 0.0 dot 0
--> 3.0 50.0 0.0 dot 7
--> 5.0 50.0 0.0 dot 7
--> 5.0 52.0 90.0 red 9

--case: bounce: not at other walls; `over` ends it; a corner is one bounce
local a = dot { x = 5, y = 50, dir = 180, speed = 2, motion = { { bounce = 9, walls = 'top', over = 6 },
  { speed = 1 } } }
local b = dot { x = 3, y = 3, dir = 225, speed = 2, motion = { { bounce = 1 }, { speed = 1 } } }
local c = dot { x = 1, y = 50, dir = 180, speed = 2, motion = {
  { loop = 2, { bounce = 1, walls = 'left' }, { dir = 180 } }, { speed = 0 } } }
wait(3)
print(a.x, b.x > 0, b.y == b.x, b.dir)
wait(3)
print(a.x, a.speed, b.speed, c.speed)
wait(1)
print(a.x, b.speed)
--> -1.0 true true 45.0
--> -7.0 2.0 1.0 0.0
--> -8.0 1.0

--case: bounce: a script that turns it in the frame of its bounce
local a = dot { x = 1, y = 50, dir = 180, speed = 2, motion = { { bounce = 3 } } }
wait(1)
print(a.x)
a.dir = 90
wait(2)
print(a.x, a.y)
--> 1.0
--> 1.0 54.0

--each: arguments
motion.def { { go_to = { 1, 2 } } }
--! motion.def: step 1: `go_to` requires either `over` (frames) or `speed`
motion.def { { go_to = { 1, 2 }, speed = 2, ease = 'in' } }
--! motion.def: step 1: go_to: `ease` requires `over` (with `speed`, the motion is linear)
motion.def { { go_to = { 1, 2 }, speed = 0 } }
--! motion.def: step 1: go_to: speed: expected a number above 0
motion.def { { go_to = { 1, 2 }, over = forever } }
--! motion.def: step 1: `go_to` with `over = forever` never arrives
motion.def { { go_to = { 1, 99999 }, over = 3 } }
--! motion.def: step 1: go_to: expected a number from -16383 to 16383 px, got 99999
motion.def { { go_to = { 'tx', 'quick' }, over = 3 } }
--! motion.def: step 1: go_to: expected a number or the name of a value (value.def), got "quick"
motion.def { { go_to = { 1, 2 }, over = 3, turn = 5 } }
--! motion.def: step 1: `turn` cannot be combined with `go_to`
motion.def { { wave = 1, over = 4 } }
--! motion.def: step 1: `wave` requires `every`
motion.def { { turn = 1, spin = 3 } }
--! motion.def: step 1: `spin` requires `go_to`, `polar`, `wave` or `orbit`
motion.def { { loop = 2, { wait = 1 }, spin = 3 } }
--! motion.def: step 1: `spin` cannot be combined with `loop`
motion.def { { bounce = 0 } }
--! motion.def: step 1: bounce: expected forever or a whole number from 1 to 65534 times, got 0
motion.def { { bounce = 2, walls = 'up' } }
--! motion.def: step 1: walls: expected one or more of "left right top bottom", got "up"
motion.def { { bounce = 2, turn = 1 } }
--! motion.def: step 1: `turn` cannot be combined with `bounce`
motion.def { { turn = 2, walls = 'left' } }
--! motion.def: step 1: `walls` requires `bounce`
motion.def { { bounce = 2, { loop = 2, { bounce = 1 } } } }
--! motion.def: step 1: `bounce` cannot be nested in `bounce`
motion.def { fine = true, { bounce = 2 } }
--! motion.def: step 1: `bounce` cannot be used in a fine motion (this step is always exact)

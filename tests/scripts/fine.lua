-- Fine motion: speeds and places to 1/4294967296 px. test_fine.c compares it with formulas.
bullet.def('dot', { sprite = 'dot', hit = 'none' })
local fine, plain = motion.def { fine = true }, motion.def { { wait = 9 } }
local step <const> = 1 / 4294967296
local function fire(speed, m)
  return bullet.fire { kind = 'dot', x = 50, y = 60, dir = 0, speed = speed, motion = m or fine }
end

--case: a fine program is another one than the same that is not
print(fine == motion.def { fine = true }, motion.def { fine = true, { wait = 9 } } == plain)
--> true false

--case: speeds and places below a unit of ordinary bullets
local b = fire(3 * step)
print(b.speed == 3 * step, b.vx == 3 * step, b.vy, b.x)
wait(100)
print(b.x == 50 + 300 * step, b.y, b.motion == fine)
b.speed = 5 * step
wait(2)
print(b.x == 50 + 310 * step)
b.dir = 90
wait(1)
print(b.x == 50 + 310 * step, b.y == 60 + 5 * step)
b.x, b.y = 70, 80 + 7 * step
print(b.x, b.y == 80 + 7 * step)
wait(1)
print(b.x, b.y == 80 + 12 * step)
--> true true 0.0 50.0
--> true 60.0 true
--> true
--> true true
--> 70.0 true
--> 70.0 true

--case: an acceleration below a unit
local c = fire(0, motion.def { fine = true, { accel = 3 * step, over = 10 } })
wait(20)
print(c.speed == 30 * step, c.x == 50 + (3 * 55 + 30 * 10) * step)
--> true true

--case: a component that is written leaves the other as it was
local b = fire(0.1)
for _ = 1, 300 do
  b.vy = b.vy + 0.001
  wait(1)
end
print(math.abs(b.vx - 0.1) < 1e-7, math.abs(b.x - 80) < 1e-5)
--> true true

--case: to another fine program with the speed as it is, to none or a plain one with the nearest
local b = fire(5 * step)
wait(1)
b.motion = fine
print(b.speed == 5 * step)
b.motion = nil
print(b.speed, b.vx, b.x)
b.speed = 1.5
b.motion = fine
wait(1)
print(b.speed, b.x)
b.motion = plain
wait(1)
print(b.vx, b.x)
--> true
--> 0.0 0.0 50.0
--> 1.5 51.5
--> 1.5 53.0

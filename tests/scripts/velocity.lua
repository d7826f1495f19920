-- Velocities by axis: the steps ax, ay, vx and vy, vx and vy of what is fired, and turn_to. test_lead.c compares where
-- accelerating steps lead with formulas.
--board: lasers=8 bullet_values=2
bullet.def('dot', { sprite = 'dot', hit = 'none' })
shot.def('shot', { sprite = 'dot', hit = 'none' })
laser.def('bolt', { strip = 'dot', width = 4, hit = 'none' })
value.def 'a'
value.def 'b'
-- Prints where a bullet is after each frame: it starts at (100, 100) and flies to the right by 2 px a frame.
local function fly(frames, program, t)
  t = t or {}
  t.kind, t.x, t.y, t.dir, t.speed, t.motion = 'dot', 100, 100, 0, 2, motion.def(program)
  local b, places = bullet.fire(t), {}
  for i = 1, frames do
    wait(1)
    places[i] = ('%g %g'):format(b.x, b.y)
  end
  print(table.concat(places, ', '))
  return b
end
local function show(b) print(('%g %g, %g at %g'):format(b.vx, b.vy, b.speed, b.dir)) end

--each: acceleration on the axes
show(fly(4, { { ay = 1, over = 3 } }))
--> 102 101, 104 103, 106 106, 108 109
--> 2 3, 3.60555 at 56.3099
fly(5, { { ax = -1, ay = 0.5, over = forever } })
--> 101 100.5, 101 101.5, 100 103, 98 105, 95 107.5
fly(5, { { ay = 1, limit = 2, over = forever } })
--> 102 101, 104 103, 106 105, 108 107, 110 109
fly(4, { { ax = -2, limit = 3, over = forever } })
--> 100 100, 98 100, 95 100, 92 100
fly(4, { { ax = 0.5, ay = 1, limit = { 3, 'a' }, over = forever } }, { a = 1.5 })
--> 102.5 101, 105.5 102.5, 108.5 104, 111.5 105.5
fly(4, { { ax = 1, ay = 1, limit = 1, over = 2 } }) -- faster than the limit already: stays so
--> 102 101, 104 102, 106 103, 108 104
fly(3, { { ax = 1, ay = -1 }, { wait = 1 }, { ax = 1 } })
--> 103 99, 107 98, 111 97
fly(3, { { ax = 'a', ay = 'b', over = 9 } }, { a = 1, b = 2 })
--> 103 102, 107 106, 112 112

--each: velocities to reach
show(fly(4, { { vx = 0, vy = 4, over = 4 } }))
--> 101.5 101, 102.5 103, 103 106, 103 110
--> 0 4, 4 at 90
fly(3, { { vy = 3 } })
--> 102 103, 104 106, 106 109
fly(3, { { vx = -1, vy = 0.5, kind = 'dot' }, { wait = 1 }, { vx = 0, over = 1 } })
--> 99 100.5, 99 101, 99 101.5

--case: writing the velocity or the position ends the acceleration
local pull = motion.def { { ay = 1, over = 9 } }
local b = bullet.fire { kind = 'dot', x = 100, y = 100, dir = 0, speed = 2, motion = pull }
wait(2)
b.vx, b.vy = 1, 0
wait(3)
print(b.x, b.y)
local c = bullet.fire { kind = 'dot', x = 100, y = 100, dir = 0, speed = 2, motion = pull }
wait(2)
c.x, c.y = 0, 0
wait(2)
print(c.vx, c.vy)
--> 107.0 103.0
--> 2.0 2.0

--each: a turn that changes evenly
local b = bullet.fire { kind = 'dot', x = 100, y = 100, dir = 0, speed = 0,
  motion = motion.def { { turn = 6, turn_to = 0, over = 4 } } }
local dirs = {}
for i = 1, 5 do
  wait(1)
  dirs[i] = ('%.0f'):format(b.dir)
end
print(table.concat(dirs, ' '))
--> 6 10 12 12 12
local b = bullet.fire { kind = 'dot', x = 100, y = 100, dir = 0, speed = 0,
  motion = motion.def { fine = true, { turn = -3, turn_to = 3, over = 3 } } }
wait(3)
print(('%.3f'):format(b.dir))
--> 0.000

--each: what is fired
show(bullet.fire { kind = 'dot', x = 9, y = 9, vx = 3, vy = -4 })
--> 3 -4, 5 at 306.87
show(bullet.fire { kind = 'dot', x = 9, y = 9, vx = 0.1 })
--> 0.100006 0, 0.100006 at 0
show(bullet.fire { kind = 'dot', x = 9, y = 9, vx = 0, vy = 0 })
--> 0 0, 0 at 90
show(shot.fire { kind = 'shot', x = 9, y = 9, vy = -1 })
--> 0 -1, 1 at 270
show(laser.bolt { kind = 'bolt', x = 9, y = 9, vx = 1, vy = 1, length = 8 })
--> 1 1, 1.41422 at 45
show(bullet.fire { kind = 'dot', x = 9, y = 9, vx = 1.1, vy = 0.7, motion = motion.def { fine = true } })
--> 1.1 0.7, 1.30384 at 32.4712
local b = bullet.fire { kind = 'dot', x = 9, y = 9, vx = 1, vy = 2, delay = 3 }
wait(5)
print(b.x, b.y)
--> 11.0 13.0
for _ = 1, 40 do bullet.fire { kind = 'dot', x = 9, y = 9, dir = 0, speed = 1 } end -- by now it has a plan
show(bullet.fire { kind = 'dot', x = 9, y = 9, vx = 3, vy = -4 })
--> 3 -4, 5 at 306.87
pattern.ring { kind = 'dot', x = 9, y = 9, vx = 0, vy = 2, n = 4, tag = 'ring' }
bullet.each('ring', show)
--> 0 2, 2 at 90
--> -2 0, 2 at 180
--> 0 -2, 2 at 270
--> 2 0, 2 at 0
pattern.stack { kind = 'dot', x = 9, y = 9, vx = 1, speed_to = 3, n = 2, tag = 'stack', each = function(t)
  show(bullet.fire(t))
end }
--> 1 0, 1 at 0
--> 3 0, 3 at 0
bullet.fire { kind = 'dot', x = 99, y = 99, dir = 0, speed = 1,
  motion = motion.def { { emit = { kind = 'dot', vx = 0, vy = 1, tag = 'out' } } } }
wait(1)
bullet.each('out', show)
--> 0 1, 1 at 90

--each: mistakes
bullet.fire { kind = 'dot', x = 9, y = 9, vx = 1, speed = 2 }
--! bullet.fire: `vx` cannot be combined with `speed`
bullet.fire { kind = 'dot', x = 9, y = 9, vy = 1, dir = 2 }
--! bullet.fire: `vy` cannot be combined with `dir`
pattern.fan { kind = 'dot', x = 9, y = 9, vx = 1, n = 2, spread = 9, aim = true }
--! pattern.fan: `vx` cannot be combined with `aim`
pattern.aimed { kind = 'dot', x = 9, y = 9, vx = 1, n = 2, every = 9 }
--! pattern.aimed: `vx` cannot be combined with `aim`
bullet.fire { kind = 'dot', x = 9, y = 9 }
--! bullet.fire: speed: expected a number from -8191 to 8191 px/frame, got nil
bullet.fire { kind = 'dot', x = 9, y = 9, vx = 9000 }
--! bullet.fire: vx: expected a number from -8191 to 8191 px/frame, got 9000
pattern.ring { kind = 'dot', x = 9, y = 9, n = 2 }
--! pattern.ring: speed: expected a number from -8191 to 8191 px/frame, got nil
motion.def { { ax = 1, vx = 2 } }
--! motion.def: step 1: `ax` and `vx` cannot be combined
motion.def { { vx = 1, speed = 2 } }
--! motion.def: step 1: `speed` cannot be combined with `vx`
motion.def { { limit = 3, over = 9 } }
--! motion.def: step 1: `limit` requires `ax` or `ay`
motion.def { { vx = 3, over = forever } }
--! motion.def: step 1: `vx` with `over = forever` never arrives
motion.def { fine = true, { ay = 1, over = 9 } }
--! motion.def: step 1: `ay` cannot be used in a fine motion (this step is always exact)
motion.def { { ax = 1, limit = -1, over = 9 } }
--! motion.def: step 1: limit: expected a number from 0 to 8191 px/frame, got -1
motion.def { { ax = 1, limit = { 3 }, over = 9 } }
--! motion.def: step 1: limit: expected a number or { x, y }
motion.def { { ax = 1, limit = { 3, false }, over = 9 } }
--! motion.def: step 1: limit: expected a number from 0 to 8191 px/frame, got false
motion.def { { ax = 1, max = 3, over = 9 } }
--! motion.def: step 1: unknown argument "max" (did you mean "limit"?)
motion.def { { turn_to = 3, over = 9 } }
--! motion.def: step 1: `turn_to` requires `turn` and `over`
motion.def { { turn = 1, turn_to = 3 } }
--! motion.def: step 1: `turn_to` requires `turn` and `over`
motion.def { { turn = 1, turn_to = 3, over = forever } }
--! motion.def: step 1: `turn_to` with `over = forever` never arrives
motion.def { { emit = { kind = 'dot', vx = 0, dir = 1 } } }
--! motion.def: step 1: emit: `vx` cannot be combined with `dir`
motion.def { { emit = { kind = 'dot' } } }
--! motion.def: step 1: emit: speed: expected a number from -8191 to 8191 px/frame, got nil

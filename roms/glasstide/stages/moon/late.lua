-- stages/moon/late.lua - the moon's last three phases: new, full, and dark.
local by = require "stages/three/by"
local late = {}

-- Its eye opens wide, whatever its phase, while it fires hard.
function late.glare(e, over)
  task.go(function()
    local eye = sprite.put { sprite = "moon_glare", follow = e, layer = "middle" }
    wait(over)
    eye:remove()
  end)
end

-- Slow stars aimed at you, one after another. Keep moving a little to pass them.
function late.stream(e, every, bank)
  while true do
    wait(every)
    bullet.fire { from = e, kind = "star", bank = bank, aim = true, delay = 20,
                  speed = by(1.2, 1.4, 1.5, 1.2) }
  end
end

-- 4. Rings turn while they grow, each with a gap. The next gap is never farther away than a craft
-- can move in time.
local GROW <const> = { easy = 0.8, normal = 0.8, hard = 0.85, abyss = 0.7 }
local SPIN <const> = 0.1
local DOWN_THERE <const> = 176 -- px from its centre to the crafts

local turning = {}
for name, v in pairs(GROW) do
  turning[name] = {}
  for way = -1, 1, 2 do
    turning[name][way] = motion.def { { polar = v, spin = SPIN * way, over = forever } }
  end
end

local function maze_ring(e, at, way, kind, bank)
  local name = board.difficulty()
  local age = DOWN_THERE / GROW[name]
  local n = by(64, 80, 90, 108)
  local gap = by(6, 4, 4, 3)
  for i = 1, n - gap do
    local dir = at - way * SPIN * age + 360 * (i + gap / 2 - 0.5) / n
    bullet.fire { kind = kind, bank = bank, from = e, dir = dir, speed = GROW[name],
                  motion = turning[name][way] }
  end
end

function late.new(e)
  e.picture = "new"
  task.go(late.stream, e, by(113, 18, 12, 14), 3)
  wait(40)
  local at = 90
  for k = 1, forever do
    local way = k % 2 == 0 and 1 or -1
    at = at + rng.number(8, by(14, 19, 22, 19)) *
         (at > 104 and -1 or at < 76 and 1 or (rng.chance(0.5) and 1 or -1))
    maze_ring(e, at, way, by("pellet", "orb", "orb", "orb"), way > 0 and 6 or 7)
    if k % 4 == 0 then
      late.glare(e, 40)
      pattern.aimed { from = e, kind = "needle", bank = 1, speed = 2.2, every = 9, delay = 20,
                      n = by(1, 2, 3, 4) }
    end
    wait(by(48, 28, 26, 28))
  end
end

-- 5. The moon comes down and throws everything it has: bullets placed like the seeds of a
-- sunflower, none next to the previous one. Rings of large bubbles spread between them.
local GOLDEN <const> = 137.508

function late.full(e)
  e.picture = "full"
  e:move { x = 120, y = 114, over = 120, ease = "both" }
  task.go(function()
    local rate = by(0.9, 2.4, 3, 3.4) -- seeds per frame
    local seed = { kind = "pellet", from = e, dir = 0, speed = by(1.1, 1.2, 1.3, 0.9) }
    local owed = 0
    for k = 1, forever do
      owed = owed + rate
      while owed >= 1 do
        owed = owed - 1
        seed.dir = (seed.dir + GOLDEN) % 360
        seed.bank = k % 240 < 120 and 3 or 2
        bullet.fire(seed)
      end
      wait(1)
    end
  end)
  for k = 1, forever do
    wait(by(200, 150, 130, 130))
    pattern.ring { from = e, kind = "bubble", bank = 5, dir = 90 + 13 * k, speed = 1.3,
                   n = by(6, 9, 12, 8) }
  end
end

-- 6. Survive as the sea falls in: walls, then rays, then recalled rings, then walls and arms.
local pulled = {}
for name, v in pairs { easy = 2.4, normal = 2.7, hard = 2.9, abyss = 3.1 } do
  pulled[name] = motion.def { { speed = v, over = 1 }, { speed = 0, over = 150 },
    { bank = 1 }, { wait = 24 }, { go_to = { 120, 100 }, over = 190, ease = "in" }, { die = true } }
end

-- Walls from above, with a gap that swings from side to side.
local function walls(frames, apart)
  local wide = by(6, 6, 5, 5) -- bullets, 14 px apart
  for k = 1, frames // apart do
    local gap = (9 + 5 * angle.sin(53 * k) - wide / 2) // 1
    pattern.line { x = 120, y = -8, kind = "rice", bank = 6, n = 19, width = 252, dir = 90,
                   speed = by(1.2, 1.4, 1.5, 1.4),
                   skip = { gap, gap + wide - 1 } }
    wait(apart)
  end
end

-- Rings that spread, hang, and are pulled back to the moon.
local function recall(e, times)
  for k = 1, times do
    pattern.ring { from = e, kind = "orb", bank = 5, dir = 7 * k,
                   n = by(20, 30, 38, 50),
                   motion = pulled[board.difficulty()], speed = 1 }
    wait(by(68, 54, 46, 46))
  end
end

-- The corona: rotating rays, and rings between them.
local function corona(e, frames)
  local n = by(4, 6, 7, 8)
  local p = player.nearest(e.x, e.y)
  local dir = (p and p.alive and angle.to(e, p) or 90) + 180 / n
  sound.play("charge", { from = e })
  for i = 1, n do
    laser.beam { kind = "ray", bank = 3, follow = e, dir = dir + 360 * i / n, length = 380,
                 warn = 60, hold = frames - 90, fade = 20,
                 spin = by(0.12, 0.17, 0.2, 0.14) }
  end
  wait(70)
  sound.play("beam", { from = e })
  for k = 1, (frames - 100) // 48 do
    pattern.ring { from = e, kind = "pellet", bank = 7, dir = 11 * k, speed = 1.2,
                   n = by(17, 28, 34, 46) }
    wait(48)
  end
  wait(30)
end

-- Rain that never stops; each drop falls as far as possible from those before.
local function rain()
  local rate = by(0.36, 0.3, 0.32, 0.55) -- drops per frame
  local drop = { kind = "petal", bank = 3, y = -10, dir = 90 }
  local owed, fallen = 0, 0
  for k = 1, forever do
    owed = owed + rate * math.min(1, 0.6 + k / 2400)
    while owed >= 1 do
      owed, fallen = owed - 1, fallen + 1
      drop.x = -4 + 248 * (0.618034 * fallen % 1)
      drop.speed = by(0.9, 0.8, 0.8, 0.7) + 0.1 * (fallen % 3)
      bullet.fire(drop)
    end
    wait(1)
  end
end

function late.eclipse(e)
  e.picture = "eclipse"
  screen.flash { over = 40, share = 0.4 }
  wait(50)
  task.go(rain)
  task.go(late.stream, e, by(120, 14, 10, 9), 2)
  walls(560, by(80, 64, 54, 50))
  wait(60)
  corona(e, 640)
  recall(e, 8)
  wait(150)
  task.go(walls, 900, by(120, 100, 90, 90))
  pattern.spiral { from = e, kind = "orb", bank = 2, n = forever, step = 7,
                   every = by(20, 14, 12, 10),
                   speed = 1.2, arms = by(4, 6, 7, 9) }
end

return late

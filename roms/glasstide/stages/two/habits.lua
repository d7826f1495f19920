-- stages/two/habits.lua - what each creature of the works fires on its
-- path. All are `run` functions, which end with their creature. Creatures
-- close to a craft don't aim at it.
local rank = require "rank"
local ready = require "pose".ready

local habits = {}

local CLOSE <const> = 40 -- px

local function far(e)
  local p = player.nearest(e.x, e.y)
  if not (p and p.alive) then return true end -- the last craft is lost, so none is near
  local dx, dy = p.x - e.x, p.y - e.y
  return dx * dx + dy * dy > CLOSE * CLOSE
end

-- Out, almost to a stop, and on: a ring that breathes.
local breathe = motion.def { { speed = 0.35, over = 40 }, { speed = 1.9, over = 70 } }

-- Teeth of a wheel that opens, turning left or right.
local wheel_left  = motion.def { { polar = 0.95, spin = 0.9, over = 300 } }
local wheel_right = motion.def { { polar = 0.95, spin = -0.9, over = 300 } }

-- Falls faster and faster.
local drip = motion.def { { accel = 0.02, over = 70 } }

-- Steam drifts out to the sides, stops, and sinks.
local sink = motion.def { { speed = 0.12, over = 54 }, { dir = 90 }, { speed = 1.05, over = 50 } }

-- A bar of glass that bounces off the walls.
local rebound = motion.def { { bounce = 1, walls = "left right", { bank = 7 } } }

-- A gob stops and bursts.
local halve = motion.def {
  { speed = 0.3, over = 44 }, { wait = 8 },
  { emit = { pattern = "ring", n = 8, kind = "orb", bank = 5, speed = 1.3 } }, { die = true } }

-- A drone fires a few aimed pellets.
function habits.blink(e)
  ready(e, rng.int(14, 40))
  if not far(e) then return end
  pattern.fan { from = e, kind = "pellet", bank = 7, aim = true, spread = 14,
                speed = rank.faster(1.9), delay = 14,
                n = by_difficulty { easy = 1, normal = 3, abyss = 5 } }
end

-- Drones in the second half fire pellets in a row, like a string of beads.
function habits.beads(e)
  ready(e, rng.int(20, 44))
  if not far(e) then return end
  pattern.stack { from = e, kind = "pellet", bank = 5, aim = true, speed = 1.4, speed_to = 2.4,
                  delay = 14, n = by_difficulty { easy = 1, normal = 3, hard = 4, abyss = 6 } }
end

-- A bottle fires its cork straight ahead; on abyss its contents follow.
function habits.cork(e)
  ready(e, 40)
  if not far(e) then return end
  pattern.fan { from = e, dy = 12, kind = "kunai", bank = 5, spread = 34, dir = 90,
                speed = rank.faster(2.1), delay = 10,
                n = by_difficulty { easy = 1, normal = 1, hard = 3, abyss = 3 } }
  if by_difficulty { easy = false, abyss = true } then
    ready(e, 30)
    pattern.ring { from = e, kind = "orb", bank = 6, n = 6, speed = 1 }
  end
end

-- Bottles in the street are shaken: they fire one aimed cork after another.
function habits.shaken(e)
  ready(e, 40)
  for _ = 1, by_difficulty { easy = 1, normal = 3, hard = 4 } do
    if not far(e) or e.y > 200 then return end
    pattern.fan { from = e, dy = 12, kind = "kunai", bank = 5, aim = true, spread = 40,
                  speed = rank.faster(1.9), delay = 14, n = by_difficulty { easy = 1, hard = 3 } }
    ready(e, rank.sooner(by_difficulty { easy = 50, normal = 26, hard = 28, abyss = 33 }))
  end
end

-- The tongs close: two whips bend towards each other and cross.
function habits.nip(e)
  ready(e, 56)
  for _ = 1, 2 do
    if not far(e) then return end
    for side = -1, 1, 2 do
      pattern.whip { from = e, dx = 9 * side, dy = 12, kind = "rice", bank = 7, speed = 1.3,
                     speed_to = 2.5, dir = 90 - 38 * side, bend = 46 * side,
                     n = by_difficulty { easy = 3, normal = 5, hard = 7, abyss = 9 } }
    end
    ready(e, 58)
  end
end

-- A puffer inflates, and breathes out rings.
function habits.puff(e)
  ready(e, 70)
  for k = 1, forever do
    sound.play("steam", { from = e })
    pattern.ring { from = e, kind = "orb", bank = k % 2 == 0 and 6 or 5, dir = 13 * k, speed = 2.1,
                   motion = breathe,
                   n = by_difficulty { easy = 7, normal = 16, hard = 18, abyss = 26 } }
    ready(e, rank.sooner(by_difficulty { easy = 84, normal = 70, hard = 58, abyss = 52 }))
  end
end

-- The pot runs over on both sides, and every fifth time a whole gob spills.
function habits.spill(e)
  ready(e, 60)
  for k = 1, forever do
    local lean = 34 * angle.sin(31 * k)
    pattern.fan { from = e, dy = -2, kind = "drop", bank = 5, dir = 90 + lean, spread = 96,
                  speed = 0.7,
                  motion = drip, n = by_difficulty { easy = 2, normal = 6, abyss = 7 } }
    if k % 5 == 0 then
      bullet.fire { from = e, dy = 8, kind = "gob", bank = 7, aim = true, speed = 1.8, delay = 20,
                    motion = halve }
    end
    ready(e, rank.sooner(by_difficulty { easy = 44, normal = 18, hard = 17, abyss = 12 }))
  end
end

-- Steam from both ends of the valve forms a bar, which sinks.
function habits.vent(e)
  ready(e, 50)
  while true do
    sound.play("steam", { from = e })
    local n = by_difficulty { easy = 2, normal = 3, hard = 4, abyss = 5 }
    for side = 0, 180, 180 do
      pattern.stack { from = e, dy = 6, kind = "steam", bank = 0, dir = side, speed = 1,
                      speed_to = 2.3, n = n, motion = sink }
    end
    ready(e, rank.sooner(by_difficulty { easy = 110, normal = 60, hard = 52, abyss = 44 }))
  end
end

-- Two wheels on its wings release their teeth, which mesh as they fly.
function habits.mesh(e)
  ready(e, 50)
  for k = 1, forever do
    local n = by_difficulty { easy = 6, normal = 9, hard = 12, abyss = 15 }
    pattern.ring { from = e, dx = -13, kind = "rice", bank = 7, dir = 360 / n * k / 2, speed = 1,
                   n = n,
                   motion = wheel_left }
    pattern.ring { from = e, dx = 13, kind = "rice", bank = 5, dir = 360 / n * k / 2, speed = 1,
                   n = n,
                   motion = wheel_right }
    ready(e, rank.sooner(by_difficulty { easy = 96, normal = 74, hard = 60, abyss = 50 }))
  end
end

-- The kiln opens its door: bars bounce off the walls, and rings come out of the stack.
function habits.bake(e)
  ready(e, 80)
  task.go(function()
    for k = 1, forever do
      pattern.ring { from = e, dy = -20, kind = "steam", bank = 0, dir = 9 * k, speed = 0.9,
                     n = by_difficulty { easy = 6, normal = 9, hard = 12, abyss = 18 } }
      ready(e, rank.sooner(by_difficulty { easy = 120, normal = 90, hard = 76, abyss = 60 }))
    end
  end)
  for k = 1, forever do
    pattern.fan { from = e, dy = 14, kind = "ingot", bank = 6, dir = 90 + 12 * angle.sin(70 * k),
                  spread = 120, speed = 1.9, motion = rebound,
                  n = by_difficulty { easy = 4, normal = 7, hard = 9, abyss = 12 } }
    ready(e, rank.sooner(by_difficulty { easy = 60, normal = 34, hard = 28, abyss = 24 }))
  end
end

-- A gun on a truck fires both barrels, again and again.
function habits.battery(e)
  wait(rng.int(20, 50))
  while true do
    if far(e) and e.y > 0 and e.y < 200 then
      pattern.stack { from = e, kind = "kunai", bank = 5, aim = true, speed = rank.faster(1.7), speed_to = 2.4,
                      delay = 16, n = by_difficulty { easy = 1, normal = 2, hard = 3, abyss = 4 } }
    end
    wait(rank.sooner(by_difficulty { easy = 110, normal = 62, hard = 50, abyss = 40 }))
  end
end

-- A ladle slops over, to the left and to the right.
function habits.slosh(e)
  wait(24)
  for k = 1, forever do
    if e.y > 220 then return end
    pattern.fan { from = e, kind = "drop", bank = 7, dir = k % 2 == 0 and 25 or 155, spread = 70, speed = 1.3,
                  motion = drip, n = by_difficulty { easy = 2, normal = 4, hard = 5, abyss = 7 } }
    wait(rank.sooner(by_difficulty { easy = 70, normal = 40, hard = 32, abyss = 26 }))
  end
end

-- An engine lets off steam.
function habits.stoke(e)
  wait(30)
  for k = 1, forever do
    if e.y < 210 then
      sound.play("steam", { from = e })
      pattern.ring { from = e, kind = "steam", bank = 0, dir = 15 * k, speed = 2, motion = breathe,
                     n = by_difficulty { easy = 7, normal = 12, hard = 16, abyss = 22 } }
    end
    wait(rank.sooner(by_difficulty { easy = 110, normal = 76, hard = 62, abyss = 50 }))
  end
end

return habits

-- stages/habits.lua - what each creature does while it swims its route. All are `run` functions:
-- they end with their creature.
local habits = {}

-- Two ribbons that cross each other as often as they wave.
local ribbon  = motion.def { { wave = 17, every = 84, over = forever } }
local counter = motion.def { { wave = 17, every = 84, phase = 180, over = forever } }

-- Out from a middle that stays, turning about it; after four seconds straight on.
local curl_left  = motion.def { { polar = 1.15, spin = 0.55, over = 240 } }
local curl_right = motion.def { { polar = 1.15, spin = -0.55, over = 240 } }

-- The sides of the sea throw it back, once each way.
local rebound = motion.def { { bounce = 2, walls = "left right", { bank = 3 } } }

-- A few pellets at whoever is near. The mist that they come out of tells where from.
function habits.spit(e)
  wait(rng.int(16, 44))
  pattern.aimed { from = e, kind = "pellet", bank = 5, every = 7, speed = 2, delay = 14,
                  n = by_difficulty { easy = 1, normal = 2, hard = 4 } }
end

-- Drops one after the other, straight down.
function habits.drip(e)
  wait(20)
  while true do
    bullet.fire { from = e, kind = "drop", bank = 5, dir = 90,
                  speed = by_difficulty { easy = 1.4, normal = 1.7, hard = 2.1 } }
    wait(by_difficulty { easy = 44, normal = 30, hard = 20 })
  end
end

-- Fans of rice, twice.
function habits.fan(e)
  wait(62)
  for _ = 1, 2 do
    pattern.fan { from = e, dy = 8, kind = "rice", bank = 1, spread = 56, aim = true, speed = 2,
                  n = by_difficulty { easy = 3, normal = 5, hard = 7 } }
    wait(46)
  end
end

-- Two trails that wind about each other.
function habits.wake(e)
  wait(24)
  while true do
    local speed = by_difficulty { easy = 1.1, normal = 1.4, hard = 1.7 }
    bullet.fire { from = e, dx = -12, kind = "petal", bank = 7, speed = speed, motion = ribbon }
    bullet.fire { from = e, dx = 12, kind = "petal", bank = 6, speed = speed, motion = counter }
    wait(by_difficulty { easy = 15, normal = 10, hard = 7 })
  end
end

-- Rings that open like a flower, to one side and to the other.
function habits.pulse(e)
  wait(80)
  for k = 1, forever do
    local left = k % 2 == 0
    pattern.ring { from = e, kind = "orb", bank = left and 6 or 5, dir = 11 * k, speed = 1.15,
                   n = by_difficulty { easy = 9, normal = 14, hard = 20 },
                   motion = left and curl_left or curl_right }
    wait(by_difficulty { easy = 70, normal = 54, hard = 42 })
  end
end

-- The warm kind of fish fans out in gold, and again.
function habits.gild(e)
  e.bank = 1
  wait(62)
  for i = 1, 3 do
    pattern.fan { from = e, dy = 8, kind = "kunai", bank = 3, spread = 24 * i, aim = true,
                  speed = 2.3, n = by_difficulty { easy = 2, normal = 4, hard = 6 } }
    wait(30)
  end
end

-- Needles in six turning directions.
function habits.bristle(e)
  wait(40)
  local turn = rng.dir()
  while true do
    pattern.ring { from = e, kind = "needle", bank = 3, dir = turn, speed = 1.9,
                   n = by_difficulty { easy = 4, normal = 6, hard = 8 } }
    turn = turn + 17
    wait(by_difficulty { easy = 26, normal = 18, hard = 13 })
  end
end

-- A whorl of stars, with pearls to both sides that come back from the walls.
function habits.whorl(e)
  wait(70)
  task.go(function()
    while true do
      pattern.fan { from = e, kind = "pearl", bank = 2, n = 2, spread = 100, speed = 1.8,
                    motion = rebound }
      wait(by_difficulty { easy = 110, normal = 80, hard = 56 })
    end
  end)
  pattern.spiral { from = e, kind = "star", bank = 4, n = 64, step = 13, every = 5, speed = 1.7,
                   arms = by_difficulty { easy = 2, normal = 3, hard = 4 } }
end

return habits

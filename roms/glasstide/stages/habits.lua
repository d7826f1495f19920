-- stages/habits.lua - what each creature does while it swims its route. All are `run` functions: they end with their creature.
local habits = {}

local curl_left  = motion.def { { turn = 0.9, over = 60 }, { speed = 2.2, over = 40 } }
local curl_right = motion.def { { turn = -0.9, over = 60 }, { speed = 2.2, over = 40 } }
local sink       = motion.def { { speed = 0.5, over = 30 }, { wait = 10 }, { speed = 2.6, over = 40 } }

-- A few pellets at whoever is near.
function habits.spit(e)
  wait(rng.int(16, 44))
  pattern.aimed { from = e, kind = "pellet", bank = 5, n = by_difficulty { easy = 1, normal = 2, hard = 4 }, every = 7, speed = 2 }
end

-- Drops one after the other, straight down.
function habits.drip(e)
  wait(20)
  while true do
    bullet.fire { from = e, kind = "drop", bank = 5, dir = 90, speed = by_difficulty { easy = 1.4, normal = 1.7, hard = 2.1 } }
    wait(by_difficulty { easy = 44, normal = 30, hard = 20 })
  end
end

-- Fans of rice, twice.
function habits.fan(e)
  wait(62)
  for _ = 1, 2 do
    pattern.fan { from = e, dy = 8, kind = "rice", bank = 1, n = by_difficulty { easy = 3, normal = 5, hard = 7 }, spread = 56, aim = true, speed = 2 }
    wait(46)
  end
end

-- Two trails that bend away to both sides.
function habits.wake(e)
  wait(24)
  while true do
    local speed = by_difficulty { easy = 1.1, normal = 1.4, hard = 1.7 }
    bullet.fire { from = e, dx = -14, kind = "petal", bank = 7, dir = 60, speed = speed, motion = curl_left }
    bullet.fire { from = e, dx = 14, kind = "petal", bank = 7, dir = 120, speed = speed, motion = curl_right }
    wait(by_difficulty { easy = 16, normal = 11, hard = 7 })
  end
end

-- Rings that hang for a moment and then fall outward.
function habits.pulse(e)
  wait(80)
  local turn = 0
  while true do
    pattern.ring { from = e, kind = "orb", bank = turn % 2 == 0 and 6 or 5, n = by_difficulty { easy = 10, normal = 16, hard = 24 },
                   dir = 11 * turn, speed = 2.4, motion = sink }
    turn = turn + 1
    wait(by_difficulty { easy = 70, normal = 54, hard = 42 })
  end
end

-- The warm kind of fish fans out in gold, and again.
function habits.gild(e)
  e.bank = 1
  wait(62)
  for i = 1, 3 do
    pattern.fan { from = e, dy = 8, kind = "kunai", bank = 3, n = by_difficulty { easy = 2, normal = 4, hard = 6 }, spread = 24 * i, aim = true, speed = 2.3 }
    wait(30)
  end
end

-- Needles in six turning directions.
function habits.bristle(e)
  wait(40)
  local turn = rng.dir()
  while true do
    pattern.ring { from = e, kind = "needle", bank = 3, n = by_difficulty { easy = 4, normal = 6, hard = 8 }, dir = turn, speed = 1.9 }
    turn = turn + 17
    wait(by_difficulty { easy = 26, normal = 18, hard = 13 })
  end
end

-- A whorl of stars, with pearls for whoever stays in front of it.
function habits.whorl(e)
  wait(70)
  task.go(function()
    while true do
      pattern.aimed { from = e, kind = "pearl", bank = 2, n = 1, every = 0, speed = 1.6 }
      wait(by_difficulty { easy = 110, normal = 80, hard = 56 })
    end
  end)
  pattern.spiral { from = e, kind = "star", bank = 4, n = 64, arms = by_difficulty { easy = 2, normal = 3, hard = 4 }, step = 13, every = 5, speed = 1.7 }
end

return habits

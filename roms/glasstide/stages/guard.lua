-- stages/guard.lua - halfway down: the Chandelier Crab.

-- A bubble slows, bursts, and is a splinter that falls.
local burst = motion.def { name = "burst",
  { speed = 0.2, over = 40 }, { kind = "shard", bank = 5, speed = 0.3 }, { dir = 90 }, { speed = 2.3, over = 50 } }
local snap = motion.def { { wait = 8 }, { speed = 0.8, over = 12 }, { aim = true }, { speed = 3, over = 20 } }

local function claw(e, side)
  local dir = 90 + 60 * side
  while true do
    pattern.fan { from = e, dx = 26 * side, dy = 20, kind = "rice", bank = side < 0 and 6 or 7, n = by_difficulty { easy = 2, normal = 3, hard = 4 },
                  spread = 20, dir = dir, speed = 1.9 }
    dir = dir - 13 * side
    wait(by_difficulty { easy = 9, normal = 6, hard = 5 })
  end
end

local function pincers(e)
  task.go(claw, e, -1)
  task.go(claw, e, 1)
  while true do
    wait(84)
    for side = -1, 1, 2 do
      pattern.line { from = e, dx = 26 * side, dy = 20, kind = "kunai", bank = 2, n = by_difficulty { easy = 3, normal = 5, hard = 7 },
                     width = 40, dir = 90, speed = 2.4, motion = snap }
    end
    e:move { x = rng.int(80, 160), y = rng.int(60, 84), over = 50, ease = "both" }
  end
end

local function chandelier(e)
  local turn = 0
  while true do
    for i = 1, 3 do
      pattern.ring { from = e, kind = "ring", bank = i + 3, n = by_difficulty { easy = 12, normal = 17, hard = 24 }, dir = turn, speed = 1.4 + i,
                     motion = "burst" }
      turn = turn + 9.5
      wait(14)
    end
    pattern.aimed { from = e, kind = "marble", bank = 1, n = by_difficulty { easy = 1, normal = 2, hard = 3 }, every = 24, speed = 2 }
    e:move { x = rng.int(70, 170), y = rng.int(56, 80), over = 50, ease = "both" }
    wait(by_difficulty { easy = 80, normal = 56, hard = 40 })
  end
end

boss.def("guard", { title = "Chandelier Crab", kind = "crab", x = 120, y = 70, phases = {
  { id = "pincers", hp = 900, time = 26 * 60, run = pincers },
  { id = "chandelier", spell = "Shell Sign: Falling Chandelier", hp = 1000, time = 30 * 60, bonus = 20000, run = chandelier } } })

return burst

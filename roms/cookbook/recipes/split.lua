-- split.lua - Split into rings: A large bullet slows down and bursts into a ring, and each bullet
-- in the ring bursts into three. `emit` steps fire the bullets, so hundreds of bursts need no Lua.
local crack = motion.def { { wait = 35 },
  { emit = { pattern = "fan", n = 3, spread = 50, kind = "rice", bank = 3, speed = 1.8 } },
  { die = true } }
local burst = motion.def { { speed = 0.4, over = 50 },
  { emit = { pattern = "ring", n = 12, kind = "orb", bank = 2, speed = 1.3, motion = crack } },
  { die = true } }

return function(e)
  while true do
    pattern.fan { from = e, kind = "big", bank = 1, n = 3, spread = 110, aim = true, speed = 2.6,
                  motion = burst }
    wait(130)
  end
end

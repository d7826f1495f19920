-- fireworks.lua - Fireworks: Rockets rise and burst into rings of two sizes; their sparks slow down
-- and fall. A motion program simulates gravity by pointing the sparks down and accelerating them.
local fall = motion.def { { speed = 0.3, over = 36 }, { dir = 90, bank = 6 },
                          { accel = 0.025, over = 80 } }
local rocket = motion.def { { speed = 0.5, over = 55 },
  { emit = { pattern = "ring", n = 22, kind = "star", bank = 3, speed = 2, motion = fall } },
  { emit = { pattern = "ring", n = 12, kind = "orb", bank = 1, speed = 1.1, motion = fall } },
  { die = true } }

return function()
  for k = 0, forever do
    bullet.fire { kind = "rice", bank = 2, x = 40 + 53 * k % 160, y = 320,
                  dir = 264 + 12 * (k % 2), speed = 7.2, motion = rocket }
    wait(44)
  end
end

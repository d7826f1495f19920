-- spiral.lua - Accelerating spiral: Three arms turn by 11 degrees per shot. Each bullet starts
-- slowly and speeds up, so the arms bend. Every second spiral turns the other way.
local faster = motion.def { { accel = 0.02, over = 120 } }

return function(e)
  for k = 0, forever do
    pattern.spiral { from = e, kind = "drop", bank = 5 + k % 3, n = 60, arms = 3, dir = 40 * k,
                     step = k % 2 == 0 and 11 or -11, every = 2, speed = 0.6, motion = faster }
    wait(30)
  end
end

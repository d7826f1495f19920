-- amulets.lua - Homing amulets: they fan out, slow down, and then turn towards the player by at
-- most two degrees a frame for two seconds. That is few enough to be led past: fly aside late.
local seek = motion.def { { speed = 1.2, over = 25 }, { home = 2, over = 110 },
                          { accel = 0.02, over = 60 } }

return function(e)
  for k = 0, forever do
    for side = -1, 1, 2 do
      pattern.fan { from = e, kind = "knife", bank = 1 + k % 2 * 3, n = 6, spread = 110,
                    dir = 90 + 85 * side, speed = 3.5, motion = seek }
    end
    wait(70)
  end
end

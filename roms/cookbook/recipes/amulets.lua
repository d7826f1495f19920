-- amulets.lua - Homing amulets: Amulets fan out, slow down, and home in on the player for almost
-- two seconds, turning up to two degrees per frame. To dodge the amulets, sidestep at the last
-- moment.
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

-- pinwheel.lua - Pinwheel: Bullets circle the enemy at a growing distance and are released one
-- after another along the tangent. An `orbit` step moves the bullets; when the step ends, they keep
-- their velocity.
local wind_up = motion.def { { orbit = 0, radius_to = 60, spin = 5, over = 50 },
                             { speed = 1.4, over = 20 } }

return function(e)
  for k = 0, forever do
    for i = 0, 29 do
      pattern.ring { kind = "drop", bank = 4 + k % 3, from = e, n = 4, dir = 6 * i, speed = 0,
                     around = e, motion = wind_up }
      wait(3)
    end
    wait(40)
  end
end

-- curve_laser.lua - Curved lasers: The head of a laser flies like a bullet, and the body follows
-- its path. Eight lasers unroll to the left, then eight to the right, and cross like the ribs of a
-- fan.
local unroll = { motion.def { { turn = 1.6, over = 70 }, { turn = -0.4, over = 60 } },
                 motion.def { { turn = -1.6, over = 70 }, { turn = 0.4, over = 60 } } }

return function(e)
  for k = 1, forever do
    pattern.ring { from = e, fire = "curve", kind = "scale", bank = k % 2 == 0 and 4 or 5, n = 8,
                   dir = 22.5 * (k // 2),
                   speed = 2.2, points = 48, motion = unroll[k % 2 + 1] }
    wait(k % 2 == 0 and 100 or 30)
  end
end

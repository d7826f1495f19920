-- bolts.lua - Bouncing bolts: Short lasers fan out and bounce off the sides three times. They grow
-- out of their origin and hit along their full length.
local banks = motion.def { { bounce = 3, walls = "left right", { bank = 2 } } }

return function(e)
  while true do
    for i = 0, 3 do
      for side = -1, 1, 2 do
        laser.bolt { kind = "ray", bank = 5, from = e, dir = 90 + side * (28 + 14 * i), speed = 3,
                     length = 46, width = 8, motion = banks }
      end
      wait(6)
    end
    wait(64)
  end
end

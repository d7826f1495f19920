-- bounce.lua - Bounce once: The sides and the top reflect each bullet once, at the exact point of
-- impact, and change its colour. A green bullet will still bounce; a gold one flies away.
local once = motion.def { { bounce = 1, walls = "left right top", { bank = 3 } } }

return function(e)
  for k = 0, forever do
    pattern.ring { from = e, kind = "orb", bank = 4, n = 24, dir = 7.5 * k, speed = 1.8,
                   motion = once }
    wait(56)
  end
end

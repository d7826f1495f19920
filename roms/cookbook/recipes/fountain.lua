-- fountain.lua - Fountain: Drops rise in a fan and fall back. `ay` is gravity, and `limit` the
-- speed at which they fall in the end. A breeze, `ax`, bends every third jet.
local fall = motion.def { { ay = 0.035, limit = 2.2, over = forever } }
local blown = motion.def { { ax = 0.012, ay = 0.035, limit = 2.2, over = forever } }

return function(e)
  for k = 0, forever do
    pattern.fan { x = 120, y = 250, kind = "drop", bank = 5 + k % 3, n = 7, spread = 50, dir = 270,
                  speed = 3.6 + 0.5 * angle.sin(12 * k), motion = k % 3 == 0 and blown or fall }
    wait(9)
  end
end

-- shield.lua - Shield: Six leaves circle the ship and absorb the bullets they touch. The leaves are
-- harmless bullets that orbit the player, and bullet.meet clears the bullets that touch them.
bullet.def("leaf", { sprite = "petal", hit = { circle = 7 }, turns = true, bank = 4,
                     harmless = true, clearable = false })
bullet.meet("shot_at", "leaf", { clear = "first", spark = "glint" })
local guard = motion.def { { orbit = 0, radius_to = 34, spin = 4, over = 30 },
                           { orbit = 34, spin = 4, over = forever } }

return function(e, p)
  for i = 1, 6 do
    bullet.fire { kind = "leaf", from = p, dir = 60 * i, speed = 0, around = p, motion = guard,
                  tag = "leaf" }
  end
  for k = 0, forever do
    pattern.fan { from = e, kind = "rice", bank = 1, tag = "shot_at", n = 7, spread = 24,
                  aim = true, dir = 8 * (k % 3 - 1), speed = 2 }
    wait(16)
  end
end

-- sines.lua - Sine waves: Streams sway around straight paths. The two streams of a pair have
-- opposite phases, so they braid, and the crossings are never safe.
local left = motion.def { { wave = 22, every = 70, over = forever } }
local right = motion.def { { wave = 22, every = 70, phase = 180, over = forever } }

return function(e)
  for k = 0, forever do
    local lean = 12 * angle.sin(2 * k)
    for i = -2, 2 do
      local dir = 90 + 28 * i + lean
      bullet.fire { kind = "orb", from = e, bank = 5, dir = dir, speed = 1.8, motion = left }
      bullet.fire { kind = "orb", from = e, bank = 7, dir = dir, speed = 1.8, motion = right }
    end
    wait(k % 24 == 23 and 60 or 6)
  end
end

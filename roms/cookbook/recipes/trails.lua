-- trails.lua - Trails: Comets leave stars behind, which hang for a moment and then fly off to both
-- sides. An `emit` step in a loop fires the stars, and a `turn` step points them sideways.
local left = motion.def { { wait = 40 }, { turn = -90 }, { speed = 1.4, over = 20 } }
local right = motion.def { { wait = 40 }, { turn = 90 }, { speed = 1.4, over = 20 } }
local comet = motion.def { { loop = forever,
  { emit = { kind = "star", bank = 3, speed = 0.05, motion = left } }, { wait = 7 },
  { emit = { kind = "star", bank = 2, speed = 0.05, motion = right } }, { wait = 7 } } }

return function(e)
  for k = 0, forever do
    pattern.fan { from = e, kind = "big", bank = 1, n = 4, spread = 120,
                  dir = 90 + 10 * (k % 3 - 1), speed = 2.2, motion = comet }
    wait(110)
  end
end

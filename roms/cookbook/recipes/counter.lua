-- counter.lua - Two spirals: against each other, one turns right and one left, with another step,
-- so their crossings wander and make a lace that never repeats soon. Two tasks are all it takes.
local function arms(e, bank, step)
  pattern.spiral { from = e, kind = "petal", bank = bank, n = forever, arms = 5, step = step,
                   every = 6, speed = 1.5 }
end

return function(e)
  task.go(arms, e, 1, 7)
  wait(3) -- between the other's shots
  arms(e, 6, -9)
end

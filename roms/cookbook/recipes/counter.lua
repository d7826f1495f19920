-- counter.lua - Two spirals: One turns right, the other turns left with a different step, so their
-- crossings wander and form a lace that takes a long time to repeat. Two tasks are enough.
local function arms(e, bank, step)
  pattern.spiral { from = e, kind = "petal", bank = bank, n = forever, arms = 5, step = step,
                   every = 6, speed = 1.5 }
end

return function(e)
  task.go(arms, e, 1, 7)
  wait(3) -- fire between the shots of the other spiral
  arms(e, 6, -9)
end

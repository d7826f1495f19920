-- counter.lua - Two spirals: One spiral turns right and the other left, at different rates, so
-- their crossings wander. The pattern takes a long time to repeat. One task per spiral is enough.
local function arms(e, bank, step)
  pattern.spiral { from = e, kind = "petal", bank = bank, n = forever, arms = 5, step = step,
                   every = 6, speed = 1.5 }
end

return function(e)
  task.go(arms, e, 1, 7)
  wait(3) -- fire between the shots of the other spiral
  arms(e, 6, -9)
end

-- patterns/clockwork.lua - bullets that orbit `e` and fire as they fly: tasks owned by bullets.
local round = motion.def { { orbit = 0, radius_to = 56, spin = 2, over = 45 },
                           { orbit = 56, spin = 2, over = forever } }

return function(e)
  for i = 1, 6 do
    local f = bullet.fire { kind = "big", bank = 2, from = e, dir = 60 * i, speed = 0, around = e, motion = round }
    task.own(f, function()
      wait(60)
      for k = 1, forever do
        pattern.fan { from = f, kind = i % 2 == 0 and "rice" or "shard", bank = i % 2 == 0 and 5 or 7,
                      n = 2, spread = 20, dir = 60 * i + 5 * k, speed = 1.6 }
        wait(9)
      end
    end)
  end
  pattern.spiral { from = e, kind = "pellet", bank = 3, n = forever, arms = 2, step = 17, every = 7, speed = 2.4 }
end

-- stop_and_aim.lua - Stop and re-aim: Rings slow to a stop, turn from blue to red as a warning, aim
-- at the player and fly on. The rings need only one motion program, and no task.
local again = motion.def { { speed = 0, over = 40 }, { bank = 2 }, { wait = 20 },
                           { bank = 1, aim = true }, { speed = 3, over = 20 } }

return function(e)
  for k = 0, forever do
    pattern.ring { from = e, kind = "star", bank = 6, n = 20, dir = 9 * k, speed = 3,
                   motion = again }
    wait(12)
    pattern.ring { from = e, kind = "star", bank = 5, n = 14, dir = 9 * k, speed = 2,
                   motion = again }
    wait(90)
  end
end

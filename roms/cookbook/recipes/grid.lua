-- grid.lua - Named destinations: Each bullet flies to its own place in a grid, then straight down.
-- Each bullet stores its place in `to_x` and `to_y`, so one motion program serves all bullets. A
-- program for each place would fill the pool of motion programs.
value.def("to_x")
value.def("to_y")
local march = motion.def { { go_to = { "to_x", "to_y" }, over = 50, ease = "out" }, { wait = 30 },
                           { dir = 90, bank = 1 }, { speed = 2.2, over = 40 } }

return function(e)
  for k = 0, forever do
    for row = 0, 3 do
      for col = 0, 7 do
        bullet.fire { kind = "star", bank = 5, from = e, speed = 1, motion = march,
                      to_x = 15 + 30 * col + (row + k) % 2 * 15 - 7, to_y = 140 - 26 * row }
      end
      wait(8)
    end
    wait(60)
  end
end

-- butterfly.lua - Butterfly: Arcs open to both sides, and their bullets turn back; the faster ones
-- make wider turns, so the wings open and fold. Each wing has its own motion program.
local wing = { [-1] = motion.def { { turn = -1.4, over = 90 }, { accel = 0.02, over = 60 } },
               [1] = motion.def { { turn = 1.4, over = 90 }, { accel = 0.02, over = 60 } } }

return function(e)
  for k = 0, forever do
    for i = 0, 5 do
      for side = -1, 1, 2 do
        pattern.arc { from = e, kind = "petal", bank = ({ 7, 1, 2, 3, 2, 1 })[i + 1], n = 8,
                      dir = 270 + 20 * side, sweep = 70 * side, speed = 1.1 + 0.22 * i,
                      motion = wing[side] }
      end
      wait(7)
    end
    wait(70)
  end
end

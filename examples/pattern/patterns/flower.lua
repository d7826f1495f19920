-- patterns/flower.lua - a motion program: rings that slow down, curl, and fly off as petals.
motion.def { name = "open", { speed = 0.4, over = 40 }, { kind = "petal", bank = 7 }, { turn = 1.4, over = 60 },
  { speed = 2.4, over = 40 } }

return function(e)
  for i = 1, forever do
    pattern.rose { from = e, kind = "orb", bank = 2, n = 48, petals = 6, dir = 13 * i, speed = 3, speed_to = 1.6,
                   motion = "open" }
    wait(70)
    pattern.aimed { from = e, kind = "kunai", bank = 5, n = 5, every = 4, speed = 3, lock = true }
    wait(30)
  end
end

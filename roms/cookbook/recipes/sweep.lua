-- sweep.lua - Sweeping laser: Dotted lines announce two beams, which then close like a pair of
-- scissors. The beams follow the enemy, turn only after the warning, and leave a way out below.
return function(e)
  for k = 0, forever do
    for side = -1, 1, 2 do
      laser.beam { kind = "shine", bank = 5, follow = e, dir = 90 + 75 * side, spin = -0.45 * side,
                   length = 340, hold = 130 }
    end
    wait(70)
    for _ = 1, 4 do
      pattern.ring { from = e, kind = "orb", bank = 6, n = 18, dir = 10 * k, speed = 1.4 }
      wait(30)
    end
    wait(60)
  end
end

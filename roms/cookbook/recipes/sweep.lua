-- sweep.lua - Sweeping laser: Two beams warn with dotted lines, open, and close like a pair of
-- scissors. They follow the enemy, rotate only after the warning, and leave an exit below.
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

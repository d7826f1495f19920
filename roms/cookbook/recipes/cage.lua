-- cage.lua - Laser cage: Beams close in on both sides of the player and stay, with aimed bullets
-- between them. The warning lasts up to a second, long enough to leave the cage.
return function(e, p)
  while true do
    local x = p.x
    for side = -1, 1, 2 do
      for i = 0, 3 do
        laser.beam { kind = "ray", bank = 2, x = x + side * (36 + 26 * i), y = 0, dir = 90,
                     length = 320, hold = 150,
                     warn = 60 - 10 * i, width = 8 }
      end
    end
    wait(70)
    for i = 1, 5 do
      pattern.stack { from = e, kind = "rice", bank = 1, n = 5, aim = true, dir = 8 * (i % 3 - 1),
                      speed = 1.6, speed_to = 2.8 }
      wait(26)
    end
    wait(50)
  end
end

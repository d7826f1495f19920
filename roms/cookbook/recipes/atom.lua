-- atom.lua - An atom: three ellipses through one middle, tilted by 60 degrees against each other,
-- and a slow ring for the nucleus. Each figure keeps its shape while it grows, so the whole one
-- does.
return function(e)
  for k = 0, forever do
    for i = 0, 2 do
      pattern.ellipse { from = e, kind = "orb", bank = 5 + i, n = 36, speed = 2.1, speed_to = 0.7,
                        dir = 10 * k, tilt = 60 * i }
    end
    wait(16)
    pattern.ring { from = e, kind = "big", bank = 3, n = 9, dir = 20 * k, speed = 1 }
    wait(74)
  end
end

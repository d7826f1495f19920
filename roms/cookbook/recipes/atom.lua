-- atom.lua - Atom: Three ellipses share a centre, each tilted by 60 degrees from the last, and a
-- slow ring is the nucleus. The ellipses and the whole atom keep their shape as they grow.
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

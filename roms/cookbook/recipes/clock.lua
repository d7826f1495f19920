-- clock.lua - Clock: Two laser hands turn without stopping, the long one twelve times as fast, and
-- rings of bullets strike the hours. The hands last until the enemy they follow dies.
return function(e)
  wait_for(e:move { x = 120, y = 140, over = 60, ease = "both" })
  laser.beam { kind = "shine", bank = 3, follow = e, dir = 270, spin = 0.6, length = 260,
               hold = forever, warn = 60 }
  laser.beam { kind = "ray", bank = 2, follow = e, dir = 270, spin = 0.05, length = 150,
               hold = forever, warn = 60 }
  for k = 0, forever do
    wait(50)
    pattern.ring { from = e, kind = "petal", bank = 5, n = 12, dir = 15 * k, speed = 1.3 }
  end
end

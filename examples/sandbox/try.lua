-- try.lua - the place for your example. `e` is a stationary enemy, `p` the first player; the function is a task of `e`.
return function(e, p)
  while true do
    pattern.ring { from = e, kind = "orb", bank = 5, n = 24, dir = rng.dir(), speed = 1.8 }
    wait(40)
    pattern.star { from = e, kind = "star", bank = 3, n = 30, points = 5, aim = true, speed = 1.8 }
    wait(40)
  end
end

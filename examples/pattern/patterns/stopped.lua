-- patterns/stopped.lua - time stops for the bullets while knives appear; then all of them fly.
return function(e, p)
  for k = 1, forever do
    for i = 1, 3 do
      pattern.star { from = e, kind = "star", bank = 3, n = 40, points = 5, inner = 0.45,
                     dir = 12 * (i + k), speed = 2.4 }
      wait(16)
    end
    for i = 1, 10 do
      local a = 36 * i
      bullet.fire { kind = "kunai", bank = 1, x = p.x + 70 * angle.cos(a), y = p.y + 70 * angle.sin(a),
                    dir = a + 90, speed = 1.4 }
      bullet.group().frozen = forever
      wait(4)
    end
    wait(20)
    bullet.group().frozen = 0
    wait(70)
  end
end

-- implosion.lua - Implosion: Bullets converge on a point from all sides, pass through it and spread
-- out again on the other side. The bullets only have to start on a ring and fly inwards.
return function()
  for k = 0, forever do
    local x, y = 120 + 40 * angle.cos(90 * k), 130 + 30 * angle.sin(90 * k)
    for ring = 0, 2 do
      for i = 0, 19 do
        local a = 18 * i + 6 * ring
        bullet.fire { kind = "petal", bank = 7 - ring, x = x + 110 * angle.cos(a),
                      y = y + 110 * angle.sin(a), dir = a + 180 + 8,
                      speed = 1.5, delay = 20 }
      end
      wait(12)
    end
    wait(90)
  end
end

-- polygons.lua - Polygons: A triangle, a square, a pentagon and a hexagon open inside each other
-- and keep their straight sides. Every second set is rotated so that sides replace corners.
return function(e)
  for k = 0, forever do
    for sides = 3, 6 do
      pattern.polygon { from = e, kind = "rice", bank = 9 - sides, n = 12 * sides, sides = sides,
                        speed = 1.8,
                        dir = 90 + 180 / sides * (k % 2) }
      wait(24)
    end
    wait(60)
  end
end

-- corridor.lua - Corridor: Two walls of bullets leave a path that winds down the field. The path is
-- the sum of two sine waves, and each row places its walls next to this path, so the player can
-- read it like a road.
return function()
  for k = 0, forever do
    local way = 120 + 62 * angle.sin(7 * k) + 18 * angle.sin(17 * k)
    for side = -1, 1, 2 do
      for i = 0, 2 do
        bullet.fire { kind = "orb", bank = i == 0 and 3 or 2, x = way + side * (34 + 14 * i),
                      y = -8, speed = 1.9 }
      end
    end
    wait(7)
  end
end

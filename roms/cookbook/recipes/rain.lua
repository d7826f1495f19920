-- rain.lua - Rain: rows of drops fall with a wind that swings. All of a row have one direction, so
-- there is always a lane to follow; chance only says where in the row each of them starts.
return function()
  for k = 0, forever do
    local wind = 18 * angle.sin(1.5 * k)
    for col = 0, 6 do
      bullet.fire { kind = "drop", x = 40 * col + rng.int(-16, 16) - 3 * wind, y = -8,
                    dir = 90 + wind, speed = 2 + col % 2 * 0.4,
                    bank = 5 + col % 2 }
    end
    wait(11)
  end
end

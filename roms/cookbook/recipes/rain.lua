-- rain.lua - Rain: Rows of drops fall in a swinging wind. All drops in a row share one direction,
-- so there is always a lane to follow; only their start positions in the row are random.
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

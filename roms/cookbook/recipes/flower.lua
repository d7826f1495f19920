-- flower.lua - Flower: Four nested roses of five petals, each rotated by half a petal, make a
-- blossom. A rose is one volley whose speed rises and falls with the angle.
return function(e)
  for k = 0, forever do
    for i = 0, 3 do
      pattern.rose { from = e, kind = "petal", n = 60, petals = 5, speed = 2.2 - 0.4 * i,
                     speed_to = 1.2 - 0.25 * i,
                     dir = 270 + 36 * (i + k), bank = i == 3 and 3 or 7 - i % 2 * 6 }
      wait(6)
    end
    wait(80)
  end
end

-- odd_even.lua - Odd and even fans: an odd number of bullets has one that flies at the player, who
-- moves aside; an even number has none, and who moves is hit. Red says move, blue says stay.
return function(e)
  while true do
    for i = 1, 4 do
      pattern.fan { from = e, kind = "knife", bank = 1, n = 7, spread = 90, aim = true,
                    speed = 2 + 0.3 * i }
      wait(10)
    end
    wait(40)
    for i = 1, 4 do
      pattern.fan { from = e, kind = "knife", bank = 6, n = 8, spread = 105, aim = true,
                    speed = 2 + 0.3 * i }
      wait(10)
    end
    wait(40)
  end
end

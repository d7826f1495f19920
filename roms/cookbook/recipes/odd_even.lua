-- odd_even.lua - Odd and even fans: An odd fan aims its middle bullet at the player, so move aside.
-- An even fan aims a gap at the player, so stay where you are. Red means move, blue means stay.
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

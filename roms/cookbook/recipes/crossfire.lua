-- crossfire.lua - Crossfire: Fans from two corners weave a lattice of diamonds; the player flies
-- through its holes. Both corners fire mirrored fans in the same frame, so the fans always line up.
return function()
  for k = 0, forever do
    for i = 0, 4 do
      local lean = 4 * (k % 3) + 0.5 * i
      pattern.fan { x = 0, y = 20, kind = "rice", bank = 4, n = 11, spread = 100, dir = 45 + lean,
                    speed = 1.7 }
      pattern.fan { x = 240, y = 20, kind = "rice", bank = 1, n = 11, spread = 100,
                    dir = 135 - lean, speed = 1.7 }
      wait(14)
    end
    wait(40)
  end
end

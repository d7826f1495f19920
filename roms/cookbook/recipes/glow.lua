-- glow.lua - Bullets of light: with blend = "glow" a picture adds its colours to what lies under
-- it, so where bullets cross it is brightest. rom.lua declares the blend; the kind asks for it.
bullet.def("ember", { sprite = "ember", hit = { circle = 5 }, blend = "glow" })

return function(e)
  sprite.put { sprite = "lamp", follow = e, layer = "back", bank = 1, blend = "glow" }
  for k = 0, forever do
    for side = -1, 1, 2 do
      pattern.ring { from = e, kind = "ember", bank = (k // 2) % 3 + 1, n = 9, dir = 13 * k * side,
                     speed = 1.2 }
    end
    wait(18)
  end
end

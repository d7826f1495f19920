-- glow.lua - Bullets of light: With `blend = "glow"`, a sprite adds its colours to the pixels
-- below, so bullets are brightest where they overlap. rom.lua declares the blend; the kind uses it.
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

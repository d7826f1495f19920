-- knives.lua - Ring of knives: Knives appear around the player one after another, point inwards and
-- strike together, because later knives have shorter delays. The ring has one gap.
return function(_, p)
  for k = 0, forever do
    local x, y = p.x, p.y - 40
    for i = 1, 20 do
      local a = 17 * i + 53 * k
      bullet.fire { kind = "knife", bank = 6, x = x + 92 * angle.cos(a), y = y + 92 * angle.sin(a),
                    dir = a + 180, speed = 3, delay = 3 * (20 - i) + 24 }
      wait(3)
    end
    wait(60)
  end
end

-- slow_field.lua - Slow field: Bullets in the bubble fly at a third of their speed until they leave
-- it. Bullets inside the bubble have a different tag, so each is slowed only once. Only bullets
-- with this tag are checked to see whether they have left the bubble.
local X, Y, R <const> = 120, 200, 64

local function hold_up()
  for _, b in ipairs(query.near { what = "bullet", x = X, y = Y, radius = R, tag = "fast" }) do
    b.speed, b.tag, b.bank = b.speed / 3, "slow", 5
  end
  bullet.each("slow", function(b)
    if (b.x - X) * (b.x - X) + (b.y - Y) * (b.y - Y) > R * R then b.speed, b.tag,
      b.bank = b.speed * 3, "fast", 2 end
  end)
end

return function(e)
  sprite.put { sprite = "lamp", x = X, y = Y, layer = "back", bank = 5, blend = "glow" }
  task.go(function() while true do hold_up() wait(1) end end)
  for k = 0, forever do
    pattern.fan { from = e, kind = "rice", bank = 2, tag = "fast", n = 9, spread = 110,
                  dir = 90 + 9 * angle.sin(40 * k), speed = 2.4 }
    wait(14)
  end
end

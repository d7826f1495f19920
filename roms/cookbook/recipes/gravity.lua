-- gravity.lua - Gravity well: A mass bends the path of every bullet that comes near it. Each frame
-- a task changes the velocity of the bullets close to it; distant bullets cost nothing.
return function(e)
  local well = sprite.put { sprite = "lamp", x = 120, y = 170, layer = "back", bank = 6,
                            blend = "glow" }
  task.go(function()
    while true do
      for _, b in ipairs(query.near { what = "bullet", x = well.x, y = well.y, radius = 70 }) do
        local d = angle.to(b, well)
        b.vx, b.vy = b.vx + 0.03 * angle.cos(d), b.vy + 0.03 * angle.sin(d)
      end
      wait(1)
    end
  end)
  for k = 0, forever do
    pattern.line { x = 120, y = -6, kind = "orb", bank = 4 + k % 3, n = 13, width = 210,
                   speed = 1.6 }
    wait(22)
  end
end

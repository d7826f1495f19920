-- surfacing.lua - Growing and fading in: A jelly rises from the deep: `scale` grows by eighths and
-- `alpha` from nothing to opaque. With `scale_hit`, its hitbox grows with the picture. It is safe
-- until it is complete, then fires, and sinks again.
enemy.def("riser", { sprite = "jelly", hit = { box = { 28, 26 } }, hp = 60, score = 1000,
                     spark = "glint", blink = 4, scale = 0.25, scale_hit = true, alpha = 0,
                     run = function(e)
  e.safe = 84
  for k = 1, 14 do
    e.scale, e.alpha = 0.25 + k / 8, math.min(8, 1 + k // 2)
    wait(6)
  end
  e.alpha = 8
  for k = 1, 3 do
    pattern.ring { from = e, kind = "orb", bank = 6, n = 24, dir = 7 * k, speed = 1.6 }
    wait(24)
  end
  for k = 1, 14 do
    e.scale, e.alpha = 2 - k / 8, 8 - k // 2
    wait(3)
  end
  e:remove()
end })

local function run()
  for i = 0, forever do
    enemy.spawn { kind = "riser", x = 70 + 100 * (i % 2), y = 90 + 20 * (i % 3) }
    wait(110)
  end
end

return { run = run, ship = "gun", alone = true }

-- gauge.lua - Heat gauge: Heat rises with every shot, and drains if the ship doesn't shoot for a
-- third of a second. At the maximum, the gun stops until half the heat is gone. A register counts
-- the heat and is shown as a bar.
player.def("hothead", { sprite = "ship", hit = { circle = 2 },
  registers = { heat = { max = 100, drain = 1, hold = 20, show = "bar" } },
  run = function(p)
    while true do
      if pad.down("fire", p) then
        p.heat = p.heat + 4
        pattern.fan { fire = "shot", from = p, dy = -12, kind = "dart", n = 5, spread = 24,
                      speed = 9,
                      bank = p.heat > 60 and 1 or 0, by = p }
      end
      if p.heat == 100 then
        spark.burst { kind = "glint", from = p, n = 30, speed = 2 }
        wait_until(function() return p.heat <= 50 end)
      end
      wait(5)
    end
  end })

local function run(e)
  for k = 0, forever do
    wait_for(e:move { x = 120 + 60 * angle.sin(90 * k), y = 80, over = 60, ease = "both" })
  end
end

return { run = run, ship = "hothead", hud = true }
